// The answers of a study as JSON, in SI and g.

#include "dashpad/output/study.hpp"
#include "json/json_values.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

Json estimate_json(const study::Estimate& estimate, double scale = 1) {
  return {{"value", number(scale * estimate.value)},
          {"low", number(scale * estimate.low)},
          {"high", number(scale * estimate.high)}};
}

Json distribution_json(const std::string& response, const study::Distribution& distribution) {
  const auto [scale, unit] = scaled_unit(si_unit_of(response), plain_si());
  const auto quantile = [factor = scale](const study::Distribution::Quantile& at) {
    Json json = {{"probability", at.probability}};
    json.update(estimate_json(at.value, factor));
    return json;
  };
  return {{"response", response},
          {"unit", unit},
          {"rows", distribution.rows},
          {"rows_struck_through", distribution.struck_through},
          {"rows_without", distribution.without},
          {"mean", estimate_json(distribution.mean, scale)},
          {"deviation", number(scale * distribution.deviation)},
          {"least", number(scale * distribution.least)},
          {"greatest", number(scale * distribution.greatest)},
          {"quantiles", array_of(distribution.quantiles, quantile)}};
}

Json counts_json(const study::Exceedance& exceedance) {
  return {{"probability", estimate_json(exceedance.probability)},
          {"rows_above", exceedance.exceeding},
          {"rows_struck_through", exceedance.struck_through},
          {"rows", exceedance.rows},
          {"rows_undecided", exceedance.undecided}};
}

Json exceedance_json(const study::StudyLimit& limit, const study::Exceedance& exceedance) {
  const auto [scale, unit] = scaled_unit(si_unit_of(limit.response), plain_si());
  Json json{{"response", limit.response}, {"unit", unit}, {"limit", number(scale * limit.value)}};
  json.update(counts_json(exceedance));
  return json;
}

Json sensitivity_json(const std::string& response, const study::Sensitivity& sensitivity) {
  const auto index = [](const study::Sensitivity::Index& each) {
    return Json{{"factor", each.factor},
                {"first_order", estimate_json(each.first)},
                {"total", estimate_json(each.total)}};
  };
  return {{"response", response},
          {"draws", sensitivity.draws},
          {"draws_left_out", sensitivity.left_out},
          {"indices", array_of(sensitivity.indices, index)}};
}

Json levels_json(const study::StudyAnswers& answers, const study::Group& group) {
  const std::vector<std::size_t> factors = level_factors(answers.study);
  Json levels = Json::array();
  for (std::size_t i = 0; i < group.levels.size(); ++i) {
    const study::Factor& factor = answers.study.factors[factors[i]];
    Json level = {{"factor", factor.key}, {"unit", factor.unit}, {"value", number(group.levels[i])}};
    if (factor.unit.empty())
      level["value"] = level_text(answers.study, factors[i], group.levels[i], plain_si());
    levels.push_back(level);
  }
  return levels;
}

Json group_json(const study::StudyAnswers& answers, const study::StudyAnswers::OfGroup& group) {
  Json distributions = Json::array(), exceedances = Json::array(), sensitivities = Json::array();
  for (std::size_t i = 0; i < group.distributions.size(); ++i) {
    const std::string& response = answers.study.responses[answers.responses[i]];
    distributions.push_back(distribution_json(response, group.distributions[i]));
    if (group.sensitivities[i]) sensitivities.push_back(sensitivity_json(response, *group.sensitivities[i]));
  }
  for (std::size_t i = 0; i < group.exceedances.size(); ++i)
    exceedances.push_back(exceedance_json(answers.limits[i], group.exceedances[i]));
  return {{"levels", levels_json(answers, group.group)},
          {"distributions", distributions},
          {"exceedances", exceedances},
          {"any_limit_exceeded", made_of(group.any, counts_json)},
          {"sobol_indices", sensitivities}};
}

Json cushion_json(const study::CushionCurves& curves) {
  Json drops = Json::array();
  for (const study::CushionCurves::Drop& drop : curves.drops)
    for (const study::CushionCurve& curve : drop.curves) {
      Json points = Json::array();
      for (std::size_t i = 0; i < curve.static_stress.size(); ++i)
        points.push_back({{"static_stress_Pa", number(curve.static_stress[i])},
                          {"peak_acceleration_g", number(curve.peak_deceleration[i] / standard_gravity)}});
      drops.push_back({{"drop_height_m", drop.height},
                       {"speed_m_per_s", drop.speed},
                       {"thickness_m", curve.thickness},
                       {"points", points}});
    }
  return {
      {"loaded_area", curves.whole_cushion ? "area of the cushion"
                                           : "projected contact area of the nose at the largest penetration"},
      {"curves", drops}};
}

/// A ranking with the places of its combinations in "groups".
Json ranking_json(const study::StudyAnswers& answers, std::size_t response) {
  const std::string& name = answers.study.responses[answers.responses[response]];
  const auto [scale, unit] = scaled_unit(si_unit_of(name), plain_si());
  Json ranks = Json::array();
  for (const study::Ranked& ranked : answers.rankings[response]) {
    const study::Estimate& difference = ranked.difference;
    const bool is_first = ranks.empty();
    ranks.push_back(
        {{"group", ranked.group},
         {"median", number(scale * ranked.median)},
         {"difference", is_first ? Json(nullptr)
                                 : estimate_json({scale * difference.value, scale * difference.low,
                                                  scale * difference.high})},
         {"higher", is_first ? Json(nullptr) : counts_json(ranked.higher)}});
  }
  return {{"response", name}, {"unit", unit}, {"ranks", ranks}};
}

Json turn_json(const study::StudyAnswers& answers, const study::TurningLevel& turn) {
  const study::Factor& factor = answers.study.factors[turn.factor];
  return {{"factor", factor.key},
          {"unit", factor.unit},
          {"kept", turn.kept_above ? "above" : "below"},
          {"probability", study::turning_probability},
          {"level", estimate_json(turn.level)},
          {"at_end_of_levels", turn.level.value == (turn.kept_above ? turn.first : turn.last)},
          {"draws", turn.draws},
          {"example", turn.example}};
}

}  // namespace

std::string study_json(const study::StudyAnswers& answers) {
  const auto group = [&](const study::StudyAnswers::OfGroup& each) { return group_json(answers, each); };
  Json json = {{"program", program_json()},
               {"title", answers.study.title},
               {"computed_by", answers.program},
               {"rows", answers.records.rows.size()},
               {"rows_of_study", answers.rows},
               {"rows_doubtful", answers.records.doubtful},
               {"rows_extrapolated", answers.records.extrapolated},
               {"rows_extrapolated_strain", answers.records.beyond_strain},
               {"rows_extrapolated_rate", answers.records.beyond_rate},
               {"rows_bottomed", answers.records.bottomed},
               {"rows_struck_through", answers.records.struck_through},
               {"rows_at_time_limit", answers.records.time_limit},
               {"are_draws", answers.groups.front().group.drawn},
               {"interval", 0.95},
               {"groups", array_of(answers.groups, group)}};
  Json rankings = Json::array();
  for (std::size_t i = 0; i < answers.rankings.size(); ++i)
    if (!answers.rankings[i].empty()) rankings.push_back(ranking_json(answers, i));
  json["rankings"] = rankings;
  json["turning_levels"] =
      array_of(answers.turns, [&](const study::TurningLevel& turn) { return turn_json(answers, turn); });
  if (answers.cushion_curves) json["cushion_curves"] = cushion_json(*answers.cushion_curves);
  return result_json_text(json);
}

}  // namespace dashpad::output
