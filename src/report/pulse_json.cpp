// A pulse for programs: JSON with the figures and how they came about, CSV with the samples.

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/report/pulse_text.hpp"
#include "dashpad/version.hpp"
#include "io/json_values.hpp"

namespace dashpad {

namespace {

Json in_g(double acceleration) { return number(acceleration / standard_gravity); }

Json hic(const Hic& of) {
  return {{"value", number(of.value)}, {"begin_s", number(of.begin)}, {"end_s", number(of.end)}};
}

Json clip(const Clip& of) {
  return {{"level_g", in_g(of.level)}, {"begin_s", number(of.begin)}, {"end_s", number(of.end)}};
}

Json figures(const PulseReport& report) {
  const InjuryFigures& of = report.figures;
  Json windows = Json::array(), dwells = Json::array();
  for (const WindowedHic& window : report.windows) {
    windows.push_back(hic(window.hic));
    windows.back()["longest_window_s"] = number(window.longest_window);
  }
  for (const DwellTime& dwell : report.dwells)
    dwells.push_back({{"level_g", in_g(dwell.level)},
                      {"cumulative_s", number(dwell.cumulative)},
                      {"longest_s", number(dwell.longest)}});
  return {{"peak", {{"acceleration_g", in_g(of.peak.magnitude)}, {"time_s", number(of.peak.time)}}},
          {"hic15", hic(of.hic15)},
          {"hic36", hic(of.hic36)},
          {"hic_unlimited", hic(of.hic_unlimited)},
          {"hic_windows", windows},
          {"hic_d", number(of.hic_d)},
          {"clip_3ms_contiguous", clip(of.contiguous_3ms)},
          {"clip_3ms_cumulative", clip(of.cumulative_3ms)},
          {"severity_index", number(of.severity_index)},
          {"dwell", dwells},
          {"velocity_change_m_per_s", number(of.velocity_change)}};
}

Json column(const MeasuredColumn& of) {
  return {{"name", of.name},
          {"number", of.number > 0 ? Json(of.number) : Json(nullptr)},
          {"unit", of.unit},
          {"unit_origin", of.unit_origin},
          {"si_factor", number(of.factor)},
          {"sensitivity", of.sensitivity.empty() ? Json(nullptr) : Json(of.sensitivity)}};
}

Json filter(const PulseReport& report) {
  if (!report.filter) return nullptr;
  return {{"channel_frequency_class", report.filter->channel_frequency_class},
          {"corner", to_string(report.filter->corner)},
          {"ends", to_string(report.filter->ends)}};
}

Json in_g(const std::vector<double>& accelerations) {
  Json each = Json::array();
  for (const double acceleration : accelerations) each.push_back(in_g(acceleration));
  return each;
}

Json offset(const PulseReport& report) {
  if (!report.offset) return nullptr;
  const OffsetEffect& of = *report.offset;
  return {{"begin_s", number(of.offset.begin)},
          {"end_s", number(of.offset.end)},
          {"interval", of.given ? "given" : "found"},
          {"samples", of.offset.samples},
          {"mean_g", in_g(of.offset.mean)},
          {"scatter_g", in_g(of.offset.scatter)},
          {"taken_off", of.taken_off},
          {"hic15_with", number(of.hic15_with)},
          {"hic15_without", number(of.hic15_without)}};
}

Json impact(const PulseReport& report) {
  if (!report.impact) return nullptr;
  return {{"speed_m_per_s", number(report.impact->speed)},
          {"drop_height_m", number(report.impact->drop_height)},
          {"restitution", number(restitution(report))}};
}

Json flags(const PulseReport& report) {
  Json all = Json::array();
  for (const Flag& flag : report.flags) all.push_back({{"name", flag.name}, {"text", flag.text}});
  return all;
}

Json source(const PulseReport& report) {
  const MeasuredPulse& of = report.measured;
  Json accelerations = Json::array();
  for (const MeasuredColumn& each : of.acceleration) accelerations.push_back(column(each));
  return {{"file", report.file},
          {"format", of.format},
          {"time", column(of.time)},
          {"acceleration", accelerations},
          {"resultant", of.resultant},
          {"samples", of.pulse.time.size()},
          {"begin_s", number(of.pulse.time.front())},
          {"end_s", number(of.pulse.time.back())},
          {"remarks", of.remarks}};
}

}  // namespace

std::string pulse_json(const PulseReport& report) {
  Json result;
  result["figures"] = figures(report);
  result["impact"] = impact(report);
  result["flags"] = flags(report);
  result["source"] = source(report);
  result["offset"] = offset(report);
  result["processing"] = {
      {"resampled_to_s", report.resampled_to ? number(*report.resampled_to) : Json(nullptr)},
      {"filter", filter(report)},
      {"samples", report.pulse.time.size()}};
  result["program"] = program_json();
  return json_text(result);
}

std::string pulse_csv(const PulseReport& report, const UnitSystem& units) {
  const double time_factor = value_in(units, 1, "s");
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "time_{},acceleration_g\n", unit_for(units, "s"));
  for (std::size_t i = 0; i < report.pulse.time.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", time_factor * report.pulse.time[i],
                   report.pulse.acceleration[i] / standard_gravity);
  return fmt::to_string(text);
}

}  // namespace dashpad
