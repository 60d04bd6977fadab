// Where a verdict turns, as JSON and CSV, in SI and g.

#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/margin.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"
#include "output/text/margin_words.hpp"

namespace dashpad::output {

namespace {

std::string name_of(const margin::Limit& limit) {
  return limit.level > 0 ? fmt::format("{}_above_{:.5g}", limit.figure->key, limit.level) : limit.figure->key;
}

/// A figure in the unit of plain_si(), with g for accelerations.
double shown(const margin::Limit& limit, double value) {
  return scaled_unit(limit.figure->si_unit, plain_si()).scale * value;
}

Json limit_json(const margin::Limit& limit) {
  return {{"figure", limit.figure->key},
          {"level_m_per_s2", limit.level > 0 ? Json(limit.level) : Json(nullptr)},
          {"unit", scaled_unit(limit.figure->si_unit, plain_si()).unit},
          {"limit", shown(limit, limit.value)},
          {"kept", limit.is_aim     ? "aim"
                   : limit.at_least ? "at_least"
                                    : "at_most"},
          {"standard", text_if_any(limit.origin)}};
}

Json question_json(const margin::Question& question) {
  Json json{{"key", question.key},         {"unit", question.unit},  {"low", question.low},
            {"high", question.high},       {"probability", nullptr}, {"draws", nullptr},
            {"foam_uncertainty", nullptr}, {"varied", Json::array()}};
  if (const auto& chance = question.chance) {
    json["probability"] = chance->probability;
    json["draws"] = chance->draws;
    json["foam_uncertainty"] = chance->foam;
    json["varied"] = array_of(chance->factors, [](const study::Factor& factor) { return Json(factor.key); });
  }
  return json;
}

}  // namespace

std::string margin_json(const margin::Answer& answer) {
  const auto turn_json = [&](const margin::Turn& turn) {
    return Json{{"value", turn.value},
                {"precision", turn.precision},
                {"low", turn.interval ? number(turn.interval->first) : Json(nullptr)},
                {"high", turn.interval ? number(turn.interval->second) : Json(nullptr)},
                {"passes_above", turn.passes_above},
                {"jumps", turn.jumps},
                {"figure", name_of(answer.limits[turn.limit])}};
  };
  const auto place_json = [&](const margin::Place& place) {
    Json json{{"value", place.value}};
    Json figures = Json::array();
    for (std::size_t i = 0; i < place.figures.size(); ++i)
      figures.push_back(number(shown(answer.limits[i], place.figures[i])));
    json["figures"] = figures;
    json["share_of_limit"] = number(share_of_limit(answer.limits[place.worst], place.excess));
    json["share_low"] = number(share_of_limit(answer.limits[place.worst], place.low));
    json["share_high"] = number(share_of_limit(answer.limits[place.worst], place.high));
    json["worst"] = name_of(answer.limits[place.worst]);
    if (answer.question.chance) json["passing_draws"] = place.share;
    json["why_unknown"] = text_if_any(place.why_unknown);
    return json;
  };
  return result_json_text(
      {{"program", program_json()},
       {"question", question_json(answer.question)},
       {"limits", array_of(answer.limits, limit_json)},
       {"answer", margin_answer(answer, plain_si())},
       {"turns", array_of(answer.turns, turn_json)},
       {"stretches", array_of(answer.stretches,
                              [](const margin::Stretch& stretch) {
                                return Json{{"from", stretch.from},
                                            {"to", stretch.to},
                                            {"verdict", margin::to_string(stretch.zone)}};
                              })},
       {"nearest", answer.nearest ? place_json(answer.places[*answer.nearest]) : Json(nullptr)},
       {"places", array_of(answer.places, place_json)},
       {"contributors", array_of(answer.contributors,
                                 [](const margin::Contributor& each) {
                                   return Json{{"key", each.key}, {"share", number(each.share)}};
                                 })},
       {"flags", flags_json(answer.reservations)},
       {"doubtful_places", answer.doubtful},
       {"complete", answer.is_complete},
       {"impacts", answer.impacts},
       {"seconds", answer.seconds}});
}

std::string margin_csv(const margin::Answer& answer) {
  const ScaledUnit key = scaled_unit(answer.question.unit, plain_si());
  std::string text =
      answer.question.key + (key.unit == "1" || key.unit.empty() ? "" : fmt::format(" [{}]", key.unit));
  for (const margin::Limit& limit : answer.limits) {
    const std::string unit = scaled_unit(limit.figure->si_unit, plain_si()).unit;
    text += fmt::format(",{}{}{}", limit.origin.empty() ? "" : limit.origin + ":", name_of(limit),
                        unit == "1" || unit.empty() ? "" : fmt::format(" [{}]", unit));
  }
  text += ",share_of_limit,share_low,share_high,passing_draws\n";
  const auto field = [](double value) {
    return std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
  };
  for (const margin::Place& place : answer.places) {
    text += fmt::format("{}", key.scale * place.value);
    for (std::size_t i = 0; i < place.figures.size(); ++i)
      text += field(shown(answer.limits[i], place.figures[i]));
    for (const double excess : {place.excess, place.low, place.high})
      text += field(share_of_limit(answer.limits[place.worst], excess));
    text += (answer.question.chance ? field(place.share) : ",") + "\n";
  }
  return text;
}

}  // namespace dashpad::output
