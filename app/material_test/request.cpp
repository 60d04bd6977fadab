// The options of dashpad material-test.

#include "material_test/request.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/quantities/quantity.hpp"

namespace dashpad::app {

namespace {

constexpr double lowest_rate = 1e-12;  // 1/s; a test that takes 30,000 years
constexpr double highest_rate = 1e9;   // 1/s, as in cards
// Closer to 1, 1 - strain has too few digits left for the quadrature along a parabola to end.
constexpr double least_strain = 1e-12, most_strain = 0.999999;

using Text = std::optional<std::string>;
using Wrong = std::vector<std::string>;

laboratory::TestKind kind_of(const std::string& name) {
  return *std::ranges::find_if(laboratory::all_test_kinds,
                               [&](laboratory::TestKind kind) { return name == to_string(kind); });
}

/// A number alone is in 1/s.
std::string with_unit_of_rate(const std::string& text) {
  const bool is_number = text.find_first_not_of("0123456789.eE+- ") == std::string::npos;
  return is_number && !text.empty() ? text + " 1/s" : text;
}

/// A quantity between two values, both excluded; `rule` says so. Keeps `fallback` where there is no text, or
/// where it is wrong, of which `wrong` is told.
double quantity(const std::string& option, const Text& text, const char* si_unit, double low, double high,
                const char* rule, double fallback, Wrong& wrong) {
  if (!text) return fallback;
  try {
    const double value = to_si(std::string{si_unit} == "1/s" ? with_unit_of_rate(*text) : *text, si_unit);
    if (value > low && value < high) return value;
    wrong.push_back(fmt::format("{} {}: {}", option, *text, rule));
  } catch (const UnitError& error) {
    wrong.push_back(fmt::format("{} {}: {}", option, *text, error.what()));
  }
  return fallback;
}

std::vector<double> rates_of(const MaterialTestRequest& request, Wrong& wrong) {
  std::vector<double> rates;
  for (const std::string& text : request.rates) {
    const std::size_t before = wrong.size();
    const double rate = quantity("--rate", text, "1/s", lowest_rate, highest_rate,
                                 "must be more than 1e-12 and less than 1e9 per second", 1, wrong);
    if (wrong.size() > before) continue;
    if (std::ranges::find(rates, rate) != rates.end())
      wrong.push_back(fmt::format("--rate {}: is named twice", text));
    rates.push_back(rate);
  }
  return rates;
}

/// Options that mean nothing for the kind of test, and those that it lacks.
void judge_options(const MaterialTestRequest& request, laboratory::TestKind kind, Wrong& wrong) {
  const auto only_for = [&](bool given, const char* option,
                            std::initializer_list<laboratory::TestKind> kinds) {
    if (!given || std::ranges::find(kinds, kind) != kinds.end()) return;
    std::string names;
    for (const laboratory::TestKind each : kinds)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", to_string(each));
    wrong.push_back(fmt::format("{}: is not for --test {}, but for {}", option, to_string(kind), names));
  };
  using enum laboratory::TestKind;
  only_for(!request.rates.empty(), "--rate", {constant_rate, parabolic, relaxation, creep, cyclic});
  only_for(request.strain.has_value(), "--strain", {constant_rate, parabolic, relaxation, cyclic});
  only_for(request.hold.has_value(), "--hold", {relaxation, creep});
  only_for(request.stress.has_value(), "--stress", {creep});
  only_for(request.low.has_value(), "--low", {cyclic});
  only_for(request.cycles.has_value(), "--cycles", {cyclic});
  only_for(request.history.has_value(), "--history", {history});
  if (request.explicit_1984 && kind == creep)
    wrong.emplace_back(
        "--explicit-1984: is not for --test creep; the update of 1984 is driven by strains, "
        "and creep by a stress");
  if (request.steps && !request.explicit_1984)
    wrong.emplace_back("--steps: is for the update of 1984; add --explicit-1984");
  if (kind == creep && !request.stress)
    wrong.emplace_back("--test creep: needs --stress, such as \"50 kPa\"");
  if (kind == history && !request.history) wrong.emplace_back("--test history: needs --history FILE");
}

/// Tells of the first step of a history that is too fast.
void judge_rates(const laboratory::MaterialTest& test, Wrong& wrong) {
  for (std::size_t i = 1; i < test.times.size(); ++i) {
    const double rate = std::abs(test.strains[i] - test.strains[i - 1]) / (test.times[i] - test.times[i - 1]);
    if (rate < highest_rate) continue;
    wrong.push_back(
        fmt::format("{}: between {} s and {} s the strain rate is {:.3g} per second; it must be less "
                    "than 1e9 per second",
                    test.history_name, test.times[i - 1], test.times[i], rate));
    return;
  }
}

void read_history(const std::string& file, laboratory::MaterialTest& test, Wrong& wrong) {
  test.history_name = file;
  if (auto table = taken(input::read_strain_csv(file), wrong)) {
    test.times = std::move(table->time);
    test.strains = std::move(table->strain);
    test.history_remarks = std::move(table->remarks);
    judge_rates(test, wrong);
  }
}

}  // namespace

laboratory::MaterialTest test_of(const MaterialTestRequest& request, Wrong& wrong) {
  laboratory::MaterialTest test;
  test.kind = kind_of(request.test);
  judge_options(request, test.kind, wrong);
  if (!request.rates.empty()) test.rates = rates_of(request, wrong);
  const char* const strain_rule = "must be more than 1e-12 and less than 0.999999";
  test.strain =
      quantity("--strain", request.strain, "1", least_strain, most_strain, strain_rule, test.strain, wrong);
  test.hold = quantity("--hold", request.hold, "s", 0, 1e9, "must be more than 0 and less than 1e9 s",
                       test.hold, wrong);
  test.stress = quantity("--stress", request.stress, "Pa", 0, 1e12, "must be more than 0 and less than 1 TPa",
                         1, wrong);
  test.low = quantity("--low", request.low, "1", -1e-300, test.strain,
                      "must be at least 0 and less than --strain", test.low, wrong);
  test.cycles = request.cycles.value_or(test.cycles);
  for (const std::string& text : request.stress_limits)
    test.stress_limits.push_back(
        quantity("--stress-limit", text, "Pa", 0, 1e12, "must be more than 0 and less than 1 TPa", 1, wrong));
  if (request.explicit_1984) test.steps_of_1984 = request.steps.value_or(20);
  if (request.history && test.kind == laboratory::TestKind::history)
    read_history(*request.history, test, wrong);
  return test;
}

void add_test_options(CLI::App& sub, MaterialTestRequest& request) {
  std::vector<std::string> kinds;
  for (const laboratory::TestKind kind : laboratory::all_test_kinds) kinds.emplace_back(to_string(kind));
  sub.add_option("--test", request.test,
                 "constant-rate (default), parabolic, relaxation, creep, cyclic or history")
      ->check(CLI::IsMember(kinds))
      ->type_name("KIND");
  sub.add_option("--rate", request.rates, "Strain rates of loading, 1/s or with unit (default: 1,100)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  sub.add_option("--strain", request.strain, "Largest strain, below 1 (default: 0.95)")->type_name("X");
  sub.add_option("--hold", request.hold,
                 "How long to hold, such as \"1 s\" (relaxation, creep; default: 1 s)")
      ->type_name("TIME");
  sub.add_option("--stress", request.stress, "Stress to hold, such as \"50 kPa\" (creep)")
      ->type_name("STRESS");
  sub.add_option("--low", request.low, "Strain to unload to (cyclic; default: 0)")->type_name("X");
  sub.add_option("--cycles", request.cycles, "How many (cyclic; default: 3)")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  sub.add_option("--history", request.history, "Table of times and strains, CSV (history)")
      ->type_name("FILE");
  sub.add_option(
         "--stress-limit", request.stress_limits,
         "Energy and efficiency where the stress reaches this, such as \"100 kPa\"; several with commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  sub.add_flag("--explicit-1984", request.explicit_1984,
               "The explicit update of 1984 beside the exact stress (not creep)")
      ->disable_flag_override();
  sub.add_option("--steps", request.steps, "Of the update of 1984, to the first loading (default: 20)")
      ->check(CLI::Range(1, 10000))
      ->type_name("N");
}

}  // namespace dashpad::app
