/// Case files: what good ones give.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "sample_case.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using test::edited;
using test::good_case;
using test::in_line_material;
using test::materials;
using test::read;
using test::source;

TEST(case_file, good_case_is_read_into_si) {
  const auto [impact, options, states_neighbours, files] = read(good_case);
  EXPECT_EQ(impact.title, "A case");
  EXPECT_DOUBLE_EQ(std::get<Sphere>(impact.impactor.nose).radius, 0.0762);
  EXPECT_DOUBLE_EQ(impact.impactor.mass, 4.5359237);
  EXPECT_DOUBLE_EQ(impact.impactor.speed, 8.9408);
  EXPECT_DOUBLE_EQ(impact.pad.thickness, 0.0254);
  EXPECT_EQ(impact.pad.material.name, "ensolite-aac-9");
  EXPECT_EQ(name_of(impact.pad.material.law), "nine-parameter");
  ASSERT_TRUE(impact.pad.material.fitted);
  EXPECT_DOUBLE_EQ(impact.support.force(0.0254), 600 * 4.4482216152605);
  EXPECT_EQ(options.tolerance, 1e-5);
  EXPECT_DOUBLE_EQ(options.time_limit, 0.2);
  EXPECT_EQ(files.size(), 2) << "the case and its card";
}

TEST(case_file, solver_and_title_may_be_left_out) {
  const auto [impact, options, states_neighbours, files] =
      read(edited(good_case.substr(0, good_case.find("[solver]")), "title = \"A case\"", ""));
  EXPECT_EQ(impact.title, "");
  EXPECT_EQ(options.tolerance, Options().tolerance);
  EXPECT_EQ(options.time_limit, Options().time_limit);
  EXPECT_FALSE(files.empty());
}

TEST(case_file, mass_is_an_alternative_to_weight) {
  EXPECT_DOUBLE_EQ(read(edited(good_case, "weight = \"10 lbf\"", "mass = \"10 lb\"")).impact.impactor.mass,
                   4.5359237);
}

TEST(case_file, law_can_be_given_in_line) {
  const Material material =
      read(edited(good_case, "material = \"ensolite-aac-9\"", in_line_material)).impact.pad.material;
  EXPECT_EQ(material.name, "foam of the case");
  const auto& law = std::get<LinearViscoelastic>(material.law);
  EXPECT_DOUBLE_EQ(law.asymptotic_modulus, 40 * 6894.757293168361);
  EXPECT_DOUBLE_EQ(law.relaxation_time, 0.01);
  ASSERT_TRUE(material.fitted);
  EXPECT_EQ(material.fitted->highest_strain, 0.8);
}

TEST(case_file, material_can_be_a_path_from_the_case) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "cards");
  std::filesystem::copy(materials / "ensolite-aac-21.toml", folder.path() / "cards" / "mine.toml");
  const auto file = folder.write("case.toml", edited(good_case, "\"ensolite-aac-9\"", "\"cards/mine.toml\""));
  EXPECT_EQ(input::read_case(file, "/no/such/folder").value().impact.pad.material.name, "mine");
}

TEST(case_file, supports_of_each_type_are_read) {
  const std::string linear = "type = \"linear\"\nstiffness = \"600 lbf/in\"";
  EXPECT_TRUE(read(edited(good_case, linear, "type = \"rigid\"")).impact.support.is_rigid());
  const Support curve =
      read(edited(good_case, linear,
                  "type = \"curve\"\npoints = [[\"1 mm\", \"1 kN\"],\n[\"2 mm\", \"5 kN\"]]"))
          .impact.support;
  ASSERT_EQ(curve.points().size(), 2U);
  EXPECT_DOUBLE_EQ(curve.points()[1].deflection, 0.002);
  EXPECT_DOUBLE_EQ(curve.points()[1].force, 5000);
}

TEST(case_file, neighbours_are_nominal_for_foams_by_uniaxial_tests_alone) {
  const auto pad_with = [](const std::string& text) {
    return read(edited(good_case, "material = \"ensolite-aac-9\"", text)).impact.pad;
  };
  EXPECT_EQ(pad_with("material = \"ensolite-aac-9\"").neighbours, 0);
  EXPECT_EQ(pad_with("material = \"vn600\"").neighbours, 0.8);
  EXPECT_EQ(pad_with("material = \"vn600\"").floor, Floor::bonded);
  EXPECT_EQ(pad_with("material = \"ensolite-33-tests\"").neighbours, 0) << "measured in impacts of a sphere";
  EXPECT_EQ(pad_with("material = \"vn600\"\nneighbours = 0").neighbours, 0);
  EXPECT_EQ(pad_with("material = \"ensolite-aac-9\"\nneighbours = 0.7").neighbours, 0.7);
  EXPECT_EQ(pad_with("material = \"vn600\"\nfloor = \"frictionless\"").floor, Floor::frictionless);
  EXPECT_THROW(pad_with("material = \"vn600\"\nfloor = \"glued\""), input::InputError);
  EXPECT_THROW(pad_with("material = \"vn600\"\nneighbours = -0.1"), input::InputError);
  EXPECT_THROW(pad_with("material = \"vn600\"\nneighbours = 2.5"), input::InputError);
}

TEST(case_file, examples_are_good) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source / "examples")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    EXPECT_NO_THROW({
      const ImpactCase impact = input::read_case(entry.path(), materials).value().impact;
      EXPECT_FALSE(impact.title.empty());
      EXPECT_TRUE(violations(impact).empty());
    }) << entry.path();
  }
  EXPECT_GE(count, 4);
}

}  // namespace
}  // namespace dashpad
