/// The examples solve to what they solved to before: tests/regression/expected, one small text an example.
/// That says nothing about whether the numbers are right, which is for tests/verification.
///
/// After a change that is meant to change numbers, write the texts anew, look at the difference, and commit
/// it:
///
///   DASHPAD_REGENERATE=1 test_regression

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "dashpad/impact/solve.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

namespace fs = std::filesystem;

constexpr double solver_tolerance = 1e-5;
/// Relative: a change of the steps alone stays within it.
constexpr double tolerance = 5e-5;
const fs::path expected_folder = source_folder / "tests/regression/expected";

std::vector<fs::path> examples() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(source_folder / "examples"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

fs::path expected_file(const fs::path& example) {
  return expected_folder / (example.stem().string() + ".txt");
}

std::string number(double value) { return fmt::format("{:.6g}", value); }
std::string number(const std::optional<double>& value) { return value ? number(*value) : "none"; }
std::string words(const std::optional<Moment>& moment) {
  return moment ? number(moment->time) + " " + number(moment->velocity) : "none";
}

/// A line a figure, SI: name, then its numbers.
std::string text_of(const Summary& s) {
  std::string text;
  const auto line = [&text](const char* name, const std::string& value) {
    text += fmt::format("{:26}{}\n", name, value);
  };
  line("status", to_string(s.status));
  line("peak_force", number(s.peak_force));
  line("time_of_peak_force", number(s.time_of_peak_force));
  line("peak_motion", number(s.peak_motion));
  line("peak_penetration", number(s.peak_penetration));
  line("peak_strain", number(s.peak_strain));
  line("peak_strain_rate", number(s.peak_strain_rate));
  line("peak_acceleration", number(s.peak_acceleration));
  line("weight", words(s.force_below_weight));
  line("contact_end", words(s.contact_end));
  line("bottomed", words(s.bottomed));
  line("rebound_speed", number(s.rebound_speed));
  line("restitution", number(s.restitution));
  line("energy_absorbed_fraction", number(s.energy_absorbed_fraction));
  line("extrapolated", s.extrapolations.empty() ? "no" : "yes");
  return text;
}

/// The flat peak of a force has an ill-defined moment; the absorbed energy is a small difference.
double allowance(const std::string& name) {
  return name == "time_of_peak_force" || name == "energy_absorbed_fraction" ? 10 * tolerance : tolerance;
}

/// Words must be the same, numbers nearly so.
void expect_alike(const std::string& name, const std::string& value, const std::string& expected) {
  std::istringstream now(value);
  std::istringstream before(expected);
  std::string a;
  std::string b;
  while (before >> b) {
    ASSERT_TRUE(now >> a) << name;
    char* end = nullptr;
    const double wanted = std::strtod(b.c_str(), &end);
    if (*end == '\0')
      expect_relative(std::strtod(a.c_str(), nullptr), wanted, allowance(name), name);
    else
      EXPECT_EQ(a, b) << name;
  }
  EXPECT_FALSE(now >> a) << name << " has more than before: " << a;
}

std::map<std::string, std::string> lines_of(std::istream& stream) {
  std::map<std::string, std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && line[0] != '#') lines[line.substr(0, line.find(' '))] = line.substr(line.find(' '));
  return lines;
}

class Examples : public testing::TestWithParam<fs::path> {};

TEST_P(Examples, SolveToWhatTheySolvedToBefore) {
  input::CaseFile file = input::read_case(GetParam(), material_folder).value();
  file.options.tolerance = solver_tolerance;
  const Summary summary = solve(file.impact, file.options).summary;
  const std::string text = text_of(summary);
  const fs::path expected = expected_file(GetParam());
  if (std::getenv("DASHPAD_REGENERATE") != nullptr) {
    std::ofstream(expected) << "# examples/" << GetParam().filename().string()
                            << " at tolerance 1e-5, SI. Written by DASHPAD_REGENERATE=1 test_regression.\n"
                            << text;
    GTEST_SKIP() << "wrote " << expected;
  }
  std::ifstream stream(expected);
  ASSERT_TRUE(stream) << expected << " is missing: see the head of this test";
  const auto before = lines_of(stream);
  std::istringstream fresh(text);
  const auto now = lines_of(fresh);
  ASSERT_EQ(now.size(), before.size());
  for (const auto& [name, value] : now) {
    ASSERT_TRUE(before.contains(name)) << name;
    expect_alike(name, value, before.at(name));
  }
}

TEST(ExpectedTexts, BelongToAnExample) {
  for (const auto& entry : fs::directory_iterator(expected_folder)) {
    const fs::path example = source_folder / "examples" / (entry.path().stem().string() + ".toml");
    EXPECT_TRUE(fs::exists(example)) << entry.path() << " has no example";
  }
}

INSTANTIATE_TEST_SUITE_P(Regression, Examples, testing::ValuesIn(examples()), [](const auto& parameter) {
  std::string name = parameter.param.stem().string();
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
});

}  // namespace
}  // namespace dashpad::test
