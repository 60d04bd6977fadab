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
  all["hic_windows"] = array_of(report.windows, [](const injury::WindowedHic& windowed) {
    return Json{{"value", number(windowed.hic.value)},
                {"begin_s", number(windowed.hic.begin)},
                {"end_s", number(windowed.hic.end)},
                {"longest_window_s", number(windowed.longest_window)}};
  });
  all[result_quantity("dwell_time").key] = array_of(report.dwells, [](const injury::DwellTime& dwell) {
    return Json{{"level_g", in_g(dwell.level)},
                {"value_s", number(dwell.cumulative)},
                {"longest_s", number(dwell.longest)}};
  });
  return all;
}

Json column(const injury::MeasuredColumn& column) {
  return {{"name", column.name},
          {"number", column.number > 0 ? Json(column.number) : Json(nullptr)},
          {"unit", column.unit},
          {"unit_origin", column.unit_origin},
          {"si_factor", number(column.factor)},
          {"sensitivity", text_if_any(column.sensitivity)}};
}

Json filter_json(const injury::PulseFilter& filter) {
  return {{"channel_frequency_class", filter.channel_frequency_class},
          {"corner", to_string(filter.corner)},
          {"ends", to_string(filter.ends)}};
}

Json offset_json(const injury::OffsetEffect& effect) {
  return {{"begin_s", number(effect.offset.begin)},
          {"end_s", number(effect.offset.end)},
          {"interval", effect.given ? "given" : "found"},
          {"samples", effect.offset.samples},
          {"mean_g", array_of(effect.offset.mean, in_g)},
          {"scatter_g", array_of(effect.offset.scatter, in_g)},
          {"taken_off", effect.taken_off},
          {"hic15_with", number(effect.hic15_with)},
          {"hic15_without", number(effect.hic15_without)}};
}

Json speed_check_json(const injury::SpeedCheck& check) {
  return {{"agrees", check.agrees()},
          {"least_scale", number(check.min_scale)},
          {"greatest_scale", number(check.greatest_scale)},
          {"text", check.text}};
}

Json impact(const injury::PulseReport& report) {
  if (!report.impact) return nullptr;
  return {{"speed_m_per_s", number(report.impact->speed)},
          {"drop_height_m", number(report.impact->drop_height)},
          {"gravity_m_per_s2", number(report.impact->gravity)},
          {"restitution", number(injury::restitution(report.contact, *report.impact))},
          {"check", made_of(injury::speed_check(report), speed_check_json)}};
}

Json uncertainty(const injury::MeasurementUncertainty& uncertainty) {
  Json figures = Json::object();
  for (const injury::FigureUncertainty& each : uncertainty.figures)
    figures[each.quantity->key] = {{"combined", number(each.combined())},
                                   {"sampling", number(each.sampling)},
                                   {"filter", number(each.filter)},
                                   {"calibration", number(each.calibration)}};
  return {{"coverage_factor", 2},
          {"calibration", number(uncertainty.calibration)},
          {"filter_compared_with", text_if_any(uncertainty.compared_with)},
          {"figures", figures}};
}

Json source(const injury::PulseReport& report) {
  const injury::MeasuredPulse& measured = report.measured;
  return {{"file", report.file},
          {"format", measured.format},
          {"time", column(measured.time)},
          {"acceleration", array_of(measured.acceleration, column)},
          {"resultant", measured.resultant},
          {"samples", measured.pulse.time.size()},
          {"counts_from", text_if_any(measured.counts_from)},
          {"begin_s", number(measured.pulse.time.front())},
          {"end_s", number(measured.pulse.time.back())},
          {"remarks", measured.remarks}};
}

Json compared_json(const injury::PulseComparison& comparison) {
  Json all = Json::object();
  for (const injury::ComparedFigure& figure : comparison.figures) {
    const ScaledUnit unit = scaled_unit(figure.quantity->si_unit, plain_si());
    const auto shown = [&](double value) { return number(unit.scale * value); };
    all[figure.quantity->key] = {
        {name_with_unit("measured", unit.unit), made_of(figure.measured, shown)},
        {name_with_unit("computed", unit.unit), made_of(figure.computed, shown)},
        {"error", number_if(figure.computed.has_value(), figure.error)},
        {name_with_unit("difference", unit.unit), made_of(figure.difference(), shown)},
        {"difference_share", number(figure.share())}};
  }
  return all;
}

Json alignment_json(const injury::PulseComparison& comparison) {
  return {{"rule", injury::to_string(comparison.alignment)},
          {"shift_s", number(comparison.shift)},
          {"measured_onset_s", number(comparison.measured.onset)},
          {"computed_onset_s", comparison.computed ? number(comparison.computed->onset) : Json(nullptr)}};
}

Json pulse_json_of(const PulseComparisonReport& report) {
  const injury::PulseReport& pulse = report.pulse;
  const injury::PulseShape& shape = report.comparison.measured;
  return {{"file", pulse.file},
          {"format", pulse.measured.format},
          {"samples", pulse.pulse.time.size()},
          {"contact_begin_s", number(shape.contact.begin)},
          {"contact_end_s", number(shape.contact.end)},
          {"speed_m_per_s", pulse.impact ? number(pulse.impact->speed) : Json(nullptr)},
          {"offset_taken_off", pulse.offset && pulse.offset->taken_off},
          {"resampled_to_s", number(pulse.resampled_to)},
          {"filter", made_of(pulse.filter, filter_words)},
          {"flags", flags_json(pulse.flags)},
          {"remarks", pulse.measured.remarks}};
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
