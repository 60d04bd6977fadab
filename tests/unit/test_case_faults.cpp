/// Case files: what is said about each kind of bad one.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "sample_case.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using input::Fault;
using test::edited;
using test::good_case;
using test::in_line_material;
using test::materials;
using test::read;

std::vector<Fault> faults_in(const std::function<void()>& action) {
  try {
    action();
  } catch (const input::InputError& error) {
    return error.faults();
  }
  return {};
}

std::string all(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += to_string(fault) + "\n";
  return text;
}

/// A fault that is expected: its line, key, and part of its rule.
struct Expected {
  int line;
  std::string key;
  std::string rule;
};

void expect_faults(const std::vector<Fault>& faults, const std::vector<Expected>& expected) {
  ASSERT_EQ(faults.size(), expected.size()) << all(faults);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    EXPECT_EQ(faults[i].line, expected[i].line) << all(faults);
    EXPECT_EQ(faults[i].key, expected[i].key) << all(faults);
    EXPECT_NE(faults[i].rule.find(expected[i].rule), std::string::npos) << all(faults);
  }
}

struct Edit {
  std::string from;
  std::string to;
  std::vector<Expected> faults;
};

const std::string curve_of = "type = \"curve\"\npoints = ";
const std::string linear_support = "type = \"linear\"\nstiffness = \"600 lbf/in\"";
const std::string named_material = "material = \"ensolite-aac-9\"";
const std::string law_of = "law = \"elastic\"\n[pad.parameters]\nmodulus = ";

const std::string radius = "radius = \"3 in\"";
const std::string cone_of = "nose = \"cone\"\nradius = \"3 in\"\nhalf_angle = ";

const std::string profile_of = "nose = \"profile\"";

const std::vector<Edit> edits{
    // Quantities.
    {"\"20 mph\"", "\"20\"", {{5, "impactor.speed", "a speed needs a unit, as in \"20 m/s\""}}},
    {"\"20 mph\"", "20", {{5, "impactor.speed", "a speed needs a unit, as in \"20 m/s\""}}},
    {"\"20 mph\"", "\"3 in\"", {{5, "impactor.speed", "but \"in\" denotes a length"}}},
    {"\"20 mph\"", "\"\"", {{5, "impactor.speed", "a speed must start with a number"}}},
    {"\"20 mph\"", "\"nan mph\"", {{5, "impactor.speed", "finite"}}},
    {"\"20 mph\"", "nan", {{5, "impactor.speed", "finite"}}},
    {"\"20 mph\"", "inf", {{5, "impactor.speed", "finite"}}},
    {"\"20 mph\"", "\"1e400 mph\"", {{5, "impactor.speed", "too large"}}},
    {"\"20 mph\"", "true", {{5, "impactor.speed", "a speed must start with a number"}}},
    {"\"20 mph\"", "2024-06-07", {{5, "impactor.speed", "a speed must start with a number"}}},
    {"\"20 mph\"", "[\"20 mph\"]", {{5, "impactor.speed", "a speed must start with a number"}}},
    {"\"20 mph\"", "\"0 mph\"", {{5, "impactor.speed", "must be more than 0"}}},
    {"\"20 mph\"", "\"-20 mph\"", {{5, "impactor.speed", "must be more than 0"}}},
    {"\"20 mph\"", "\"20 km/s\"", {{5, "impactor.speed", "and 1000 m/s"}}},
    {"\"3 in\"", "\"3 km\"", {{3, "impactor.radius", "between 1e-05 m and 100 m"}}},
    {"\"1 in\"", "\"1e-9 in\"", {{7, "pad.thickness", "between"}}},
    // Noses, and the face of the pad.
    {radius, "nose = \"cube\"\n" + radius, {{3, "impactor.nose", "must be one of sphere, flat-disc, cone"}}},
    {radius, cone_of + "\"0 deg\"", {{5, "impactor.half_angle", "0.01"}}},
    {radius, cone_of + "\"90 deg\"", {{5, "impactor.half_angle", "1.56"}}},
    {radius, cone_of + "\"-30 deg\"", {{5, "impactor.half_angle", "0.01"}}},
    {radius, cone_of + "\"nan deg\"", {{5, "impactor.half_angle", "finite"}}},
    {radius, cone_of + "30", {{5, "impactor.half_angle", "an angle needs a unit, as in \"30 deg\""}}},
    {radius, cone_of + "\"30 mm\"", {{5, "impactor.half_angle", "an angle is needed (deg, rad)"}}},
    {radius,
     cone_of + "\"30 deg\"\ntip_radius = \"3 in\"",
     {{6, "impactor.tip_radius", "must be less than radius"}}},
    {radius, cone_of + "\"30 deg\"\ntip_radius = \"-1 mm\"", {{6, "impactor.tip_radius", "must be 0, or"}}},
    {radius, "nose = \"cone\"\n" + radius, {{2, "impactor.half_angle", "is missing"}}},
    {radius,
     "nose = \"rod\"\n" + radius + "\ntip_radius = \"2 in\"",
     {{5, "impactor.tip_radius", "must be at least radius"}}},
    {radius,
     "nose = \"ellipsoid\"\nhalf_depth = \"0 in\"\nhalf_length = \"-1 in\"\nhalf_width = \"nan in\"",
     {{4, "impactor.half_depth", "must be more than 0"},
      {5, "impactor.half_length", "must be more than 0"},
      {6, "impactor.half_width", "finite"}}},
    {radius,
     "nose = \"platen\"\nlength = \"3 in\"\nwidth = \"2 in\"\n" + radius,
     {{6, "impactor.radius", "unknown key"}}},
    {radius, "nose = \"cylinder\"\n" + radius, {{2, "impactor.length", "is missing"}}},
    {radius, profile_of, {{2, "impactor.file", "is missing; give a file, radii or areas"}}},
    {radius,
     profile_of + "\nradii = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"1 mm\"]]\nfile = \"nose.csv\"",
     {{5, "impactor.file", "give only one of file, radii and areas"}}},
    {radius, profile_of + "\nfile = \"none.csv\"", {{4, "impactor.file", "no such file"}}},
    {radius,
     profile_of + "\nradii = [[\"0 mm\", \"1 mm\"]]",
     {{4, "impactor.radii", "fewer than two points"}}},
    {radius,
     profile_of + "\nradii = [[\"0 mm\"], [\"1 mm\", \"1 cm2\"]]",
     {{4, "impactor.radii[1]", "must be a depth and a radius"},
      {4, "impactor.radii[2]", "a length is needed"}}},
    {radius,
     profile_of + "\nareas = [\n[\"0 mm\", \"0 mm2\"],\n[\"9 mm\", \"2 cm2\"],\n[\"9 mm\", \"3 cm2\"]]",
     {{7, "impactor.areas[3]", "the depth must exceed the previous depth"}}},
    {radius,
     profile_of + "\nradii = [[\"0 mm\", \"0 mm\"],\n[\"9 mm\", \"2 km\"]]",
     {{4, "impactor.radii", "the largest radius must be"}}},
    {radius,
     profile_of + "\nscale = 0\nradii = [[\"0 mm\", \"0 mm\"],\n[\"9 mm\", \"2 cm\"]]",
     {{4, "impactor.scale", "0.001"}}},
    {"\"1 in\"", "\"1 in\"\narea = \"0 cm2\"", {{8, "pad.area", "must be more than 0"}}},
    {"\"1 in\"", "\"1 in\"\narea = \"-1 cm2\"", {{8, "pad.area", "must be more than 0"}}},
    {"\"1 in\"", "\"1 in\"\narea = \"nan cm2\"", {{8, "pad.area", "finite"}}},
    {"\"1 in\"", "\"1 in\"\narea = \"3 cm\"", {{8, "pad.area", "an area is needed"}}},
    {"\"1 in\"",
     "\"1 in\"\nsheet_mass_per_area = \"0 kg/m2\"",
     {{8, "pad.sheet_mass_per_area", "leave the key out"}}},
    {"\"1 in\"", "\"1 in\"\nsheet_mass_per_area = \"-2 kg/m2\"", {{8, "pad.sheet_mass_per_area", "must be"}}},
    {"\"1 in\"",
     "\"1 in\"\nsheet_mass_per_area = \"5 kg\"",
     {{8, "pad.sheet_mass_per_area", "a mass per unit area is needed"}}},
    // What a support has beside its curve.
    {linear_support, linear_support + "\nmass = \"0 kg\"", {{12, "support.mass", "leave the key out"}}},
    {linear_support,
     linear_support + "\nbody_mass = \"0 kg\"",
     {{12, "support.body_mass", "leave the key out"}}},
    {linear_support, linear_support + "\nmass = \"-1 kg\"", {{12, "support.mass", "must be more than 0"}}},
    {linear_support, linear_support + "\nmass = \"1e9 kg\"", {{12, "support.mass", "between 1e-06 kg"}}},
    {linear_support, linear_support + "\ndamping = \"-3 N s/m\"", {{12, "support.damping", "more than 0"}}},
    {linear_support, linear_support + "\ndamping = \"nan N s/m\"", {{12, "support.damping", "finite"}}},
    {linear_support,
     linear_support + "\ndamping = \"3 N/m\"",
     {{12, "support.damping", "a damping coefficient is needed"}}},
    {linear_support, linear_support + "\nloss_factor = 3", {{12, "support.loss_factor", "at most 2"}}},
    {linear_support,
     linear_support + "\ndamping = \"3 N s/m\"\nloss_factor = 0.2",
     {{13, "support.loss_factor", "not both"}}},
    {linear_support,
     linear_support + "\nunloading_stiffness = \"500 lbf/in\"",
     {{12, "support.unloading_stiffness", "at least the steepest slope"}}},
    {linear_support,
     linear_support + "\ngap = \"1 mm\"",
     {{12, "support.gap", "needs the mass of the panel"}}},
    {linear_support,
     linear_support + "\nmass = \"1 kg\"\ngap = \"1 mm\"\npreload = \"5 N\"",
     {{13, "support.gap", "has no gap"}}},
    {linear_support,
     linear_support + "\nearlier_force = \"50 N\"",
     {{12, "support.earlier_force", "needs an unloading_stiffness"}}},
    {linear_support,
     "type = \"rigid\"\nmass = \"1 kg\"\ndamping = \"3 N s/m\"",
     {{11, "support.mass", "a rigid support can only have"},
      {12, "support.damping", "a rigid support can only have"}}},
    // Gravity and a fall.
    {"\"20 mph\"", "\"20 mph\"\ngravity = \"-9.8 m/s2\"", {{6, "impactor.gravity", "must be at least 0"}}},
    {"\"20 mph\"", "\"20 mph\"\ndrop_height = \"1 m\"", {{6, "impactor.drop_height", "not both"}}},
    {"speed = \"20 mph\"", "drop_height = \"0 m\"", {{5, "impactor.drop_height", "must be more than 0"}}},
    {"speed = \"20 mph\"", "drop_height = \"1 s\"", {{5, "impactor.drop_height", "a length is needed"}}},
    {"speed = \"20 mph\"",
     "drop_height = \"1 Mm\"",
     {{5, "impactor.drop_height", "the speed after the fall"}}},
    {"speed = \"20 mph\"",
     "drop_height = \"1 m\"\ngravity = \"0 m/s2\"",
     {{5, "impactor.drop_height", "a fall needs gravity"}}},
    // Mass or weight.
    {"weight = \"10 lbf\"", "weight = \"10 lb\"", {{4, "impactor.weight", "lb and kg are units of mass"}}},
    {"weight = \"10 lbf\"", "weight = \"-10 lbf\"", {{4, "impactor.weight", "the mass must be more than 0"}}},
    {"weight = \"10 lbf\"", "mass = \"0 kg\"", {{4, "impactor.mass", "must be more than 0"}}},
    {"weight = \"10 lbf\"", "mass = \"10 lbf\"", {{4, "impactor.mass", "a mass is needed"}}},
    {"weight = \"10 lbf\"",
     "",
     {{2, "impactor.mass", "is missing; give a mass, such as \"4.5 kg\", or a weight"}}},
    {"weight = \"10 lbf\"", "weight = \"10 lbf\"\nmass = \"1 kg\"", {{4, "impactor.weight", "not both"}}},
    // No oblique blows.
    {"weight = \"10 lbf\"",
     "weight = \"10 lbf\"\nangle = \"30 deg\"",
     {{5, "impactor.angle",
       "oblique impacts are not supported. Using only the normal component of the speed neglects "
       "friction"}}},
    {"[support]\n", "[support]\nTilt = 3\n", {{10, "support.Tilt", "oblique impacts are not supported"}}},
    {"thickness = ",
     "angle = \"30 deg\"\nthickness = ",
     {{7, "pad.angle", "oblique impacts are not supported"}}},
    {"radius", "half_angle = \"30 deg\"\nradius", {{3, "impactor.half_angle", "unknown key; valid keys"}}},
    // Keys.
    {"radius",
     "radus",
     {{2, "impactor.radius", "is missing"}, {3, "impactor.radus", "unknown key; did you mean \"radius\"?"}}},
    {"[solver]", "[solvers]", {{12, "solvers", "unknown key; did you mean \"solver\"?"}}},
    {"speed = ",
     "colour = \"red\"\nspeed = ",
     {{5, "impactor.colour", "valid keys: mass, weight, nose, radius, speed"}}},
    {"speed = \"20 mph\"\n", "", {{2, "impactor.speed", "is missing"}}},
    {"[impactor]", "[sphere]", {{0, "impactor", "is missing"}, {2, "sphere", "unknown key"}}},
    {"title = \"A case\"", "title = 3", {{1, "title", "text in quotes"}}},
    {"[solver]", "[solver.deep]", {{12, "solver.deep", "unknown key"}}},
    {"[solver]", "[[solver]]", {{12, "solver", "must be a table: [solver]"}}},
    {"[support]\n" + linear_support, "", {{0, "support", "is missing"}}},
    // Materials.
    {named_material, "", {{6, "pad.material", "is missing"}}},
    {named_material, named_material + "\nlaw = \"elastic\"", {{8, "pad.material", "not both"}}},
    {"ensolite-aac-9", "ensolite-acc-9", {{8, "pad.material", "did you mean \"ensolite-aac-9\"?"}}},
    {"ensolite-aac-9", "Ensolite AAC 9", {{8, "pad.material", "did you mean \"ensolite-aac-9\"?"}}},
    {"ensolite-aac-9", "../materials/ensolite-aac-9", {{8, "pad.material", "must be the name of a card"}}},
    {"ensolite-aac-9", "a\\u0000.toml", {{8, "pad.material", "control character"}}},
    {"ensolite-aac-9", "none.toml", {{8, "pad.material", "no such file"}}},
    {named_material, "material = 9", {{8, "pad.material", "text in quotes"}}},
    {named_material, "law = \"elastik\"\n[pad.parameters]", {{8, "pad.law", "did you mean \"elastic\"?"}}},
    {named_material, "law = \"elastic\"", {{6, "pad.parameters", "is missing"}}},
    {named_material, "[pad.parameters]\nmodulus = \"1 psi\"", {{6, "pad.law", "is missing"}}},
    {named_material,
     law_of + "40",
     {{10, "pad.parameters.modulus", "a stress needs a unit, as in \"40 Pa\""}}},
    {named_material, law_of + "\"0 psi\"", {{10, "pad.parameters.modulus", "must be more than 0 Pa"}}},
    {named_material, law_of + "\"1e30 psi\"", {{10, "pad.parameters.modulus", "magnitude"}}},
    {named_material,
     law_of + "\"1 psi\"\nmodulos = 1",
     {{11, "pad.parameters.modulos", "did you mean \"modulus\"?"}}},
    // Supports.
    {"\"linear\"",
     "\"linea\"",
     {{10, "support.type", "must be one of rigid, linear, curve; did you mean \"linear\"?"}}},
    {"\"linear\"", "\"rigid\"", {{11, "support.stiffness", "unknown key"}}},
    {"\"600 lbf/in\"", "\"-600 lbf/in\"", {{11, "support.stiffness", "must be more than 0"}}},
    {"\"600 lbf/in\"", "\"1e300 lbf/in\"", {{11, "support.stiffness", "between"}}},
    {"\"600 lbf/in\"", "\"600 lb/in\"", {{11, "support.stiffness", "lbf, kgf and N are units of force"}}},
    {linear_support, curve_of + "[]", {{11, "support.points", "between 1 and 10000 points"}}},
    {linear_support, curve_of + "3", {{11, "support.points", "an array"}}},
    {linear_support, curve_of + "[[\"1 in\"]]", {{11, "support.points[1]", "a deflection and a force"}}},
    {linear_support,
     curve_of + "[[\"1 lbf\", \"1 in\"]]",
     {{11, "support.points[1]", "a length is needed"}, {11, "support.points[1]", "a force is needed"}}},
    {linear_support,
     curve_of + "[[\"0 in\", \"0 lbf\"],\n[\"1 in\", \"1 lbf\"]]",
     {{11, "support.points[1]", "the deflection must be more than 0"},
      {11, "support.points[1]", "the force must be more than 0"}}},
    {linear_support,
     curve_of + "[[\"1 in\", \"9 lbf\"],\n[\"2 in\", \"8 lbf\"],\n[\"2 in\", \"9 lbf\"]]",
     {{12, "support.points[2]", "the force must be more than the previous one"},
      {13, "support.points[3]", "the deflection must be more than the previous one"}}},
    {linear_support,
     curve_of + "[[\"1 in\", \"1 lbf\"],\n[\"2 in\", \"1e200 lbf\"]]",
     {{12, "support.points[2]", "must have a magnitude between"}}},
    // Solver.
    {"1e-5", "\"1e-5\"", {{13, "solver.tolerance", "a plain number"}}},
    {"1e-5", "inf", {{13, "solver.tolerance", "a finite number"}}},
    {"1e-5", "0.5", {{13, "solver.tolerance", "at most 1e-2"}}},
    {"1e-5", "-1", {{13, "solver.tolerance", "at least 1e-8"}}},
    {"\"200 ms\"", "\"0 s\"", {{14, "solver.time_limit", "must be more than 0"}}},
    // TOML.
    {"radius = ", "radius ", {{3, "", "is not valid TOML"}}},
    {"[pad]", "[impactor]", {{6, "", "is not valid TOML"}}},
    {"speed = \"20 mph\"", "weight = \"1 lbf\"", {{5, "", "is not valid TOML"}}},
    {"[pad]", "[", {{6, "", "is not valid TOML"}}},
    {"[pad]", "[[[pad]]]", {{6, "", "is not valid TOML"}}},
    {"radius", "\u00a7radius", {{3, "", "is not valid TOML"}}},
    {"\"A case\"", "\"\"\"\\\n\u00a7\"\"\"\nradius = 3", {{3, "radius", "unknown key"}}},
    {"1e-5", "1e400", {{13, "", "is not valid TOML"}}},
    {"1e-5", "99999999999999999999", {{13, "", "is not valid TOML"}}},
    {"1e-5", std::string(100'000, '['), {{13, "", "is not valid TOML"}}},
    {"A case", "\xc3\x28", {{1, "", "is not valid TOML"}}},
    {"A case", std::string("\0", 1), {{1, "", "is not text"}}},
    {"title", "\xff\xfet", {{1, "", "is UTF-16"}}},
};

TEST(case_faults, each_fault_is_named_with_line_key_and_rule) {
  for (const auto& [from, to, expected] : edits) {
    SCOPED_TRACE(from + " -> " + to.substr(0, 60));
    const std::string text = edited(good_case, from, to);
    expect_faults(faults_in([&] { read(text); }), expected);
  }
}

TEST(case_faults, rules_between_parameters_are_checked) {
  const std::string text = edited(good_case, named_material, in_line_material);
  expect_faults(
      faults_in([&] { read(edited(edited(text, "90 psi", "30 psi"), "\"50 1/s\"", "\"0.5 1/s\"")); }),
      {{11, "pad.parameters.initial_modulus", "must be at least asymptotic_modulus"},
       {16, "pad.fitted.highest_rate", "must be more than lowest_rate"}});
}

TEST(case_faults, all_faults_come_at_once_in_the_order_of_lines) {
  std::string text = edited(good_case, "\"3 in\"", "\"-3 in\"");
  text = edited(text, "\"20 mph\"", "20");
  text = edited(text, "thickness", "thicknes");
  text = edited(text, "ensolite-aac-9", "ensolite");
  text = edited(text, "600 lbf/in", "600 lbf");
  text = edited(text, "1e-5", "1");
  const auto faults = faults_in([&] { read(text); });
  expect_faults(faults, {{3, "impactor.radius", "must be more than 0"},
                         {5, "impactor.speed", "needs a unit"},
                         {6, "pad.thickness", "is missing"},
                         {7, "pad.thicknes", "did you mean"},
                         {8, "pad.material", "no such card"},
                         {11, "support.stiffness", "a stiffness is needed"},
                         {13, "solver.tolerance", "at most"}});
  EXPECT_EQ(faults[0].value, "\"-3 in\"");
  EXPECT_EQ(faults[1].value, "20");
}

TEST(case_faults, faults_of_a_card_name_the_card) {
  const test::TemporaryFolder folder;
  const auto card =
      folder.write("mine.toml",
                   "title = \"Mine\"\nlaw = \"elastic\"\n[parameters]\nmodulus = \"-1 psi\"\n"
                   "[fitted]\nhighest_strain = 2\nlowest_rate = \"1 1/s\"\nhighest_rate = \"9 1/s\"\n");
  const auto file =
      folder.write("case.toml", edited(edited(good_case, "ensolite-aac-9", "mine"), "\"20 mph\"", "20"));
  const auto faults = faults_in([&] { input::read_case(file, folder.path()).value(); });
  expect_faults(faults, {{5, "impactor.speed", "needs a unit"},
                         {0, "source", "is missing"},
                         {4, "parameters.modulus", "must be more than 0"},
                         {6, "fitted.highest_strain", "must be more than 0 and at most 1"}});
  EXPECT_EQ(faults[0].file, file.string());
  EXPECT_EQ(faults[1].file, card.string());
  EXPECT_EQ(faults[3].file, card.string());
}

TEST(case_faults, too_many_points_are_refused) {
  std::string points = "[";
  for (int i = 0; i < 10'001; ++i)
    points += "[\"" + std::to_string(i + 1) + " m\", \"" + std::to_string(i + 1) + " N\"],";
  expect_faults(faults_in([&] { read(edited(good_case, linear_support, curve_of + points + "]")); }),
                {{11, "support.points", "between 1 and 10000 points"}});
}

TEST(case_faults, deep_nesting_is_refused) {
  std::string deep = "a";
  for (int i = 0; i < 200'000; ++i) deep += ".a";
  expect_faults(faults_in([&] { read(good_case + deep + " = 1\n"); }), {{15, "", "more than 64 dots"}});
  std::string tables = "1";
  for (int i = 0; i < 1000; ++i) tables = fmt::format("{{a.a.a.a.a.a.a.a={}}}", tables);
  expect_faults(faults_in([&] { read(good_case + "x = " + tables + "\n"); }),
                {{15, "", "is not valid TOML"}});
}

TEST(case_faults, only_regular_files_of_moderate_size_are_read) {
  const test::TemporaryFolder folder;
  const auto large = folder.write("large.toml", "");
  std::filesystem::resize_file(large, 1'000'000'000);  // takes no space: it is a hole
  const auto pipe = folder.path() / "pipe.toml";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto locked = folder.write("locked.toml", good_case);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  struct Row {
    std::filesystem::path file;
    std::string rule;
  };
  std::vector<Row> rows{{folder.path() / "none.toml", "no such file"},
                        {folder.path(), "is a folder"},
                        {large, "is larger than 1 MiB"},
                        {pipe, "is not a regular file"},
                        {"/dev/zero", "is not a regular file"},
                        {"", "no such file"}};
  if (::geteuid() != 0) rows.push_back({locked, "cannot be read"});  // root may read everything
  for (const Row& row : rows) {
    SCOPED_TRACE(row.file);
    expect_faults(faults_in([&] { input::read_case(row.file, materials).value(); }), {{0, "", row.rule}});
    expect_faults(faults_in([&] { input::read_material(row.file).value(); }), {{0, "", row.rule}});
  }
}

TEST(fault, is_one_line_whatever_the_file_holds) {
  EXPECT_EQ(to_string(Fault{"case.toml", 12, "impactor.speed", "20", "needs a unit"}),
            "case.toml:12: impactor.speed = 20: needs a unit");
  EXPECT_EQ(to_string(Fault{"case.toml", 0, "", "", "no such file"}), "case.toml: no such file");
  EXPECT_EQ(to_string(Fault{"case.toml", 3, "a\nb", "\x1b[2J", "rule"}), "case.toml:3: a b =  [2J: rule");
}

TEST(fault, message_holds_all_faults_but_is_not_endless) {
  const std::string two = input::InputError({Fault{"a", 1, "", "", "x"}, Fault{"a", 2, "", "", "y"}}).what();
  EXPECT_EQ(two, "a:1: x\na:2: y");
  const std::string many = input::InputError(std::vector<Fault>(1000, Fault{"a", 1, "", "", "x"})).what();
  EXPECT_TRUE(many.ends_with("\nand 995 more of this kind"));
  std::vector<Fault> kinds;
  for (std::size_t i = 0; i < 1000; ++i)
    kinds.push_back({"a", 1, std::string(i % 100, 'k') + std::string(i / 100 + 1, 'l'), "", "x"});
  const std::string all = input::InputError(kinds).what();
  EXPECT_TRUE(all.ends_with("\n..."));
  EXPECT_EQ(std::ranges::count(all, '\n'), 200);
}

}  // namespace
}  // namespace dashpad
