// A measured pulse beside the computed one, for programs.

#include "dashpad/output/pulse_comparison.hpp"

#include "dashpad/impact/flags.hpp"
#include "json/flags_json.hpp"
#include "json/json_values.hpp"
#include "output/documents/pulse.hpp"
#include "output/documents/pulse_comparison.hpp"

namespace dashpad::output {

namespace {

Json compared_json(const injury::PulseComparison& comparison) {
  Json all = Json::object();
  for (const injury::ComparedFigure& of : comparison.figures) {
    const ScaledUnit unit = scaled_unit(of.quantity->si_unit, plain_si());
    const auto scaled = [&](std::optional<double> value) {
      if (value) *value *= unit.scale;
      return number(value);
    };
    all[of.quantity->key] = {{name_with_unit("measured", unit.unit), scaled(of.measured)},
                             {name_with_unit("computed", unit.unit), scaled(of.computed)},
                             {"error", number_if(of.computed.has_value(), of.error)},
                             {name_with_unit("difference", unit.unit), scaled(of.difference())},
                             {"difference_share", number(of.share())}};
  }
  return all;
}

Json alignment_json(const injury::PulseComparison& of) {
  return {{"rule", injury::to_string(of.alignment)},
          {"shift_s", number(of.shift)},
          {"measured_onset_s", number(of.measured.onset)},
          {"computed_onset_s", of.computed ? number(of.computed->onset) : Json(nullptr)}};
}

Json pulse_json_of(const PulseComparisonReport& report) {
  const injury::PulseReport& of = report.pulse;
  const injury::PulseShape& shape = report.comparison.measured;
  return {{"file", of.file},
          {"format", of.measured.format},
          {"samples", of.pulse.time.size()},
          {"contact_begin_s", number(shape.contact.begin)},
          {"contact_end_s", number(shape.contact.end)},
          {"speed_m_per_s", of.impact ? number(of.impact->speed) : Json(nullptr)},
          {"offset_taken_off", of.offset && of.offset->taken_off},
          {"resampled_to_s", number(of.resampled_to)},
          {"filter", of.filter ? Json(filter_words(*of.filter)) : Json(nullptr)},
          {"flags", flags_json(of.flags)},
          {"remarks", of.measured.remarks}};
}

}  // namespace

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
