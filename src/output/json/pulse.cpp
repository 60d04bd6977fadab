// A pulse for programs: JSON with the figures and how they came about, CSV with the samples.

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/output/pulse.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "dashpad/version.hpp"
#include "json/flags_json.hpp"
#include "json/json_values.hpp"
#include "output/json/criteria.hpp"
#include "output/json/injury.hpp"

namespace dashpad::output {

namespace {

Json in_g(double acceleration) { return number(acceleration / standard_gravity); }

Json figures(const injury::PulseReport& report) {
  Json all = injury_json(report.figures, false);
  Json& change = all[result_quantity("velocity_change").key];
  change["begin_s"] = number(report.contact.begin);
  change["end_s"] = number(report.contact.end);
  all["hic_windows"] = Json::array();
  for (const injury::WindowedHic& of : report.windows)
    all["hic_windows"].push_back({{"value", number(of.hic.value)},
                                  {"begin_s", number(of.hic.begin)},
                                  {"end_s", number(of.hic.end)},
                                  {"longest_window_s", number(of.longest_window)}});
  Json& dwells = all[result_quantity("dwell_time").key] = Json::array();
  for (const injury::DwellTime& of : report.dwells)
    dwells.push_back(
        {{"level_g", in_g(of.level)}, {"value_s", number(of.cumulative)}, {"longest_s", number(of.longest)}});
  return all;
}

Json column(const injury::MeasuredColumn& of) {
  return {{"name", of.name},
          {"number", of.number > 0 ? Json(of.number) : Json(nullptr)},
          {"unit", of.unit},
          {"unit_origin", of.unit_origin},
          {"si_factor", number(of.factor)},
          {"sensitivity", of.sensitivity.empty() ? Json(nullptr) : Json(of.sensitivity)}};
}

Json filter(const injury::PulseReport& report) {
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

Json offset(const injury::PulseReport& report) {
  if (!report.offset) return nullptr;
  const injury::OffsetEffect& of = *report.offset;
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

Json speed_check_json(const injury::PulseReport& report) {
  const std::optional<injury::SpeedCheck> check = injury::speed_check(report);
  if (!check) return nullptr;
  return {{"agrees", check->agrees()},
          {"least_scale", number(check->least_scale)},
          {"greatest_scale", number(check->greatest_scale)},
          {"text", check->text}};
}

Json impact(const injury::PulseReport& report) {
  if (!report.impact) return nullptr;
  return {{"speed_m_per_s", number(report.impact->speed)},
          {"drop_height_m", number(report.impact->drop_height)},
          {"gravity_m_per_s2", number(report.impact->gravity)},
          {"restitution", number(injury::restitution(report.contact, *report.impact))},
          {"check", speed_check_json(report)}};
}

Json uncertainty(const injury::MeasurementUncertainty& of) {
  Json figures = Json::object();
  for (const injury::FigureUncertainty& each : of.figures)
    figures[each.quantity->key] = {{"combined", number(each.combined())},
                                   {"sampling", number(each.sampling)},
                                   {"filter", number(each.filter)},
                                   {"calibration", number(each.calibration)}};
  return {{"coverage_factor", 2},
          {"calibration", number(of.calibration)},
          {"filter_compared_with", of.compared_with.empty() ? Json(nullptr) : Json(of.compared_with)},
          {"figures", figures}};
}

Json source(const injury::PulseReport& report) {
  const injury::MeasuredPulse& of = report.measured;
  Json accelerations = Json::array();
  for (const injury::MeasuredColumn& each : of.acceleration) accelerations.push_back(column(each));
  return {{"file", report.file},
          {"format", of.format},
          {"time", column(of.time)},
          {"acceleration", accelerations},
          {"resultant", of.resultant},
          {"samples", of.pulse.time.size()},
          {"counts_from", of.counts_from.empty() ? Json(nullptr) : Json(of.counts_from)},
          {"begin_s", number(of.pulse.time.front())},
          {"end_s", number(of.pulse.time.back())},
          {"remarks", of.remarks}};
}

Json pulse(const injury::PulseReport& report) {
  Json result;
  result["figures"] = figures(report);
  if (report.limits) {
    result["standard"] = report.limits->standard;
    result["verdict"] = to_string(injury::verdict_of(report.limits->results));
    result["criteria"] = criteria_json(report.limits->results);
    result["reservations"] = flags_json(report.limits->reservations);
  }
  Json about = Json::object();
  for (const auto& [what, words] : report.about) about[what] = words;
  result["about"] = std::move(about);
  result["impact"] = impact(report);
  result["uncertainty"] = uncertainty(report.uncertainty);
  result["flags"] = flags_json(report.flags);
  result["source"] = source(report);
  result["offset"] = offset(report);
  result["processing"] = {
      {"resampled_to_s", report.resampled_to ? number(*report.resampled_to) : Json(nullptr)},
      {"filter", filter(report)},
      {"samples", report.pulse.time.size()}};
  result["program"] = program_json();
  return result;
}

}  // namespace

std::string pulse_json(const injury::PulseReport& report) { return result_json_text(pulse(report)); }

std::string pulses_json(const std::vector<injury::PulseReport>& reports) {
  Json array = Json::array();
  for (const injury::PulseReport& report : reports) array.push_back(result_with_format(pulse(report)));
  return json_text(array);
}

std::string pulse_csv(const injury::PulseReport& report, const UnitSystem& units) {
  const ResultQuantity &time = result_quantity("time"), &acceleration = result_quantity("acceleration");
  const double time_factor = scaled_unit(time.si_unit, units).scale;
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{},{}\n", key_with_unit(time, units),
                 key_with_unit(acceleration, units));
  for (std::size_t i = 0; i < report.pulse.time.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", time_factor * report.pulse.time[i],
                   report.pulse.acceleration[i] / standard_gravity);
  return fmt::to_string(text);
}

}  // namespace dashpad::output
