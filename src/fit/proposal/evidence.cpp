// Reading compression tests for a proposal, and what they show.

#include "fit/proposal/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "fit/fit_tables.hpp"
#include "input/disk.hpp"
#include "input/material_deck/test_parts.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {

namespace {

constexpr double min_rise = 1.05;      ///< of the stress from the beginning on
constexpr double noisy_strain = 0.05;  ///< share of the points of a loading that go back
constexpr double lost_all = 0.01;      ///< of the largest stress: the foam no longer presses

/// The energy along points, per volume, J/m3.
double work_along(const MaterialMeasurement& test, const std::vector<std::size_t>& points) {
  double work = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    work += (test.stress[points[i]] + test.stress[points[i - 1]]) / 2 *
            (test.strain[points[i]] - test.strain[points[i - 1]]);
  return work;
}

/// The stress a tenth of the points into the loading, Pa.
double stress_at_beginning(const MaterialMeasurement& test, const input::TestParts& parts) {
  return test.stress[parts.loading[parts.loading.size() / 10]];
}

input::DeckCurve curve_of(const MaterialMeasurement& test) {
  input::DeckCurve curve{.name = test.file};
  for (std::size_t i = 0; i < test.strain.size(); ++i) curve.add(test.strain[i], test.stress[i], i);
  return curve;
}

Evidence evidence_of(const MaterialMeasurement& test, const input::TestParts& parts) {
  Evidence shown{.file = test.file,
                 .highest_strain = std::ranges::max(test.strain),
                 .largest_stress = std::ranges::max(test.stress),
                 .first_stress = test.stress.front(),
                 .loading_points = parts.loading.size(),
                 .has_cycles = parts.cycle.has_value()};
  const std::size_t first = parts.loading.front();
  const double seconds = test.time[parts.top] - test.time[first];
  if (seconds > 0) shown.rate = (test.strain[parts.top] - test.strain[first]) / seconds;
  for (const input::Hold& hold : parts.holds) {
    shown.lost_held = std::max(shown.lost_held.value_or(0), hold.lost);
    shown.time_held = std::max(shown.time_held, test.time[hold.last] - test.time[hold.first]);
  }
  if (parts.back.empty()) return shown;
  std::vector<std::size_t> back{parts.top};
  back.insert(back.end(), parts.back.begin(), parts.back.end());
  const double taken_in = work_along(test, parts.loading);
  if (taken_in > 0) shown.returned = std::clamp(-work_along(test, back) / taken_in, 0.0, 1.0);
  const auto gone = std::ranges::find_if(
      back, [&](std::size_t i) { return test.stress[i] <= lost_all * shown.largest_stress; });
  if (gone != back.end()) shown.strain_left = test.strain[*gone];
  return shown;
}

/// One test of a file; absent after a fault.
std::optional<MaterialMeasurement> read_source(const TestSource& source, std::string name,
                                               std::vector<input::Fault>& faults) {
  auto read = taken(input::read_stress_strain_csv(source.file, source.columns), faults);
  if (!read) return std::nullopt;
  MaterialMeasurement test;
  test.file = std::move(name);
  take_points(*std::move(read), source.rate, test);
  return test;
}

/// The tests that a file names; none after a fault.
std::vector<TestSource> sources_in(const std::filesystem::path& file, std::optional<double> rate,
                                   const input::StressStrainColumns& wanted,
                                   std::vector<input::Fault>& faults) {
  const auto header = taken(input::read_test_header(file, wanted), faults);
  if (!header) return {};
  std::vector<TestSource> sources;
  for (const input::TestHeader::Stress& stress : header->stresses) {
    TestSource source{.file = file, .columns = wanted, .rate = rate};
    if (header->stresses.size() > 1) source.columns.stress = stress.name;
    if (stress.rate > 0) {
      if (rate && *rate != stress.rate)
        faults.push_back(
            {file.string(), 0, stress.name, "",
             fmt::format("the header gives {:g} 1/s, but --rate gives {:g} 1/s", stress.rate, *rate)});
      source.rate = stress.rate;
    }
    if (!wanted.time.empty() && source.rate)
      faults.push_back({file.string(), 0, "", "", "give its rate or --time, not both"});
    if (!source.rate && wanted.time.empty()) source.columns.time = header->time;
    if (!source.rate && source.columns.time.empty())
      faults.push_back(
          {file.string(), 0, "", "",
           "its strain rate is not stated and it has no times; give --rate \"0.01 1/s\", one for "
           "each file in their order, or name the column of times with --time"});
    if (!source.rate && source.columns.time.empty()) source.rate = 1;  // to find the other faults
    sources.push_back(std::move(source));
  }
  return sources;
}

/// The stress of a loading near a strain, Pa.
double stress_near(const MaterialMeasurement& test, double strain) {
  const auto reached = std::ranges::find_if(test.strain, [&](double each) { return each >= strain; });
  return reached == test.strain.end() ? no_value
                                      : test.stress[static_cast<std::size_t>(reached - test.strain.begin())];
}

/// Faults of tests that are far softer than slower ones: no foam is so, but files in another order than their
/// rates are.
void judge_order(const ReadTests& tests, std::vector<input::Fault>& faults) {
  constexpr double far_softer = 0.8;
  for (std::size_t i = 0; i < tests.evidence.size(); ++i)
    for (std::size_t j = 0; j < tests.evidence.size(); ++j) {
      const Evidence &fast = tests.evidence[i], &slow = tests.evidence[j];
      if (fast.rate < 2 * slow.rate) continue;
      const double strain = std::min(fast.highest_strain, slow.highest_strain) / 2;
      const double ratio =
          stress_near(tests.measurements[i], strain) / stress_near(tests.measurements[j], strain);
      if (!(ratio < far_softer)) continue;
      faults.push_back(
          {tests.sources[i].file.string(), 0, "", "",
           fmt::format(
               "at a strain of {:.2g} its stress is {:.2g} times that in {}, although its rate is higher "
               "({:.3g} and {:.3g} 1/s): are the rates in the order of the files, and the foams the same?",
               strain, ratio, slow.file, fast.rate, slow.rate)});
    }
}

}  // namespace

ReadTests read_tests(const std::vector<std::filesystem::path>& files, std::span<const double> rates,
                     const input::StressStrainColumns& wanted, std::vector<input::Fault>& faults) {
  ReadTests tests;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::optional<double> rate = i < rates.size() ? std::optional{rates[i]} : std::nullopt;
    std::vector<TestSource> sources = sources_in(files[i], rate, wanted, faults);
    const auto is_same = [&](const std::filesystem::path& other) {
      return input::is_same_file(files[i], other);
    };
    if (std::any_of(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(i), is_same))
      faults.push_back({files[i].string(), 0, "", "", "is given twice; one test counts once"});
    const std::string name = input::to_utf8(files[i].filename().string());
    for (TestSource& source : sources) {
      auto test =
          read_source(source, sources.size() > 1 ? name + ", " + source.columns.stress : name, faults);
      if (!test) continue;
      const input::TestParts parts = input::parts_of(curve_of(*test));
      Evidence shown = evidence_of(*test, parts);
      if (shown.rate > 0) shown.rate = source.rate.value_or(shown.rate);
      if (!(shown.rate > 0))
        faults.push_back(
            {files[i].string(), 0, "", "", "no loading from a smaller to a larger strain was found"});
      else if (shown.largest_stress <= min_rise * stress_at_beginning(*test, parts))
        faults.push_back({files[i].string(), 0, "", "",
                          "its stress hardly rises with the strain: that is no compression test"});
      else if (shown.lost_held && source.columns.time.empty())
        faults.push_back(
            {files[i].string(), 0, "", "",
             fmt::format("the strain is held while the stress falls by {:.2g} %: that needs the times; name "
                         "their column with --time, or cut off the hold",
                         100 * *shown.lost_held)});
      if (static_cast<double>(parts.noisy) > noisy_strain * static_cast<double>(parts.loading.size()))
        test->remarks.push_back(fmt::format(
            "the strain goes back at {} of {} points of the loading, and the fit follows it, which hides "
            "hysteresis and holds; smooth the strains first",
            parts.noisy, parts.loading.size()));
      tests.evidence.push_back(std::move(shown));
      tests.measurements.push_back(*std::move(test));
      tests.sources.push_back(std::move(source));
    }
  }
  if (faults.empty()) judge_order(tests, faults);
  return tests;
}

}  // namespace dashpad::fit
