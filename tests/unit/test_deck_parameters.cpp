// Parameters of decks, and the expressions in their fields.

#include "sample_decks.hpp"

namespace dashpad::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// *MAT_057 with curve 31 times a parameter.
const std::string scaled_foam = foam_57 + "*DEFINE_CURVE\n31,,,&scale\n" + rows_31;

std::string local_scale(const char* value) { return fmt::format("*PARAMETER_LOCAL\nRscale{:>14}\n", value); }

TEST_F(DeckTest, LocalParametersAreThoseOfTheirFile) {
  const auto foam_of = [](int id) {
    return fmt::format("*MAT_057\n{0},6e-11,4,{0},,0.1\n5\n*DEFINE_CURVE\n{0},,,&scale\n{1}", id, rows_31);
  };
  folder_.write("a.k", local_scale("2.0") + foam_of(1));
  folder_.write("b.k", local_scale("3.0") + "*INCLUDE\nc.k\n" + foam_of(2));
  folder_.write("c.k", foam_of(3));
  const auto foams = whole("*PARAMETER\nR scale,10\n*INCLUDE\na.k\nb.k\n" + foam_of(4));
  ASSERT_THAT(foams, SizeIs(4));
  EXPECT_THAT(stresses_of(foams[0]), ElementsAre(40e3, 60e3, 220e3));
  EXPECT_DOUBLE_EQ(stresses_of(foams[1])[0], 60e3) << "that of the file which includes it";
  EXPECT_DOUBLE_EQ(stresses_of(foams[2])[0], 60e3);
  EXPECT_DOUBLE_EQ(stresses_of(foams[3])[0], 200e3);
  EXPECT_THAT(faults_of_whole("*INCLUDE\na.k\n" + foam_of(2)),
              ElementsAre("7: SFO = &scale: is not defined by any *PARAMETER in this deck"));
  // One that hides a local one holds in its file and below it; a second one in a file is a fault.
  const auto hidden = whole(local_scale("10") + "*INCLUDE\na.k\nb.k\n" + foam_of(4));
  ASSERT_THAT(hidden, SizeIs(4));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(stresses_of(hidden[i]), stresses_of(foams[i])) << i;
  EXPECT_THAT(faults(local_scale("1") + local_scale("2")), Contains("4: parameter scale: is defined twice"));
}

TEST_F(DeckTest, ParametersInWrongColumnsAreRefused) {
  const auto parameters = [&](const std::string& lines) {
    return faults("*PARAMETER\n" + lines + scaled_foam);
  };
  EXPECT_THAT(parameters("R scale          2.\n"), IsEmpty());
  EXPECT_THAT(parameters("R   scale     6.e-11\n"), IsEmpty());
  EXPECT_THAT(
      parameters("R   scale      6.e-11\n"),
      ElementsAre("2: parameter = 1: must be the type R, I or C and a name; a value before it may be in the "
                  "wrong columns (columns 21 to 30)"));
  EXPECT_THAT(parameters("R   scale        2.  x  other         3.\n"),
              ElementsAre(HasSubstr("parameter = x  other: must be the type R, I or C and a name")));
  EXPECT_THAT(
      parameters("R scale,2,S other,3\n"),
      ElementsAre(
          "2: parameter = S other: must be the type R, I or C and a name; a value before it may be in "
          "the wrong columns"));
  EXPECT_THAT(
      parameters("R sc 1 2.0\nR   scale         2.\n"),
      ElementsAre(HasSubstr("parameter = R sc 1 2.0: must be one name without blanks (columns 1 to 10)")));
  EXPECT_THAT(parameters("C  folderC:/a b, or what\nR   scale         2.\n"), IsEmpty());
  EXPECT_THAT(parameters("C   title a text of any length, and more\nR   scale         2.\n"), IsEmpty());
}

TEST_F(DeckTest, ALineOfParametersWithAFaultCausesNoOther) {
  for (const char* const line : {"R scale 1,2.0", "S scale,2.0", "scale,2.0", "R 5 6,1.0,R scale,2.0"})
    EXPECT_THAT(faults(std::string("*PARAMETER\n") + line + "\n" + scaled_foam),
                ElementsAre(HasSubstr("2: parameter = ")))
        << line;
  // What is defined below holds.
  EXPECT_THAT(faults("*PARAMETER\nS scale,2.0\nR scale,2.0\n" + scaled_foam),
              ElementsAre(HasSubstr("2: parameter = S scale: ")));
}

TEST_F(DeckTest, FunctionsThatAreNotKnownAreNamed) {
  for (const char* const expression : {"int(2.7)+nint(1.5)+max(1,2)", "int(2.7,1)", "2*int(1,\n          2)"})
    for (const char* const name : {"R scale   ", "R scale,"})
      EXPECT_THAT(
          faults(std::string("*PARAMETER_EXPRESSION\n") + name + expression + "\n" + scaled_foam),
          ElementsAre(HasSubstr("uses the function int, which is not supported; those that are: sqrt, exp")))
          << name << expression;
}

TEST_F(DeckTest, ParametersMayBeLongOrGoOn) {
  const auto first = [&](const std::string& parameters) {
    return stresses_of(only(parameters + scaled_foam))[0];
  };
  const std::string in_20 = fmt::format("R {:<18}{:>20}\n", "scale", "2.0");
  EXPECT_DOUBLE_EQ(first("*PARAMETER +\n" + in_20), 40e3);
  EXPECT_DOUBLE_EQ(first("*PARAMETER_MUTABLE\nR scale,2.0\n"), 40e3);
  EXPECT_DOUBLE_EQ(first("*PARAMETER\nR scale,2.0-1\n"), 4e3) << "as Fortran reads it";
  EXPECT_DOUBLE_EQ(first("*PARAMETER_EXPRESSION\nR scale   2.0-1\n"), 20e3);
  EXPECT_DOUBLE_EQ(first("*PARAMETER_EXPRESSION\nR scale   2.0*\n          (1+0.5)\n"), 60e3);
  EXPECT_DOUBLE_EQ(first("*PARAMETER\nR half,0.5\n*PARAMETER_EXPRESSION_LOCAL\nR scale   4*half\n"), 40e3);
}

TEST_F(DeckTest, FieldsOfLsDynaMayHoldExpressions) {
  const std::string parameters = "*PARAMETER\nR lock,0.7,R peak,0.11,I id,31\n";
  const auto found = only(parameters + "*MAT_057\n1,6e-11,4,<id>,,<lock-0.6>\n5\n*DEFINE_CURVE\n" +
                          fmt::format("{:>10}{:>10}{:>10}{:>10}\n", "<id>", "", "", "<2*0.5>") +
                          "-<lock>,-1\n0,0\n0.1,0.02\n0.4,0.03\n<lock>,<peak>\n");
  EXPECT_THAT(stresses_of(found), ElementsAre(20e3, 30e3, 110e3));
  EXPECT_DOUBLE_EQ(std::get<Foam>(found.material.law).unloading_factor, 0.7 - 0.6);
  EXPECT_THAT(
      faults(foam_57 + "*DEFINE_CURVE\n31\n0.1,0.02\n0.4,<gap+0.1>\n0.7,0.11\n"),
      ElementsAre("7: curve 31: O2 = <gap+0.1>: uses gap, which is not defined by any *PARAMETER in this "
                  "deck"));
}

TEST_F(DeckTest, AParameterWithAFaultCausesNoOther) {
  EXPECT_THAT(
      faults("*PARAMETER_EXPRESSION\nR rho     ln(2)\nR twice   2*rho\nR half    1/rho\n"
             "*MAT_063\n1,&twice,&rho,0,31\n" +
             curve_31),
      ElementsAre(
          "2: parameter rho = ln(2): uses the function ln, which is not supported; those that are: sqrt, "
          "exp, log, log10, abs, sin, cos, tan"));
}

std::string abaqus_foam(const std::string& parameters) {
  return "*HEADING\n*PARAMETER\n" + parameters +
         "*MATERIAL, NAME=F\n*DENSITY\n<rho>,\n*HYPERFOAM, N=<terms>\n<mu1>, <2*alpha>, 0\n";
}

TEST_F(DeckTest, ParametersOfAbaqusAreRead) {
  const auto found =
      only(abaqus_foam("# of the foam\nname = 'foam'\nrho = 6.0E-11  # t/mm3\nterms = 3 - 2\nmu1 = 0.5**2 / "
                       "5\nalpha = 6/2.\n#####\n"));
  EXPECT_DOUBLE_EQ(*found.material.density, 60);
  const auto& curve = std::get<HyperfoamCurve>(std::get<Foam>(found.material.law).curves.base);
  EXPECT_DOUBLE_EQ(curve.first_modulus, 0.05e6);
  EXPECT_DOUBLE_EQ(curve.first_exponent, 6);
}

TEST_F(DeckTest, AFaultInAParameterOfAbaqusCausesNoOther) {
  const auto tests = [&](const std::string& parameter, const char* rows) {
    return faults("*PARAMETER\n" + parameter +
                  "\n*MATERIAL, NAME=F\n*LOW DENSITY FOAM\n*UNIAXIAL TEST DATA\n" + rows);
  };
  const char* const in_stress = "0,0,0.01\n<a>,0.2,0.01\n0.2,0.5,0.01\n0.8,0.7,0.01\n";
  const char* const in_rates = "0.1,0.2,<a>\n0.2,0.5,<a>\n0.8,0.7,<a>\n";
  for (const char* const rows : {in_stress, in_rates}) {
    EXPECT_THAT(tests("a=1e400", rows),
                ElementsAre("2: parameter a = 1e400: has a number that is too large: 1e400"));
    EXPECT_THAT(tests("a = 2*1e-400", rows),
                ElementsAre(HasSubstr("has a number that is too small: 1e-400")));
    EXPECT_THAT(tests("a=b\nb=a", rows), ElementsAre(HasSubstr("2: parameter a = b: uses b")));
    EXPECT_THAT(tests("a =", rows), ElementsAre(HasSubstr("2: *PARAMETER = a =: must be a name, =")));
    EXPECT_THAT(tests("a 0.1", rows), ElementsAre(HasSubstr("2: *PARAMETER = a 0.1: must be a name, =")));
  }
  for (const char* const n : {"ln(2)", "1/0"})
    EXPECT_THAT(
        faults(std::string("*PARAMETER\nn = ") + n + "\n*MATERIAL, NAME=F\n*HYPERFOAM, N=<n>\n0.05,6,0\n"),
        ElementsAre(HasSubstr("2: parameter n = ")));
  EXPECT_THAT(
      faults("*MATERIAL, NAME=F\n*HYPERFOAM, N=<n>\n0.05,6,0\n"),
      ElementsAre("2: *HYPERFOAM: N = <n>: uses n, which is not defined by any *PARAMETER in this deck"));
}

TEST_F(DeckTest, WhatPythonComputesOtherwiseIsRefused) {
  const std::string others = "rho = 6e-11\nterms = 1\nmu1 = 0.05\n";
  EXPECT_THAT(
      faults(abaqus_foam(others + "two = 2\nalpha = two*3/2\n")),
      ElementsAre(
          "7: parameter alpha = two*3/2: divides whole numbers, which Abaqus may round down; write one "
          "with a decimal point"));
  EXPECT_THAT(faults(abaqus_foam(others + "alpha = 2^3\n")),
              ElementsAre(HasSubstr("6: parameter alpha = 2^3: has")));
  EXPECT_THAT(faults(abaqus_foam(others + "import math\nalpha = 3\n")),
              ElementsAre("6: *PARAMETER = import math: must be a name, = and a number or an expression"));
  EXPECT_THAT(
      faults(abaqus_foam(others)),
      ElementsAre(HasSubstr("<2*alpha>: uses alpha, which is not defined by any *PARAMETER in this deck")));
}

TEST_F(DeckTest, ParametersOfRadiossAreRead) {
  const std::string foam = "/MAT/LAW33/7\nFoam\n" + fields_of_20({"&RHO"}) +
                           "                &MOD         0   &FCT_ID                   0\n\n" +
                           fields_of_20({"0"}) + function_8;
  const auto parameter = [](const char* range, const char* type, const std::string& lines) {
    return fmt::format("/PARAMETER/{}/{}/1\n\n{}", range, type, lines);
  };
  const std::string number = parameter("GLOBAL", "INTEGER", "FCT_ID             8\n"),
                    density = parameter("GLOBAL", "REAL", "RHO                      9E-11\n"),
                    modulus = parameter("GLOBAL", "REAL_EXPR", "MOD       2.0*\n          (FCT_ID+2)\n");
  const auto found = only(number + density + modulus + foam);
  EXPECT_EQ(*found.material.density, 90);
  EXPECT_DOUBLE_EQ(std::get<CrushableFoam>(found.material.law).unloading_modulus, 20e6);
  EXPECT_THAT(
      faults(number + parameter("LOCAL", "REAL", "RHO                      9E-11\n") + modulus + foam),
      ElementsAre(
          HasSubstr("/MAT/LAW33: RHO_I = &RHO: is not defined by any /PARAMETER/GLOBAL in this deck")));
}

TEST_F(DeckTest, WholeParametersAreNotCutOff) {
  const auto of_ls_dyna = [&](const std::string& parameter) { return faults(parameter + scaled_foam); };
  EXPECT_THAT(of_ls_dyna("*PARAMETER\nI scale,1.5\n"),
              ElementsAre("2: parameter scale = 1.5: must be a whole number, not 1.5"));
  EXPECT_THAT(of_ls_dyna("*PARAMETER_EXPRESSION\nI scale   7/2.0\n"),
              ElementsAre("2: parameter scale = 7/2.0: must be a whole number, not 3.5"));
  for (const char* const whole :
       {"*PARAMETER\nI scale,2.0\n", "*PARAMETER_EXPRESSION\nI scale   0.29*100-27\n"})
    EXPECT_DOUBLE_EQ(stresses_of(only(whole + scaled_foam))[0], 40e3) << whole;
  const std::string foam = "/MAT/LAW33/7\nFoam\n" + fields_of_20({"9E-11"}) +
                           "                  20         0   &FCT_ID                   0\n\n" +
                           fields_of_20({"0"}) + function_8;
  EXPECT_THAT(faults("/PARAMETER/GLOBAL/INTEGER/1\n\nFCT_ID           8.7\n" + foam),
              ElementsAre("3: parameter fct_id = 8.7: must be a whole number, not 8.7"));
}

}  // namespace
}  // namespace dashpad::test
