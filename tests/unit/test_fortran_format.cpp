// Fortran's editing: what the printer got for a number, and which number a typed field was.

#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "spit1984/fortran_format.hpp"

namespace dashpad::spit1984 {
namespace {

TEST(FortranE, PrintsTheFractionBehindThePoint) {
  EXPECT_EQ(edit_e(352.8, 10, 3), " 0.353E+03");
  EXPECT_EQ(edit_e(-90.8, 10, 3), "-0.908E+02");
  EXPECT_EQ(edit_e(9.76e-6, 15, 3), "      0.976E-05");
  EXPECT_EQ(edit_e(0.1, 10, 3), " 0.100E+00");
  EXPECT_EQ(edit_e(1, 10, 3), " 0.100E+01");
  EXPECT_EQ(edit_e(1e10, 10, 3), " 0.100E+11");
}

TEST(FortranE, PrintsZeroWithoutASign) {
  EXPECT_EQ(edit_e(0.0, 10, 3), " 0.000E+00");
  EXPECT_EQ(edit_e(-0.0, 10, 3), " 0.000E+00");
}

// Each of these is exact in binary; printf would round the first and the third to even.
TEST(FortranE, RoundsTiesAwayFromZero) {
  EXPECT_EQ(edit_e(0.0625, 10, 2), "  0.63E-01");
  EXPECT_EQ(edit_e(0.1875, 10, 3), " 0.188E+00");
  EXPECT_EQ(edit_e(-112.5, 10, 3), "-0.113E+03");
  EXPECT_EQ(edit_e(113.5, 10, 3), " 0.114E+03");
}

// 0.10005 and 1.005 only look like ties: the doubles lie above the one and below the other.
TEST(FortranE, RoundsTheExactValueAndNotItsShortName) {
  EXPECT_EQ(edit_e(0.10005, 11, 4), " 0.1001E+00");
  EXPECT_EQ(edit_e(1.005, 10, 3), " 0.100E+01");
  EXPECT_EQ(edit_e(0.12349999999999999, 10, 3), " 0.123E+00");
}

TEST(FortranE, CarriesIntoTheExponent) {
  EXPECT_EQ(edit_e(0.9996, 10, 3), " 0.100E+01");
  EXPECT_EQ(edit_e(0.9994, 10, 3), " 0.999E+00");
  EXPECT_EQ(edit_e(-99.95, 10, 3), "-0.100E+03");
  EXPECT_EQ(edit_e(0.09996, 10, 3), " 0.100E+00");
  EXPECT_EQ(edit_e(129.96, 10, 4), "0.1300E+03");
}

TEST(FortranE, DropsTheLetterForAnExponentOfThreeDigits) {
  EXPECT_EQ(edit_e(1e98, 10, 3), " 0.100E+99");
  EXPECT_EQ(edit_e(1e99, 10, 3), " 0.100+100");
  EXPECT_EQ(edit_e(-1.234e-101, 10, 3), "-0.123-100");
  EXPECT_EQ(edit_e(std::numeric_limits<double>::max(), 10, 3), " 0.180+309");
  EXPECT_EQ(edit_e(std::numeric_limits<double>::denorm_min(), 10, 3), " 0.494-323");
}

TEST(FortranE, DropsTheZeroAndThenGivesUpInANarrowField) {
  EXPECT_EQ(edit_e(1.5, 9, 3), "0.150E+01");
  EXPECT_EQ(edit_e(1.5, 8, 3), ".150E+01");
  EXPECT_EQ(edit_e(-1.5, 9, 3), "-.150E+01");
  EXPECT_EQ(edit_e(-1.5, 8, 3), "********");
}

TEST(FortranE, PrintsWhatThe36BitMachineDidNotHaveAsWords) {
  EXPECT_EQ(edit_e(std::numeric_limits<double>::quiet_NaN(), 10, 3), "       NaN");
  EXPECT_EQ(edit_e(-std::numeric_limits<double>::infinity(), 10, 3), " -Infinity");
}

TEST(FortranI, AlignsToTheRightOrGivesUp) {
  EXPECT_EQ(edit_i(5, 5), "    5");
  EXPECT_EQ(edit_i(-12, 5), "  -12");
  EXPECT_EQ(edit_i(99999, 5), "99999");
  EXPECT_EQ(edit_i(100000, 5), "*****");
}

TEST(PrintedRecords, DoWhatTheFirstCharacterSays) {
  PrintedRecords records;
  records.text("1TITLE").end_record().end_record();
  records.text(" PLAIN").end_record().text("0APART").end_record().text("1NEXT PAGE").end_record();
  EXPECT_EQ(records.printed(), "TITLE\n\nPLAIN\n\nAPART\n\fNEXT PAGE\n");
}

TEST(PrintedRecords, KeepTrailingBlanks) {
  EXPECT_EQ(PrintedRecords{}.skip(3).text("A ").i(7, 2).skip(2).end_record().printed(), "  A  7  \n");
}

TEST(PrintedRecords, MayKeepTheCursorOnTheLine) {
  PrintedRecords records;
  records.end_record().skip(1).text("SPEED: ").end_record_on_the_line();
  EXPECT_EQ(records.printed(), "\nSPEED: ");
  EXPECT_EQ(PrintedRecords{}.text(" NOT YET ENDED").printed(), "");
}

std::optional<double> typed_e(const char* line) { return TypedRecord{line}.e(10); }

TEST(TypedE, TakesEverySpellingOfANumber) {
  EXPECT_EQ(typed_e("20"), 20);
  EXPECT_EQ(typed_e("20."), 20);
  EXPECT_EQ(typed_e(".1"), 0.1);
  EXPECT_EQ(typed_e("+0.1"), 0.1);
  EXPECT_EQ(typed_e("-2.5"), -2.5);
  EXPECT_EQ(typed_e("1.5E1"), 15);
  EXPECT_EQ(typed_e("1.5e+01"), 15);
  EXPECT_EQ(typed_e("15D-1"), 1.5);
  EXPECT_EQ(typed_e("1.5+1"), 15);
  EXPECT_EQ(typed_e("-1.5-1"), -0.15);
}

TEST(TypedE, TakesABlankFieldAsZero) {
  EXPECT_EQ(typed_e(""), 0);
  EXPECT_EQ(typed_e("   "), 0);
  EXPECT_EQ(typed_e("\r"), 0);
}

TEST(TypedE, IgnoresBlanksInTheField) {
  EXPECT_EQ(typed_e("  20"), 20);
  EXPECT_EQ(typed_e("20  "), 20);
  EXPECT_EQ(typed_e("2 0"), 20);
  EXPECT_EQ(typed_e("\t20\r"), 20);
}

TEST(TypedE, LooksAtTenCharactersOnly) {
  EXPECT_EQ(typed_e("12345678901234"), 1234567890);
  EXPECT_EQ(typed_e("20        mph"), 20);
}

TEST(TypedE, RefusesWhatIsNotANumber) {
  for (const char* line :
       {"abc", "20 mph", "1.2.3", "+",   "-",   ".",   "E5",   "+-1",  "--1",   "-+1",
        "1E",  "1++2",   "1-2-3", "1,5", "inf", "nan", "-inf", "0x10", "1e999", "\xc2\xbd"})
    EXPECT_EQ(typed_e(line), std::nullopt) << line;
}

TEST(TypedI, EndsAtABlankOrAComma) {
  EXPECT_EQ(TypedRecord{"5"}.i(), 5);
  EXPECT_EQ(TypedRecord{"  +10 steps"}.i(), 10);
  EXPECT_EQ(TypedRecord{"-3,4"}.i(), -3);
  EXPECT_EQ(TypedRecord{""}.i(), 0);
}

TEST(TypedI, RefusesWhatIsNotAWholeNumber) {
  for (const char* line : {"five", "5.", "1E1", "2.5", "+", "99999999999"})
    EXPECT_EQ(TypedRecord{line}.i(), std::nullopt) << line;
}

TEST(TypedF, TakesFieldsOneAfterTheOther) {
  for (const char* line : {"0.1,900", "0.1 900", " .1 , 9E2 ", "0.1,\t900\r", "0.1   900 1800"}) {
    TypedRecord record{line};
    EXPECT_EQ(record.f(), 0.1) << line;
    EXPECT_EQ(record.f(), 900) << line;
  }
}

TEST(TypedF, TakesAMissingFieldAsZero) {
  TypedRecord two{"0.1,,900"};
  EXPECT_EQ(two.f(), 0.1);
  EXPECT_EQ(two.f(), 0);
  EXPECT_EQ(two.f(), 900);
  EXPECT_EQ(two.f(), 0);
}

TEST(TypedF, RefusesWhatIsNotANumber) {
  TypedRecord record{"0.1;900 x"};
  EXPECT_EQ(record.f(), std::nullopt);
  EXPECT_EQ(record.f(), std::nullopt);
}

}  // namespace
}  // namespace dashpad::spit1984
