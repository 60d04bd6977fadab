// The case file that a page or a study hands out: read again it is the same case.

#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "model/parameter_values.hpp"
#include "output/text/case_toml.hpp"
#include "sample_case.hpp"

namespace dashpad::test {

namespace {

const input::CaseFile& dashboard() {
  static const input::CaseFile input =
      input::read_case(source / "examples/dashboard-20mph.toml", materials).value();
  return input;
}

TEST(case_toml, is_read_as_the_same_case) {
  for (const char* name :
       {"dashboard-20mph", "dashboard-20mph-21-parameter", "load-cell-drop", "rigid-floor-bottoming"}) {
    const input::CaseFile input =
        input::read_case(source / "examples" / (std::string{name} + ".toml"), materials).value();
    const input::CaseFile again =
        read(output::case_toml(input.impact, {.tolerance = 3e-6, .time_limit = 0.25}));
    EXPECT_EQ(again.impact.title, input.impact.title);
    EXPECT_EQ(again.impact.impactor.mass, input.impact.impactor.mass);
    EXPECT_EQ(std::get<Sphere>(again.impact.impactor.nose).radius,
              std::get<Sphere>(input.impact.impactor.nose).radius);
    EXPECT_EQ(again.impact.impactor.speed, input.impact.impactor.speed);
    EXPECT_EQ(again.impact.pad.thickness, input.impact.pad.thickness);
    EXPECT_EQ(again.impact.pad.material.law.index(), input.impact.pad.material.law.index());
    EXPECT_EQ(again.impact.support.points(), input.impact.support.points()) << name;
    EXPECT_EQ(again.options.tolerance, 3e-6);
    EXPECT_EQ(again.options.time_limit, 0.25);
    EXPECT_EQ(again.impact.pad.material.fitted->highest_rate, input.impact.pad.material.fitted->highest_rate);
    // The same numbers give the same impact, to the last bit.
    EXPECT_EQ(solve(again.impact, input.options).summary.peak_motion,
              solve(input.impact, input.options).summary.peak_motion);
  }
}

TEST(case_toml, keeps_every_nose_and_the_face_of_the_pad) {
  for (const Nose& nose :
       std::vector<Nose>{Sphere{0.1}, FlatDisc{0.05}, Cone{0.08, 1.1, 0.01}, Cone{0.08, 0.7},
                         Ellipsoid{0.06, 0.09, 0.05}, Rod{0.03, 0.08}, Platen{0.1, 0.08}}) {
    ImpactCase impact = dashboard().impact;
    impact.impactor.nose = nose;
    impact.pad.area = 0.0123;
    impact.pad.sheet = 4.7;
    const ImpactCase again = read(output::case_toml(impact, {})).impact;
    ASSERT_EQ(name_of(again.impactor.nose), name_of(nose));
    const auto numbers = parameter_values(nose), read_again = parameter_values(again.impactor.nose);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      EXPECT_EQ(read_again[i].value, numbers[i].value) << name_of(nose) << ", " << numbers[i].key;
    EXPECT_EQ(again.pad.area, 0.0123);
    EXPECT_EQ(again.pad.sheet, 4.7);
  }
}

TEST(case_toml, no_title_breaks_it) {
  ImpactCase impact = dashboard().impact;
  const std::string title = "a \"quoted\" \\ title\n[impactor]\nmass = \"1 kg\" \x7f \xff";
  impact.title = impact.pad.material.name = impact.pad.material.source = title;
  const input::CaseFile again = read(output::case_toml(impact, {}));
  EXPECT_EQ(again.impact.impactor.mass, impact.impactor.mass);
  EXPECT_EQ(again.impact.title, "a \"quoted\" \\ title [impactor] mass = \"1 kg\"   \xef\xbf\xbd");
}

}  // namespace

}  // namespace dashpad::test
