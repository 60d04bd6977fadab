// Critical fall heights as JSON and CSV, in SI and g.

#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/fall_height.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"
#include "output/text/fall_height_words.hpp"
#include "output/text/standard_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

double shown(const injury::Criterion& criterion, double value) {
  return scaled_unit(criterion.quantity->si_unit, plain_si()).scale * value;
}

Json remarks_json(const std::vector<fall_height::Remark>& remarks) {
  return array_of(remarks, [](const fall_height::Remark& remark) {
    return Json{{"name", remark.first}, {"text", remark.second}};
  });
}

/// Null if the end is open.
Json end_json(double end) { return number_if(end > 0, end); }

Json crossing_json(const injury::Standard& standard, const fall_height::Crossing& crossing) {
  const injury::Criterion& criterion = standard.criteria[crossing.criterion];
  Json json{{"figure", criterion.quantity->key},
            {"unit", scaled_unit(criterion.quantity->si_unit, plain_si()).unit},
            {"limit", shown(criterion, criterion.limit)},
            {"height_m", number(crossing.height)},
            {"low_m", crossing.interval ? end_json(crossing.interval->first) : Json(nullptr)},
            {"high_m", crossing.interval ? number(crossing.interval->second) : Json(nullptr)},
            {"enclosed", crossing.is_enclosed()},
            {"kept_below_m", number(crossing.below)},
            {"exceeded_above_m", number(crossing.above)},
            {"instrument_relative", crossing.doubt},
            {"points", crossing.points.size()},
            {"points_of_curve", crossing.near.size()},
            {"curve", nullptr}};
  if (const auto& curve = crossing.curve) {
    // With the figure in the unit above.
    Json coefficients = Json::array({curve->coefficients[0] + std::log(shown(criterion, 1))});
    for (int i = 1; i < curve->terms; ++i)
      coefficients.push_back(curve->coefficients[static_cast<std::size_t>(i)]);
    json["curve"] = {{"middle_m", curve->middle},
                     {"coefficients", coefficients},
                     {"deviation", number_if(curve->freedom > 0, curve->deviation)},
                     {"degrees_of_freedom", curve->freedom}};
  }
  return json;
}

Json drop_json(const injury::Standard& standard, const fall_height::Drop& drop) {
  Json figures = Json::object();
  for (std::size_t i = 0; i < standard.criteria.size(); ++i)
    figures[standard.criteria[i].quantity->key] = number(shown(standard.criteria[i], drop.figures[i]));
  return {{"line", drop.line},
          {"height_m", drop.height},
          {"number", drop.number},
          {"figures", figures},
          {"pulse", text_if_any(drop.pulse)},
          {"remarks", remarks_json(drop.remarks)},
          {"flags", flags_json(drop.flags)}};
}

Json measured_json(const FallHeightReport& report) {
  const fall_height::Answer& answer = *report.measured;
  return {{"file", report.table_file},
          {"lowest_place", answer.lowest},
          {"places", array_of(answer.places,
                              [&](const fall_height::Place& place) {
                                return Json{{"remarks", remarks_json(place.remarks)},
                                            {"deciding_figure", place.lowest},
                                            {"limits", array_of(place.crossings,
                                                                [&](const fall_height::Crossing& crossing) {
                                                                  return crossing_json(answer.standard,
                                                                                       crossing);
                                                                })},
                                            {"drops", array_of(place.drops,
                                                               [&](const fall_height::Drop& drop) {
                                                                 return drop_json(answer.standard, drop);
                                                               })},
                                            {"flags", flags_json(place.flags)}};
                              })},
          {"flags", flags_json(answer.reservations)}};
}

Json computed_json(const FallHeightReport& report) {
  const margin::Turn* const turn = critical_turn(*report.computed);
  return {{"file", report.case_file},
          {"height_m", turn ? Json(turn->value) : Json(nullptr)},
          {"low_m", turn && turn->interval ? number(turn->interval->first) : Json(nullptr)},
          {"high_m", turn && turn->interval ? number(turn->interval->second) : Json(nullptr)},
          {"from_m", report.computed->question.low},
          {"to_m", report.computed->question.high},
          {"impacts", report.computed->impacts},
          {"flags", flags_json(report.computed->reservations)}};
}

}  // namespace

std::string fall_height_json(const FallHeightReport& report, const UnitSystem& units) {
  const injury::Standard& standard = standard_of(report);
  return result_json_text(
      {{"program", program_json()},
       {"answer", fall_height_answer(report, units)},
       {"standard", full_name(standard)},
       {"about", array_of(report.about, [](const std::string& line) { return Json(line); })},
       {"measured", report.measured ? measured_json(report) : Json(nullptr)},
       {"computed", report.computed ? computed_json(report) : Json(nullptr)}});
}

std::string fall_height_csv(const FallHeightReport& report) {
  const fall_height::Answer& answer = *report.measured;
  std::string text;
  for (const auto& [header, words] : answer.places.front().drops.front().remarks)
    text += csv_field(header) + ",";
  text += "drop_height [m],drop";
  for (const injury::Criterion& criterion : answer.standard.criteria) {
    const std::string unit = scaled_unit(criterion.quantity->si_unit, plain_si()).unit;
    text += fmt::format(",{}{}", criterion.quantity->key,
                        unit == "1" || unit.empty() ? "" : fmt::format(" [{}]", unit));
  }
  text += ",from_pulse\n";
  for (const fall_height::Place& place : answer.places)
    for (const fall_height::Drop& drop : place.drops) {
      for (const auto& [header, words] : drop.remarks) text += csv_field(words) + ",";
      text += fmt::format("{},{}", drop.height, drop.number);
      for (std::size_t i = 0; i < answer.standard.criteria.size(); ++i)
        text += std::isfinite(drop.figures[i])
                    ? fmt::format(",{:.12g}", shown(answer.standard.criteria[i], drop.figures[i]))
                    : ",";
      text += "," + csv_field(drop.pulse) + "\n";
    }
  return text;
}

}  // namespace dashpad::output
