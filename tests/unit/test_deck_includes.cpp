// Files that a deck includes, and what is said of those that are not read.

#include "sample_decks.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const std::string hyperfoam = "*MATERIAL, NAME=F\n*HYPERFOAM, N=1\n0.03,6,0\n";

TEST_F(DeckTest, SeveralNamesBelowOneIncludeAreRead) {
  folder_.write("foam.k", "*KEYWORD\n" + foam_57 + "*END\nnot read\n");
  folder_.write("parts/curve.k", curve_31);
  folder_.write("more.k", "*KEYWORD\n");
  const auto foams =
      whole("*KEYWORD\n*INCLUDE\n$#  filename\n  foam.k   \n\nparts/ +\ncurve +\n.k\nmore.k\n*END\n");
  ASSERT_THAT(foams, SizeIs(1));
  EXPECT_THAT(stresses_of(foams[0]), ElementsAre(20e3, 30e3, 110e3));
  EXPECT_EQ(foams[0].line, 2);
  // An encrypted part is no name.
  EXPECT_THAT(
      faults_of_whole("*KEYWORD\n*INCLUDE\nfoam.k\n-----BEGIN PGP MESSAGE-----\nhQEM\n"),
      ElementsAre(HasSubstr("foam.k:3: *MAT_057: LCID = 31: part of the deck is encrypted, from line 4 of "
                            "deck.k on")));
}

TEST_F(DeckTest, AbaqusNamesAnIncludedFileInAnyPlaceOfTheKeyword) {
  folder_.write("foam.inp", hyperfoam);
  for (const char* const statement :
       {"*INCLUDE, INPUT=foam.inp", "*INCLUDE , INPUT = foam.inp", "*Include, input=\"foam.inp\"",
        " *INCLUDE, SHIFT=0, INPUT=foam.inp", "*INCLUDE,\n  INPUT=foam.inp"})
    EXPECT_THAT(whole(std::string("*HEADING\n") + statement + "\n"), SizeIs(1)) << statement;
  EXPECT_THAT(faults_of_whole("*HEADING\n*INCLUDE, SHIFT=0\n"),
              ElementsAre("2: include: is not the name of a file"));
}

TEST_F(DeckTest, RadiossIncludesEndAtEnddata) {
  const std::string old = "/FUNCT/8\nold\n" + fields_of_20({"-0.5", "9"});
  for (const char* const end : {"#enddata", "#ENDDATA", "/END"}) {
    folder_.write("foam.inc", foam_33() + function_8 + end + "\n" + old);
    for (const char* const statement : {"#include foam.inc", "#include\tfoam.inc", "#INCLUDE  \"foam.inc\""})
      EXPECT_THAT(whole(std::string("#RADIOSS STARTER\n") + statement + "\n/END\n"), SizeIs(1))
          << end << statement;
  }
  EXPECT_EQ(faults(foam_33() + function_8 + "#enddata\n" + old), std::vector<std::string>{});
}

TEST_F(DeckTest, AnEncryptedIncludeIsRefusedWithoutItsPassword) {
  folder_.write("foam.inp", hyperfoam);
  const auto read =
      reading("*HEADING\n*INCLUDE, INPUT=foam.inp, Password=secret\n", "t-mm-s", input::Includes::allowed);
  ASSERT_THAT(read.faults(), SizeIs(1));
  const std::string shown = with_excerpt(read.faults().front());
  EXPECT_THAT(shown, AllOf(HasSubstr(":2: include = foam.inp: is encrypted (it needs a PASSWORD)"),
                           HasSubstr("*INCLUDE, INPUT=foam.inp, PASSWORD=..."), Not(HasSubstr("secret"))));
}

TEST_F(DeckTest, EachNameThatCannotBeReadHasItsReason) {
  const auto reason = [&](const std::string& name) { return faults_of_whole("*INCLUDE\n" + name + "\n"); };
  EXPECT_THAT(reason(".\\parts\\a.k"),
              ElementsAre("2: include = .\\parts\\a.k: contains a backslash; write the name with / instead"));
  EXPECT_THAT(reason("C:/a.k"), ElementsAre(HasSubstr("must be in the folder of the deck, or below it")));
  EXPECT_THAT(reason("missing.k"), ElementsAre("2: include = missing.k: no such file"));
  folder_.write("binary.k", std::string("*KEYWORD\n\0", 10));
  EXPECT_THAT(reason("binary.k"), ElementsAre(HasSubstr("is not text: it contains the byte 0")));
  EXPECT_THAT(
      faults_of_whole("*INCLUDE_PATH_RELATIVE\nsub\n*INCLUDE\nmissing.k\n"),
      ElementsAre("4: include = missing.k: no such file; the folders of *INCLUDE_PATH are not searched"));
  std::string many = "*INCLUDE\n";
  for (int i = 0; i < 300; ++i) many += fmt::format("missing-{}.k\n", i);
  EXPECT_THAT(faults_of_whole(many), SizeIs(100));
}

TEST_F(DeckTest, FaultsOfIncludedFilesNameThemAndShowTheirLine) {
  folder_.write("parts/control.k", "*CONTROL_ALE\n1\n*INCLUDE\nmissing.k\n");
  const auto missing = reading("*KEYWORD\n*TITLE\nFoam\n*INCLUDE\nparts/control.k\n" + foam_57, "t-mm-s",
                               input::Includes::allowed);
  ASSERT_THAT(missing.faults(), SizeIs(1));
  EXPECT_EQ(missing.faults().front().line, 4);
  EXPECT_EQ(missing.faults().front().excerpt.line, "missing.k");

  folder_.write("a.k", "$\n" + curve_31);
  folder_.write("b.k", "$\n$\n" + curve_31);
  EXPECT_THAT(faults_of_whole(foam_57 + "*INCLUDE\na.k\nb.k\n"),
              ElementsAre("b.k:3: curve 31: is defined twice, first on line 2 of a.k"));
  EXPECT_THAT(faults_of_whole(foam_57 + curve_31 + "*INCLUDE\na.k\n"),
              ElementsAre("a.k:2: curve 31: is defined twice, first on line 4 of deck.k"));
}

TEST_F(DeckTest, AFileThatIsIncludedTwiceIsOneFault) {
  folder_.write("parts/c.k", "$\n*PARAMETER\nR gap,0.1\n" + curve_31 + "*DEFINE_CURVE\n32\n" + rows_31);
  for (const char* const again : {"parts/c.k", "./parts/c.k"})
    EXPECT_THAT(faults_of_whole(foam_57 + "*INCLUDE\nparts/c.k\n" + again + "\n"),
                ElementsAre(HasSubstr(
                    "parts/c.k:4: curve 31: is defined twice because parts/c.k is included twice")));
  // Without numbers of its own, nothing is there twice.
  folder_.write("gap.k", "*PARAMETER\nR gap,0.1\n");
  EXPECT_THAT(faults_of_whole(foam_57 + curve_31 + "*INCLUDE\ngap.k\ngap.k\n"), IsEmpty());
}

TEST_F(DeckTest, IncludesThatAreNotReadAreNamed) {
  const std::string hint = "; *INCLUDE files are read only with --allow-includes";
  EXPECT_THAT(faults("*KEYWORD\n*INCLUDE\na.k\n*END\n"),
              ElementsAre(AllOf(HasSubstr("contains no *MAT_057"), HasSubstr(hint))));
  EXPECT_THAT(faults(foam_57 + "*INCLUDE\na.k\n"),
              ElementsAre(HasSubstr("there is no *DEFINE_CURVE 31" + hint)));
  for (const std::string& deck :
       {std::string("*HEADING\n*INCLUDE, INPUT=a.inp\n"), std::string("*INCLUDE, INPUT=a\n")})
    EXPECT_THAT(faults(deck), ElementsAre(AllOf(HasSubstr("contains no Abaqus"), HasSubstr(hint))));
  for (const std::string& deck : {std::string("/BEGIN\n#include a.inc\n"), std::string("#include a.inc\n")})
    EXPECT_THAT(faults(deck),
                ElementsAre(AllOf(HasSubstr("contains no /MAT/LAW33"),
                                  HasSubstr("; #include files are read only with --allow-includes"))));
  for (const auto includes : {input::Includes::allowed, input::Includes::ignored}) {
    EXPECT_THAT(
        faults("*INCLUDE_TRANSFORM\na.k\n1,1,1\n" + foam_57, "t-mm-s", includes),
        ElementsAre("5: *MAT_057: LCID = 31: there is no *DEFINE_CURVE 31; *INCLUDE_TRANSFORM is not read"));
    EXPECT_THAT(faults("*INCLUDE_NASTRAN\na.k\n", "t-mm-s", includes),
                ElementsAre(HasSubstr("; *INCLUDE_NASTRAN is not read")));
  }
  EXPECT_THAT(faults("*KEYWORD\n-----BEGIN PGP MESSAGE-----\nhQEM\n"),
              ElementsAre(HasSubstr("; part of it is encrypted, from line 2 on")));
}

}  // namespace
}  // namespace dashpad::test
