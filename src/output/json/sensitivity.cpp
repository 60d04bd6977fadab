// Sensitivities as JSON and CSV, in SI.

#include <fmt/format.h>

#include <cmath>

#include "dashpad/output/sensitivity.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

std::string sensitivity_json(const sensitivity::Answer& answer, const std::string& file) {
  Json figures = Json::array();
  for (std::size_t i = 0; i < answer.figures.size(); ++i) {
    const FigureInterval* const interval =
        answer.intervals ? answer.intervals->find(answer.figures[i]->key) : nullptr;
    figures.push_back({{"key", answer.figures[i]->key},
                       {"unit", answer.figures[i]->si_unit},
                       {"value", answer.values[i]},
                       {"low", interval ? number(interval->low) : Json(nullptr)},
                       {"high", interval ? number(interval->high) : Json(nullptr)}});
  }
  Json inputs = Json::array();
  for (std::size_t k = 0; k < answer.inputs.size(); ++k) {
    const sensitivity::Input& input = answer.inputs[k];
    Json effects = Json::object();
    for (std::size_t i = 0; i < answer.figures.size(); ++i) {
      const sensitivity::Elasticity& elasticity = input.elasticities[i];
      effects[answer.figures[i]->key] = {{"elasticity", number(elasticity.value)},
                                         {"error", number(elasticity.error)},
                                         {"derivative", number(sensitivity::derivative(answer, k, i))},
                                         {"course", to_string(elasticity.course)}};
    }
    inputs.push_back({{"key", input.key},
                      {"unit", input.unit},
                      {"value", input.value},
                      {"one_sided", input.is_one_sided},
                      {"effects", effects}});
  }
  return result_json_text({{"program", program_json()},
                           {"case", file},
                           {"figures", figures},
                           {"inputs", inputs},
                           {"left_out", answer.left_out},
                           {"flags", flags_json(answer.flags)},
                           {"runs", answer.runs},
                           {"impacts", answer.impacts},
                           {"seconds", answer.seconds}});
}

std::string sensitivity_csv(const sensitivity::Answer& answer) {
  std::string text =
      "input,input_unit,input_value,figure,figure_unit,figure_value,elasticity,error,derivative,course\n";
  const auto field = [](double value) {
    return std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
  };
  for (std::size_t k = 0; k < answer.inputs.size(); ++k)
    for (std::size_t i = 0; i < answer.figures.size(); ++i) {
      const sensitivity::Input& input = answer.inputs[k];
      const sensitivity::Elasticity& elasticity = input.elasticities[i];
      text += fmt::format("{},{},{},{},{},{}{}{}{},{}\n", input.key, input.unit, input.value,
                          answer.figures[i]->key, answer.figures[i]->si_unit, answer.values[i],
                          field(elasticity.value), field(elasticity.error),
                          field(sensitivity::derivative(answer, k, i)), to_string(elasticity.course));
    }
  return text;
}

}  // namespace dashpad::output
