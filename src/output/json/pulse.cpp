// A pulse for programs: the figures and how they came about, alone or beside the computed ones.

#include "dashpad/output/pulse.hpp"
#include "dashpad/impact/flags.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/documents/pulse.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

Json in_g(double acceleration) { return number(acceleration / standard_gravity); }

Json figures(const injury::PulseReport& report) {
  Json all = injury_json(report.figures, false);
  Json& change = all[result_quantity("velocity_change").key];
  change["begin_s"] = number(report.contact.begin);
  change["end_s"] = number(report.contact.end);
  all["hic_windows"] = array_of(report.windows, [](const injury::WindowedHic& windowed_hic) {
    return Json{{"value", number(windowed_hic.hic.value)},
                {"begin_s", number(windowed_hic.hic.begin)},
                {"end_s", number(windowed_hic.hic.end)},
                {"longest_window_s", number(windowed_hic.longest_window)}};
  });
  all[result_quantity("dwell_time").key] = array_of(report.dwells, [](const injury::DwellTime& dwell_time) {
    return Json{{"level_g", in_g(dwell_time.level)},
                {"value_s", number(dwell_time.cumulative)},
                {"longest_s", number(dwell_time.longest)}};
  });
  return all;
}

Json column(const injury::MeasuredColumn& measured_column) {
  return {{"name", measured_column.name},
          {"number", measured_column.number > 0 ? Json(measured_column.number) : Json(nullptr)},
          {"unit", measured_column.unit},
          {"unit_origin", measured_column.unit_origin},
          {"si_factor", number(measured_column.factor)},
          {"sensitivity", text_if_any(measured_column.sensitivity)}};
}

Json filter_json(const injury::PulseFilter& pulse_filter) {
  return {{"channel_frequency_class", pulse_filter.channel_frequency_class},
          {"corner", to_string(pulse_filter.corner)},
          {"ends", to_string(pulse_filter.ends)}};
}

Json offset_json(const injury::OffsetEffect& offset_effect) {
  return {{"begin_s", number(offset_effect.offset.begin)},
          {"end_s", number(offset_effect.offset.end)},
          {"interval", offset_effect.given ? "given" : "found"},
          {"samples", offset_effect.offset.samples},
          {"mean_g", array_of(offset_effect.offset.mean, in_g)},
          {"scatter_g", array_of(offset_effect.offset.scatter, in_g)},
          {"taken_off", offset_effect.taken_off},
          {"hic15_with", number(offset_effect.hic15_with)},
          {"hic15_without", number(offset_effect.hic15_without)}};
}

Json speed_check_json(const injury::SpeedCheck& speed_check) {
  return {{"agrees", speed_check.agrees()},
          {"least_scale", number(speed_check.min_scale)},
          {"greatest_scale", number(speed_check.greatest_scale)},
          {"text", speed_check.text}};
}

Json impact(const injury::PulseReport& report) {
  if (!report.impact) return nullptr;
  return {{"speed_m_per_s", number(report.impact->speed)},
          {"drop_height_m", number(report.impact->drop_height)},
          {"gravity_m_per_s2", number(report.impact->gravity)},
          {"restitution", number(injury::restitution(report.contact, *report.impact))},
          {"check", made_of(injury::speed_check(report), speed_check_json)}};
}

Json uncertainty(const injury::MeasurementUncertainty& measurement_uncertainty) {
  Json figures = Json::object();
  for (const injury::FigureUncertainty& each : measurement_uncertainty.figures)
    figures[each.quantity->key] = {{"combined", number(each.combined())},
                                   {"sampling", number(each.sampling)},
                                   {"filter", number(each.filter)},
                                   {"calibration", number(each.calibration)}};
  return {{"coverage_factor", 2},
          {"calibration", number(measurement_uncertainty.calibration)},
          {"filter_compared_with", text_if_any(measurement_uncertainty.compared_with)},
          {"figures", figures}};
}

Json source(const injury::PulseReport& report) {
  const injury::MeasuredPulse& measured_pulse = report.measured;
  return {{"file", report.file},
          {"format", measured_pulse.format},
          {"time", column(measured_pulse.time)},
          {"acceleration", array_of(measured_pulse.acceleration, column)},
          {"resultant", measured_pulse.resultant},
          {"samples", measured_pulse.pulse.time.size()},
          {"counts_from", text_if_any(measured_pulse.counts_from)},
          {"begin_s", number(measured_pulse.pulse.time.front())},
          {"end_s", number(measured_pulse.pulse.time.back())},
          {"remarks", measured_pulse.remarks}};
}

Json compared_json(const injury::PulseComparison& comparison) {
  Json all = Json::object();
  for (const injury::ComparedFigure& compared_figure : comparison.figures) {
    const ScaledUnit unit = scaled_unit(compared_figure.quantity->si_unit, plain_si());
    const auto shown = [&](double value) { return number(unit.scale * value); };
    all[compared_figure.quantity->key] = {
        {name_with_unit("measured", unit.unit), made_of(compared_figure.measured, shown)},
        {name_with_unit("computed", unit.unit), made_of(compared_figure.computed, shown)},
        {"error", number_if(compared_figure.computed.has_value(), compared_figure.error)},
        {name_with_unit("difference", unit.unit), made_of(compared_figure.difference(), shown)},
        {"difference_share", number(compared_figure.share())}};
  }
  return all;
}

Json alignment_json(const injury::PulseComparison& pulse_comparison) {
  return {{"rule", injury::to_string(pulse_comparison.alignment)},
          {"shift_s", number(pulse_comparison.shift)},
          {"measured_onset_s", number(pulse_comparison.measured.onset)},
          {"computed_onset_s",
           pulse_comparison.computed ? number(pulse_comparison.computed->onset) : Json(nullptr)}};
}

Json pulse_json_of(const PulseComparisonReport& report) {
  const injury::PulseReport& pulse_report = report.pulse;
  const injury::PulseShape& shape = report.comparison.measured;
  return {{"file", pulse_report.file},
          {"format", pulse_report.measured.format},
          {"samples", pulse_report.pulse.time.size()},
          {"contact_begin_s", number(shape.contact.begin)},
          {"contact_end_s", number(shape.contact.end)},
          {"speed_m_per_s", pulse_report.impact ? number(pulse_report.impact->speed) : Json(nullptr)},
          {"offset_taken_off", pulse_report.offset && pulse_report.offset->taken_off},
          {"resampled_to_s", number(pulse_report.resampled_to)},
          {"filter", made_of(pulse_report.filter, filter_words)},
          {"flags", flags_json(pulse_report.flags)},
          {"remarks", pulse_report.measured.remarks}};
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
  result["offset"] = made_of(report.offset, offset_json);
  result["processing"] = {{"resampled_to_s", number(report.resampled_to)},
                          {"filter", made_of(report.filter, filter_json)},
                          {"samples", report.pulse.time.size()}};
  result["program"] = program_json();
  return result;
}

}  // namespace

std::string pulse_json(const injury::PulseReport& report) { return result_json_text(pulse(report)); }

std::string pulses_json(const std::vector<injury::PulseReport>& reports) {
  return json_text(
      array_of(reports, [](const injury::PulseReport& report) { return result_with_format(pulse(report)); }));
}

std::string pulse_comparison_json(const PulseComparisonReport& report) {
  const Summary& summary = report.solution.summary;
  Json result;
  result["answer"] = comparison_answer(report);
  result["figures"] = compared_json(report.comparison);
  result["alignment"] = alignment_json(report.comparison);
  result["case"] = {{"file", report.case_file},
                    {"status", to_string(summary.status)},
                    {"tolerance", number(summary.tolerance)},
                    {"flags", flags_json(flags(summary))}};
  result["pulse"] = pulse_json_of(report);
  result["program"] = program_json();
  return result_json_text(result);
}

}  // namespace dashpad::output
