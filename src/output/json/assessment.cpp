#include "output/documents/assessment.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

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
  const ResultQuantity& quantity = *of.quantity;
  const ScaledUnit unit = scaled_unit(quantity.si_unit, plain_si());
  const auto shown = [&](double value) { return number(unit.scale * value); };
  const bool has_level = of.has_level();
  return {{"metric", quantity.key},
          {"level_g", number_if(has_level, of.level / standard_gravity)},
          {"description", of.description},
          {"unit", unit.unit},
          {"value", made_of(result.value, shown)},
          {"error", number_if(result.value.has_value(), unit.scale * result.error)},
          {"interval", made_of(result.interval, interval_json)},
          {"lower_bound", result.lower_bound},
          {"limit", shown(of.limit)},
          {"strict", of.strict},
          {"margin", made_of(result.margin, shown)},
          {"margin_is_upper_bound", result.lower_bound},
          {"margin_fraction", number(result.relative_margin)},
          {"verdict", to_string(result.verdict)},
          {"reason", result.reason},
          {"source", of.origin.source},
          {"source_kind", to_string(of.origin.kind)},
          {"verified", of.origin.verified},
          {"note", of.origin.note}};
}

Json figures_json(const injury::KeyFigures& figures) {
  Json all;
  for (const auto& [key, member] : figures_of_assessment) {
    const injury::Figure& figure = figures.*member;
    const ResultQuantity& quantity = result_quantity(key);
    const double scale = scaled_unit(quantity.si_unit, plain_si()).scale;
    const auto shown = [&](double value) { return number(scale * value); };
    all[key_with_unit(quantity)] = {{"value", made_of(figure.value, shown)},
                                    {"lower_bound", figure.lower_bound}};
  }
  return all;
}

/// The verdicts that other choices of nose or speed lead to.
Json other_choices(const std::vector<injury::OtherChoice>& others) {
  const auto choice = [](bool is_other, bool is_kept) {
    return is_other ? Json(is_kept ? "case" : "standard") : Json(nullptr);
  };
  return array_of(others, [&](const injury::OtherChoice& other) {
    return Json{{"nose", choice(other.other.nose, other.kept.nose)},
                {"speed", choice(other.other.speed, other.kept.speed)},
                {"verdict", to_string(other.assessment.verdict)},
                {"criteria", criteria_json(other.assessment.results)}};
  });
}

Json assessment(const AssessmentReport& report) {
  const injury::Standard& standard = report.standard;
  Json json;
  json["case_file"] = text_if_any(report.file);
  json["verdict"] = to_string(report.assessment.verdict);
  json["unqualified"] = report.assessment.unqualified();
  json["reservations"] = array_of(report.assessment.reservations, [](const Flag& flag) { return flag.text; });
  json["caveat"] = assessment_caveat();
  json["standard"] = {{"name", standard.name},     {"variants", standard.chosen},
                      {"title", standard.title},   {"article", text_if_any(standard.article)},
                      {"source", standard.source}, {"source_kind", to_string(standard.source_kind)},
                      {"note", standard.note}};
  json["impactor"] = impactor(report);
  json["other_choices"] = other_choices(report.others);
  json["criteria"] = criteria_json(report.assessment.results);
  json["figures"] = figures_json(report.assessment.figures);
  json["result"] = Json::parse(
      result_json(report.assessed, report.solution.summary, injury::whole_pulse_figures(report.solution)));
  return json;
}

}  // namespace

Json criteria_json(const std::vector<injury::CriterionResult>& results) {
  return array_of(results, criterion);
}

std::string assessment_json(const AssessmentReport& report) { return result_json_text(assessment(report)); }

std::string assessments_json(const std::vector<AssessmentReport>& reports) {
  return json_text(array_of(
      reports, [](const AssessmentReport& report) { return result_with_format(assessment(report)); }));
}

}  // namespace dashpad::output
