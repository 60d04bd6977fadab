#include "input/measurement/pulse_samples.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults) {
  if (pulse.time.size() < 2) return;
  const Magnitudes times = measured_magnitudes("s"), accelerations = measured_magnitudes("m/s2");
  const double begin = pulse.time.front(), end = pulse.time.back();
  const double latest = std::max(std::abs(begin), std::abs(end));
  const double step = (end - begin) / static_cast<double>(pulse.time.size() - 1);
  if (!(latest <= times.most))
    faults.add(
        line, "time", "",
        fmt::format("reaches {:.3g} s, but must not exceed {:g} s; is the unit right?", latest, times.most));
  else if (step > 0 && step < times.least)
    faults.add(line, "time", "",
               fmt::format("the samples are {:.3g} s apart, but no sensor is sampled at intervals of "
                           "less than {:g} s; is the unit right?",
                           step, times.least));
  double peak = 0;
  for (const double value : pulse.acceleration) peak = std::max(peak, std::abs(value));
  if (!accelerations.admit(peak))
    faults.add(line, "acceleration", "",
               fmt::format("has a peak of {:.3g} m/s2, but impacts have peaks between {:g} and {:g} m/s2; is "
                           "the unit right?",
                           peak, accelerations.least, accelerations.most));
}

namespace {

constexpr double rounding = 1e-6;  // of times that were written with few digits
constexpr double max_on_even_grid = 1.5 + rounding;
constexpr double evenness = 0.25 + rounding;
constexpr std::size_t few_gaps = 3;
constexpr double max_on_any_grid = 10;
constexpr double max_of_neighbours = 3;
constexpr std::size_t max_gap_remarks = 20;

double median_step(const std::vector<double>& times) {
  std::vector<double> steps(times.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = times[i + 1] - times[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

bool is_even_but_for_gaps(const std::vector<double>& times, double usual) {
  const std::size_t count = times.size() - 1;
  std::size_t longer = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = times[i + 1] - times[i];
    if (step > max_on_even_grid * usual)
      ++longer;
    else if (std::abs(step - usual) > evenness * usual)
      return false;
  }
  return 2 * longer < count && (longer <= few_gaps || 10 * longer <= count);
}

}  // namespace

std::optional<std::pair<double, double>> interval_of_zero(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    throw UnitError("must be auto, or two times separated by a comma, such as \"0 ms,5 ms\"");
  const double begin = stated_si(text.substr(0, comma), "s"), end = stated_si(text.substr(comma + 1), "s");
  if (!(begin < end)) throw UnitError("the first time must be earlier than the second");
  return std::pair{begin, end};
}

KeptSamples kept_samples(const std::vector<double>& times, const CutTimes& cut, MeasurementFaults& faults,
                         std::vector<std::string>& remarks) {
  const double end_of_record = times.back();
  const double from = cut.from.value_or(times.front()), to = cut.to.value_or(end_of_record);
  const auto begin = std::ranges::lower_bound(times, from), end = std::ranges::upper_bound(times, to);
  const auto count = end - begin;
  const std::string range = fmt::format("from {} to {} ms", brief(1e3 * from), brief(1e3 * to));
  if (count < 2)
    faults.refuse(0, "", "",
                  fmt::format("--from, --to: there is {} {}; the record runs from {} to {} ms",
                              count < 1 ? "no sample" : "only one sample", range, brief(1e3 * times.front()),
                              brief(1e3 * end_of_record)));
  remarks.push_back(fmt::format("only the samples {} are used, {} of {}", range, count, times.size()));
  return {static_cast<std::size_t>(begin - times.begin()), static_cast<std::size_t>(end - times.begin())};
}

PulseGaps find_gaps(const std::vector<double>& times) {
  if (times.size() < 4) return {};
  PulseGaps gaps{.usual_step = median_step(times)};
  const bool even = is_even_but_for_gaps(times, gaps.usual_step);
  const double longest = (even ? max_on_even_grid : max_on_any_grid) * gaps.usual_step;
  const std::size_t count = times.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = times[i + 1] - times[i];
    if (!(step > longest)) continue;
    const double before = i > 0 ? times[i] - times[i - 1] : 0;
    const double behind = i + 1 < count ? times[i + 2] - times[i + 1] : 0;
    if (even || step > max_of_neighbours * std::max(before, behind)) gaps.all.push_back({i, step});
  }
  return gaps;
}

void judge_gaps(const std::vector<double>& times, const std::vector<std::uint32_t>& lines,
                const std::string& name, bool bridge, MeasurementFaults& faults,
                std::vector<std::string>& remarks) {
  const PulseGaps gaps = find_gaps(times);
  const auto line_of = [&](std::size_t sample) { return lines.empty() ? 0 : lines[sample]; };
  const auto words = [&](const PulseGap& gap) {
    const std::size_t next = gap.after + 1;
    const std::string between =
        lines.empty() ? fmt::format("between {:.6g} and {:.6g} ms", 1e3 * times[gap.after], 1e3 * times[next])
                      : fmt::format("between lines {} and {}", lines[gap.after], lines[next]);
    return fmt::format("gap of {:.6g} ms {}", 1e3 * gap.length, between);
  };
  if (!bridge)
    for (const PulseGap& gap : gaps.all)
      faults.add(line_of(gap.after + 1), name, "",
                 fmt::format("has a {} (typical step: {:.6g} ms); --bridge-gaps interpolates linearly",
                             words(gap), 1e3 * gaps.usual_step));
  for (std::size_t i = 0; i < std::min(gaps.all.size(), max_gap_remarks); ++i)
    remarks.push_back("the " + words(gaps.all[i]) + " was bridged by linear interpolation");
  if (gaps.all.size() > max_gap_remarks)
    remarks.push_back(fmt::format("in all, {} gaps were bridged by linear interpolation", gaps.all.size()));
}

}  // namespace dashpad::input
