// dashpad material-test: laboratory tests of a pad material.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "dashpad/spit1984/run.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

constexpr const char* material_test_footer = R"(Examples:
  dashpad material-test ensolite-aac-9                    loading and unloading at 1 and 100 per second
  dashpad material-test ensolite-aac-9 --test parabolic --explicit-1984 --picture figure-2-9.svg
  dashpad material-test ensolite-aac-21 --rate 1,10,100 --stress-limit "50 kPa,100 kPa"
  dashpad material-test ensolite-aac-21 --test relaxation --strain 0.5 --hold "2 s"
  dashpad material-test ensolite-aac-9 --test creep --stress "50 kPa" --hold "100 ms"
  dashpad material-test ensolite-aac-9 --test cyclic --strain 0.6 --low 0.2 --cycles 3 --csv cycles.csv
  dashpad material-test ./my-foam.toml --test history --history my-strains.csv --report my-foam.html

The test is applied to a single column of the pad, whose stress is exact apart from quadrature errors. Results: peak
stress, energy per volume, hysteresis, efficiency and ideality; with --stress-limit, also the energy absorbed up to
a given stress. --explicit-1984 adds the result of the 1984 program. docs/laboratory.md explains all of these.

MATERIAL is the name of a card as listed by dashpad materials, or a file whose name ends in .toml. A history is a
table with a header line that names the columns and their units: time_s,strain or "time [ms];strain [%]".

Files: - as FILE of --json or --csv means standard output; the text then goes to standard error. An existing file is
not overwritten unless --force is given. A file is written completely or not at all.

Exit codes: 0 success, 1 a result could not be written, 2 invalid input (nothing was run).)";

/// The options as given.
struct MaterialTestRequest {
  std::string material;
  std::string test = "constant-rate";
  std::vector<std::string> rates, stress_limits;
  std::optional<std::string> strain, hold, stress, low, history, thickness;
  std::optional<int> cycles, steps;
  bool explicit_1984 = false;
  OutputFiles files;
  std::string materials;
};

constexpr double lowest_rate = 1e-12;  // 1/s: a test of 30,000 years
constexpr double highest_rate = 1e9;   // 1/s, as in cards
// Nearer to 1, 1 - strain has too few digits for the quadrature along a parabola to end.
constexpr double min_strain = 1e-12, max_strain = 0.999999;

using Text = std::optional<std::string>;
using Wrong = std::vector<std::string>;

/// A number alone is in 1/s.
std::string with_unit_of_rate(const std::string& text) {
  const bool is_number = text.find_first_not_of("0123456789.eE+- ") == std::string::npos;
  return is_number && !text.empty() ? text + " 1/s" : text;
}

/// A quantity between two exclusive bounds; else `rule` is broken. `fallback` without text or on error.
double quantity(const std::string& option, const Text& text, const char* si_unit, double low, double high,
                const char* rule, double fallback, Wrong& errors) {
  if (!text) return fallback;
  try {
    const double value = to_si(std::string{si_unit} == "1/s" ? with_unit_of_rate(*text) : *text, si_unit);
    if (value > low && value < high) return value;
    errors.push_back(fmt::format("{} {}: {}", option, *text, rule));
  } catch (const UnitError& error) {
    errors.push_back(fmt::format("{} {}: {}", option, *text, error.what()));
  }
  return fallback;
}

std::vector<double> rates_of(const MaterialTestRequest& request, Wrong& errors) {
  std::vector<double> rates;
  for (const std::string& text : request.rates) {
    const std::size_t before = errors.size();
    const double rate = quantity("--rate", text, "1/s", lowest_rate, highest_rate,
                                 "must be more than 1e-12 and less than 1e9 per second", 1, errors);
    if (errors.size() > before) continue;
    if (std::ranges::find(rates, rate) != rates.end())
      errors.push_back(fmt::format("--rate {}: is given twice", text));
    rates.push_back(rate);
  }
  return rates;
}

/// Reports options that do not apply to the kind of test, and missing ones.
void judge_options(const MaterialTestRequest& request, laboratory::TestKind kind, Wrong& errors) {
  const auto only_for = [&](bool given, const char* option,
                            std::initializer_list<laboratory::TestKind> kinds) {
    if (!given || std::ranges::find(kinds, kind) != kinds.end()) return;
    std::string names;
    for (const laboratory::TestKind each : kinds)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", to_string(each));
    errors.push_back(
        fmt::format("{}: does not apply to --test {}, only to {}", option, to_string(kind), names));
  };
  using enum laboratory::TestKind;
  only_for(!request.rates.empty(), "--rate", {constant_rate, parabolic, relaxation, creep, cyclic});
  only_for(request.thickness.has_value(), "--thickness", {history});
  only_for(request.strain.has_value(), "--strain", {constant_rate, parabolic, relaxation, cyclic});
  only_for(request.hold.has_value(), "--hold", {relaxation, creep});
  only_for(request.stress.has_value(), "--stress", {creep});
  only_for(request.low.has_value(), "--low", {cyclic});
  only_for(request.cycles.has_value(), "--cycles", {cyclic});
  only_for(request.history.has_value(), "--history", {history});
  if (request.explicit_1984 && kind == creep)
    errors.emplace_back(
        "--explicit-1984: does not apply to --test creep; the 1984 update needs prescribed strains, "
        "whereas creep prescribes the stress");
  if (request.steps && !request.explicit_1984)
    errors.emplace_back("--steps: applies only to the 1984 update; add --explicit-1984");
  if (kind == creep && !request.stress)
    errors.emplace_back("--test creep: needs --stress, such as \"50 kPa\"");
  if (kind == history && !request.history) errors.emplace_back("--test history: needs --history FILE");
}

/// Reports the first step of a history that is too fast.
void judge_rates(const laboratory::MaterialTest& test, Wrong& errors) {
  for (std::size_t i = 1; i < test.times.size(); ++i) {
    const double rate = std::abs(test.strains[i] - test.strains[i - 1]) / (test.times[i] - test.times[i - 1]);
    if (rate < highest_rate) continue;
    errors.push_back(
        fmt::format("{}: between {} s and {} s the strain rate is {:.3g} per second; it must be less "
                    "than 1e9 per second",
                    test.history_name, test.times[i - 1], test.times[i], rate));
    return;
  }
}

void read_history(const std::string& file, const std::optional<double>& thickness,
                  laboratory::MaterialTest& test, Wrong& errors) {
  test.history_name = file;
  if (auto table = taken(input::read_strain_csv(file, {.thickness = thickness}), errors)) {
    test.times = std::move(table->time);
    test.strains = std::move(table->strain);
    test.history_remarks = std::move(table->remarks);
    judge_rates(test, errors);
  }
}

/// The test; errors include those of the rows of the history.
laboratory::MaterialTest test_of(const MaterialTestRequest& request, Wrong& errors) {
  laboratory::MaterialTest test;
  test.kind = *std::ranges::find_if(
      laboratory::all_test_kinds, [&](laboratory::TestKind kind) { return request.test == to_string(kind); });
  judge_options(request, test.kind, errors);
  if (!request.rates.empty()) test.rates = rates_of(request, errors);
  const char* const strain_rule = "must be more than 1e-12 and less than 0.999999";
  test.strain =
      quantity("--strain", request.strain, "1", min_strain, max_strain, strain_rule, test.strain, errors);
  test.hold = quantity("--hold", request.hold, "s", 0, 1e9, "must be more than 0 and less than 1e9 s",
                       test.hold, errors);
  test.stress = quantity("--stress", request.stress, "Pa", 0, 1e12, "must be more than 0 and less than 1 TPa",
                         1, errors);
  test.low = quantity("--low", request.low, "1", -1e-300, test.strain,
                      "must be at least 0 and less than --strain", test.low, errors);
  test.cycles = request.cycles.value_or(test.cycles);
  for (const std::string& text : request.stress_limits)
    test.stress_limits.push_back(quantity("--stress-limit", text, "Pa", 0, 1e12,
                                          "must be more than 0 and less than 1 TPa", 1, errors));
  if (request.explicit_1984) test.steps_of_1984 = request.steps.value_or(20);
  if (request.history && test.kind == laboratory::TestKind::history)
    read_history(*request.history, positive_quantity_of("--thickness", request.thickness, "m", errors), test,
                 errors);
  return test;
}

void add_test_options(CLI::App& sub, MaterialTestRequest& request) {
  std::vector<std::string> kinds;
  for (const laboratory::TestKind kind : laboratory::all_test_kinds) kinds.emplace_back(to_string(kind));
  add_option(sub, "--test KIND", request.test,
             "constant-rate (default), parabolic, relaxation, creep, cyclic or history")
      ->check(CLI::IsMember(kinds));
  add_option(sub, "--rate LIST", request.rates,
             "Loading strain rates, comma-separated, in 1/s unless given with a unit (default: 1 and 100)")
      ->delimiter(',');
  add_option(sub, "--strain X", request.strain, "Largest strain, less than 1 (default: 0.95)");
  add_option(sub, "--hold TIME", request.hold,
             "Hold time, such as \"1 s\" (relaxation, creep; default: 1 s)");
  add_option(sub, "--stress STRESS", request.stress, "Stress to hold, such as \"50 kPa\" (creep)");
  add_option(sub, "--low X", request.low, "Strain to unload to (cyclic; default: 0)");
  add_option(sub, "--cycles N", request.cycles, "Number of cycles (cyclic; default: 3)")
      ->check(CLI::Range(1, 1000));
  add_option(sub, "--history FILE", request.history, "Table of times and strains or displacements (history)");
  add_option(sub, "--thickness LENGTH", request.thickness,
             "Specimen thickness, needed for displacements (history)");
  add_option(sub, "--stress-limit LIST", request.stress_limits,
             "Stresses at which to give energy and efficiency, comma-separated, such as \"50 kPa,100 kPa\"")
      ->delimiter(',');
  add_flag(sub, "--explicit-1984", request.explicit_1984,
           "Add the stress from the explicit 1984 update (not for creep)");
  add_option(sub, "--steps N", request.steps, "Steps of the 1984 update in the first loading (default: 20)")
      ->check(CLI::Range(1, 10000));
}

/// Throws Refused with all errors.
laboratory::MaterialTestReport run_test(const MaterialTestRequest& request) {
  std::vector<std::string> errors;
  const std::optional<std::filesystem::path> card =
      find_card(request.material, chosen_folder(request.materials), errors);
  std::vector<input::InputFile> files;
  if (card) files.push_back({"the material card", *card});
  if (request.history) files.push_back({"the strain history", *request.history});
  judge_files(request.files, files, errors);
  judge_picture(request.files, errors);
  const laboratory::MaterialTest test = test_of(request, errors);
  const std::optional<Material> material = card ? taken(input::read_material(*card), errors) : std::nullopt;
  if (!errors.empty()) throw Refused(std::move(errors));
  try {
    const ProgressLine line{"Testing the material"};
    return laboratory::run_material_test(*material, test, spit1984::stresses_of_update);
  } catch (const std::invalid_argument& error) {
    throw Refused({fmt::format("--test {}: {}", request.test, error.what())});
  }
}

int show(const MaterialTestRequest& request) {
  const laboratory::MaterialTestReport report = run_test(request);
  const UnitSystem& units = unit_system(request.files.units);
  publish(request.files,
          [&](output::Pictures pictures) { return output::material_test_document(report, units, pictures); },
          {{"--json", [&](const Target&) { return output::material_test_json(report); }},
           {"--csv", [&](const Target&) { return output::material_test_csv(report, units_of_files(units)); }},
           {"--picture", [&](const Target& target) {
              return picture_text(output::material_test_plot(report, units), target);
            }}});
  return exit_done;
}

}  // namespace

void add_material_test(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<MaterialTestRequest>(
      app, action, "material-test", "Simulate a laboratory test of a pad material", material_test_footer,
      show);
  add_option(sub, "MATERIAL", request.material, "Name of a card, or a card file (.toml)")->required();
  add_test_options(sub, request);
  add_file(sub, request.files, "--json", "Write everything as JSON, in SI units (- for standard output)");
  add_file(sub, request.files, "--csv", "Write the stresses as CSV (- for standard output)");
  add_documents(sub, request.files);
  add_file(sub, request.files, "--picture", "Draw stress and efficiency (.svg, .png, .pdf)");
  add_units(sub, request.files.units);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.materials);
}

}  // namespace dashpad::app
