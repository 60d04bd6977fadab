#include <array>
#include <cmath>

#include "dashpad/output/assessment.hpp"
#include "dashpad/output/json/result.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "json/json_values.hpp"
#include "output/json/criteria.hpp"
#include "output/json/interval.hpp"

namespace dashpad::output {

namespace {

std::string taken_from(const injury::StandardValue& value) {
  if (!value.value) return "case";
  return value.chosen_by_user ? "user" : "standard";
}

Json input(const injury::StandardValue& value, double used, double of_case) {
  return {{"value", number(used)},
          {"from", taken_from(value)},
          {"replaced", injury::differ(used, of_case)},
          {"case_value", number(of_case)},
          {"standard_value", number(value.chosen_by_user ? value.instead : value.value)},
          {"drop_height_m", number(value.drop_height)},
          {"source", value.origin.source},
          {"source_kind", value.chosen_by_user ? Json(nullptr) : Json(to_string(value.origin.kind))},
          {"verified", value.origin.verified},
          {"note", value.origin.note}};
}

Json impactor(const AssessmentReport& report) {
  const injury::Standard& standard = report.standard;
  const Impactor& used = report.assessed.impactor;
  const Impactor& of_case = report.given.impactor;
  return {{"mass_kg", input(standard.mass, used.mass, of_case.mass)},
          {"radius_m", input(standard.radius, sphere_radius(used.nose), sphere_radius(of_case.nose))},
          {"speed_m_per_s", input(standard.speed, used.speed, of_case.speed)}};
}

Json criterion(const injury::CriterionResult& result) {
  const injury::Criterion& of = result.criterion;
  const ResultQuantity& quantity = injury::quantity_of(of.metric);
  const ScaledUnit unit = scaled_unit(quantity.si_unit, plain_si());
  const auto shown = [&](double value) { return number(unit.scale * value); };
  Json entry{{"metric", quantity.key}};
  entry["level_g"] =
      of.metric == injury::Metric::dwell_time ? number(of.level / standard_gravity) : Json(nullptr);
  entry["description"] = of.description;
  entry["unit"] = unit.unit;
  entry["value"] = result.value ? shown(*result.value) : Json(nullptr);
  entry["error"] = result.value ? shown(result.error) : Json(nullptr);
  entry["interval"] = result.interval ? interval_json(*result.interval) : Json(nullptr);
  entry["lower_bound"] = result.lower_bound;
  entry["limit"] = shown(of.limit);
  entry["strict"] = of.strict;
  entry["margin"] = result.margin ? shown(*result.margin) : Json(nullptr);
  entry["margin_is_upper_bound"] = result.lower_bound;
  entry["margin_fraction"] = number(result.relative_margin);
  entry["verdict"] = to_string(result.verdict);
  entry["reason"] = result.reason;
  entry["source"] = of.origin.source;
  entry["source_kind"] = to_string(of.origin.kind);
  entry["verified"] = of.origin.verified;
  entry["note"] = of.origin.note;
  return entry;
}

Json key_figures(const injury::KeyFigures& of) {
  Json all;
  const auto add = [&](const char* key, const injury::Figure& figure) {
    const ResultQuantity& quantity = result_quantity(key);
    const double scale = scaled_unit(quantity.si_unit, plain_si()).scale;
    all[key_with_unit(quantity)] = {{"value", figure.value ? number(scale * *figure.value) : Json(nullptr)},
                                    {"lower_bound", figure.lower_bound}};
  };
  add("peak_acceleration", of.peak_acceleration);
  add("hic15", of.hic15);
  add("hic36", of.hic36);
  add("peak_strain", of.peak_strain);
  add("contact_end", of.contact_end);
  add("rebound_speed", of.rebound_speed);
  add("restitution", of.restitution);
  return all;
}

Json texts(const std::vector<Flag>& reservations) {
  Json array = Json::array();
  for (const Flag& reservation : reservations) array.push_back(reservation.text);
  return array;
}

/// What another choice of nose or speed would have said.
Json other_choices(const std::vector<injury::OtherChoice>& others) {
  const auto choice = [](bool is_other, bool is_kept) {
    return is_other ? Json(is_kept ? "case" : "standard") : Json(nullptr);
  };
  Json array = Json::array();
  for (const injury::OtherChoice& other : others) {
    array.push_back({{"nose", choice(other.other.nose, other.kept.nose)},
                     {"speed", choice(other.other.speed, other.kept.speed)},
                     {"verdict", to_string(other.assessment.verdict)},
                     {"criteria", criteria_json(other.assessment.results)}});
  }
  return array;
}

Json assessment(const AssessmentReport& report) {
  const injury::Standard& standard = report.standard;
  Json json;
  json["case_file"] = report.file.empty() ? Json(nullptr) : Json(report.file);
  json["verdict"] = to_string(report.assessment.verdict);
  json["unqualified"] = report.assessment.unqualified();
  json["reservations"] = texts(report.assessment.reservations);
  json["caveat"] = assessment_caveat();
  json["standard"] = {{"name", standard.name},
                      {"variants", standard.chosen},
                      {"title", standard.title},
                      {"article", standard.article.empty() ? Json(nullptr) : Json(standard.article)},
                      {"source", standard.source},
                      {"source_kind", to_string(standard.source_kind)},
                      {"note", standard.note}};
  json["impactor"] = impactor(report);
  json["other_choices"] = other_choices(report.others);
  json["criteria"] = criteria_json(report.assessment.results);
  json["figures"] = key_figures(report.assessment.figures);
  json["result"] = Json::parse(
      result_json(report.assessed, report.solution.summary, injury::whole_pulse_figures(report.solution)));
  return json;
}

}  // namespace

Json criteria_json(const std::vector<injury::CriterionResult>& results) {
  Json all = Json::array();
  for (const injury::CriterionResult& result : results) all.push_back(criterion(result));
  return all;
}

std::string assessment_json(const AssessmentReport& report) { return result_json_text(assessment(report)); }

std::string assessments_json(const std::vector<AssessmentReport>& reports) {
  Json array = Json::array();
  for (const AssessmentReport& report : reports) array.push_back(result_with_format(assessment(report)));
  return json_text(array);
}

}  // namespace dashpad::output
