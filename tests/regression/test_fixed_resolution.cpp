/// Single runs of the solver at one resolution give the figures that they gave before, to the last digit on
/// the machine that wrote them: tests/regression/fixed-resolution.txt, a line a case, over all laws, supports
/// and phases. That says nothing about whether the numbers are right, which is for tests/verification.
///
/// Elsewhere (other vectors, another libm) and after formulas were rewritten, a figure may differ by a tenth
/// of what the run would state as its error. A few cases hang on rounding and may differ by more.
///
///   DASHPAD_EXACT=1 test_regression         after moves and renames: no digit may differ
///   DASHPAD_REGENERATE=1 test_regression    after a change of method: look at the difference, and commit it

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "property/random_case.hpp"
#include "shared/run_once.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr double resolution = 0.1;
constexpr std::uint64_t cases_of_each_kind = 100;
/// Further ones in which the pad loads again: seldom, and what the branch rules are for.
constexpr std::array<std::uint64_t, 2> ordinary_reloadings{162, 612};
constexpr std::array<std::uint64_t, 16> extreme_reloadings{162, 190, 248, 259, 263, 282, 324, 326,
                                                           335, 340, 408, 415, 488, 495, 502, 598};
/// Share of the error estimate by which a figure may differ.
constexpr double allowed_share = 0.1;
/// Of the figure, for rounding where two resolutions agree by chance.
constexpr double rounding = 1e-8;
/// Cases whose branches hang on rounding, of 218. Seen with vectors of another width: one.
constexpr int max_outliers = 4;

const std::filesystem::path stored_runs = source_folder / "tests/regression/fixed-resolution.txt";

using Numbers = std::vector<std::pair<std::string, double>>;

struct Line {
  std::string path;  ///< how the run went, in words
  Numbers numbers;
};

std::string support_of(const ImpactCase& impact) {
  if (impact.support.is_rigid()) return "rigid";
  return impact.support.corners().empty() ? "linear" : "curved";
}

std::string ending_of(const Figures& run) {
  switch (run.ending) {
    case Status::released: return "released";
    case Status::bottomed_out: return "bottomed-out";
    case Status::time_limit: return "time-limit";
    case Status::at_rest: return "at-rest";
    default: break;
  }
  return "gave-up";
}

double sum(const std::vector<double>& column) { return std::accumulate(column.begin(), column.end(), 0.0); }

Line line_of(const ImpactCase& impact, const Run& run) {
  const Figures& f = run.figures;
  Line line;
  line.path =
      fmt::format("{} {} {}{} reloadings={} stretches={} entries={}", name_of(impact.pad.material.law),
                  support_of(impact), ending_of(f), f.bottomed ? " bottomed" : "", f.reloadings,
                  run.track.stretch_starts.size(), run.track.size());
  line.numbers = {{"peak_force", f.peak_force},
                  {"time_of_peak_force", f.time_of_peak_force},
                  {"peak_motion", f.peak_motion},
                  {"peak_penetration", f.peak_penetration},
                  {"peak_pad_rate", f.peak_pad_rate},
                  {"final_velocity", f.final_velocity},
                  {"support_energy", f.energy.support},
                  {"pad_work", f.energy.pad},
                  {"sum_of_forces", sum(run.track.history.force)},
                  {"sum_of_penetrations", sum(run.track.history.penetration)}};
  const auto add = [&line](const std::string& name, const std::optional<Moment>& moment) {
    if (!moment) return;
    line.numbers.emplace_back(name + "_time", moment->time);
    line.numbers.emplace_back(name + "_velocity", moment->velocity);
  };
  add("weight", f.force_below_weight);
  add("contact_end", f.contact_end);
  add("release", f.release);
  add("bottomed", f.bottomed);
  return line;
}

std::string text_of(const Line& line) {
  std::string text = line.path;
  for (const auto& [name, value] : line.numbers) text += fmt::format(" {}={:.17g}", name, value);
  return text;
}

std::string key_of(const char* kind, std::uint64_t seed) { return fmt::format("{} {}", kind, seed); }

/// The sums are of a history's entries, of which there may be more or fewer.
bool is_a_figure(const std::string& name) { return !name.starts_with("sum_of"); }

/// Figures that differ from those before by more than is allowed, in words. `coarse` is the run at twice the
/// resolution.
std::string differences(const Line& now, const Line& coarse, const std::map<std::string, double>& before) {
  std::string text;
  std::map<std::string, double> at_coarse(coarse.numbers.begin(), coarse.numbers.end());
  for (const auto& [name, value] : now.numbers) {
    if (!is_a_figure(name)) continue;
    const auto known = before.find(name);
    if (known == before.end()) return " " + name + " is new";
    const double estimate = at_coarse.contains(name) ? std::abs(value - at_coarse[name]) / 3 : 0;
    const double difference = std::abs(value - known->second);
    if (difference > allowed_share * estimate + rounding * std::abs(value))
      text +=
          fmt::format(" {} {:.17g}, before {:.17g}, estimate {:.2g};", name, value, known->second, estimate);
  }
  return text;
}

std::map<std::string, std::string> stored_lines() {
  std::map<std::string, std::string> lines;
  std::ifstream stream(stored_runs);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto end_of_key = line.find(": ");
    lines[line.substr(0, end_of_key)] = line.substr(end_of_key + 2);
  }
  return lines;
}

std::map<std::string, double> numbers_of(const std::string& line) {
  std::map<std::string, double> numbers;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals != std::string::npos) numbers[word.substr(0, equals)] = std::stod(word.substr(equals + 1));
  }
  return numbers;
}

template <class Visit>
void for_each_case(Visit&& visit) {
  for (std::uint64_t seed = 1; seed <= cases_of_each_kind; ++seed) {
    visit(key_of("ordinary", seed), ordinary_case(seed));
    visit(key_of("extreme", seed), random_case(seed));
  }
  for (const std::uint64_t seed : ordinary_reloadings) visit(key_of("ordinary", seed), ordinary_case(seed));
  for (const std::uint64_t seed : extreme_reloadings) visit(key_of("extreme", seed), random_case(seed));
}

TEST(FixedResolution, GivesTheFiguresOfBefore) {
  if (std::getenv("DASHPAD_REGENERATE") != nullptr) {
    std::ofstream file(stored_runs);
    file << "# Single runs at resolution " << resolution
         << ", SI. Written by DASHPAD_REGENERATE=1 test_regression.\n";
    for_each_case([&](const std::string& key, const ImpactCase& impact) {
      file << key << ": " << text_of(line_of(impact, run_once(impact, resolution))) << '\n';
    });
    GTEST_SKIP() << "wrote " << stored_runs;
  }
  const bool exact = std::getenv("DASHPAD_EXACT") != nullptr;
  const auto before = stored_lines();
  ASSERT_EQ(before.size(), 2 * cases_of_each_kind + ordinary_reloadings.size() + extreme_reloadings.size());
  int outliers = 0;
  int other_digits = 0;
  std::string report;
  for_each_case([&](const std::string& key, const ImpactCase& impact) {
    ASSERT_TRUE(before.contains(key)) << key;
    const std::string& expected = before.at(key);
    const Line line = line_of(impact, run_once(impact, resolution));
    if (text_of(line) == expected) return;
    ++other_digits;
    if (exact) {
      report += fmt::format("{}\n  now    {}\n  before {}\n", key, text_of(line), expected);
      return;
    }
    const Line coarse = line_of(impact, run_once(impact, 2 * resolution));
    const std::string different = differences(line, coarse, numbers_of(expected));
    if (different.empty()) return;
    ++outliers;
    report += fmt::format("{} ({}):{}\n", key, line.path, different);
  });
  fmt::print("{} of {} cases with other digits than before, {} beyond a tenth of the estimate\n{}",
             other_digits, before.size(), outliers, report);
  EXPECT_LE(exact ? other_digits : outliers, exact ? 0 : max_outliers);
}

/// What the cases above are for: each law on each kind of support, and each way that a run can go.
TEST(FixedResolution, CoversLawsSupportsAndPhases) {
  std::string all;
  for (const auto& [key, line] : stored_lines()) all += line + "\n";
  for (const char* law :
       {"elastic", "linear-viscoelastic", "rigid-foam", "nine-parameter", "twenty-one-parameter"})
    for (const char* support : {"rigid", "linear", "curved"})
      EXPECT_NE(all.find(fmt::format("{} {} ", law, support)), std::string::npos) << law << " " << support;
  for (const char* way : {" released reloadings=0", " released bottomed", " bottomed-out bottomed",
                          "reloadings=1", "nine-parameter curved released reloadings="})
    EXPECT_NE(all.find(way), std::string::npos) << way;
}

}  // namespace
}  // namespace dashpad::test
