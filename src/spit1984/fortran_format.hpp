#pragma once
/// The parts of Fortran's FORMAT that the 1984 program uses, as the run-time system of its machine (FOROTS of
/// the DECSystem-10) carried them out.

#include <optional>
#include <string>
#include <string_view>

namespace dashpad::spit1984 {

/// Ew.d: "0.353E+03" right-aligned. At least one decimal. A tie of the exact value rounds away from zero;
/// from 1E+100 on the exponent has three digits and no E, "0.100+100". Where the field is too narrow the zero
/// before the point goes; if that is not enough, the field is all asterisks. Infinities and NaN, which the
/// machine did not have, are printed as words.
std::string edit_e(double value, int width, int decimals);

/// Iw: right-aligned, or asterisks.
std::string edit_i(int value, int width);

/// What WRITE statements send to a printing device. A FORMAT is a chain of calls, one a descriptor:
/// FORMAT(8H0RADIUS=,12X,E10.3/) is text("0RADIUS=").skip(12).e(radius, 10, 3).end_record().end_record().
class PrintedRecords {
 public:
  PrintedRecords& text(std::string_view text);               ///< nH... or '...'
  PrintedRecords& skip(int columns);                         ///< nX
  PrintedRecords& e(double value, int width, int decimals);  ///< Ew.d
  PrintedRecords& i(int value, int width);                   ///< Iw

  /// A slash, or the end of the FORMAT. The first character of the record is carriage control: '1' begins a
  /// new page (a form feed, but for the very first line, when the paper is at the top of a page already), '0'
  /// leaves a line empty, anything else just begins a line. An empty record is an empty line. Nothing else is
  /// trimmed.
  PrintedRecords& end_record();

  /// A dollar sign at the end of the FORMAT: as end_record(), but the cursor stays on the line.
  PrintedRecords& end_record_on_the_line();

  /// Everything up to the last end of a record.
  [[nodiscard]] const std::string& printed() const { return printed_; }

 private:
  std::string record_;
  std::string printed_;
};

/// The fields of one line that was typed, from left to right. A field that is not a number is absent, and so
/// is one too large or too small for the type; what is missing at the end of the line is blank, hence zero.
///
/// The rules are those of the FORTRAN-10 manual as far as we know them. Two are our choice: blanks inside a
/// field of given width do not count (the rule of FORTRAN-77; in FORTRAN-66 they were zeros, and "20 " was
/// 200), and a comma does not end such a field.
class TypedRecord {
 public:
  explicit TypedRecord(std::string_view line) : rest_(line) {}

  std::optional<int> i();              ///< I without width: up to a blank or a comma
  std::optional<double> e(int width);  ///< Ew.0: the next `width` characters: 20, .1, 1.5E1, 1.5D1, 1.5+1
  std::optional<double> f();           ///< F without width: up to a blank or a comma; numbers as in e()

 private:
  std::string_view free_field();

  std::string_view rest_;
};

}  // namespace dashpad::spit1984
