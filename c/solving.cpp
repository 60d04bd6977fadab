// Solutions of include/dashpad.h.

#include <algorithm>
#include <charconv>
#include <string_view>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/study/responses.hpp"
#include "handles.hpp"
#include "model/parameter_values.hpp"
#include "result/history_columns.hpp"

using dashpad::ResultQuantity;
using dashpad::Violation;
using dashpad::input::InputError;
using namespace dashpad::c;
namespace study = dashpad::study;

namespace {

const ResultQuantity* figure_at(std::size_t i) {
  const auto& kinds = study::response_kinds();
  return i < kinds.size() ? &kinds[i] : nullptr;
}

const std::vector<double>& figures_of(dashpad_result& result) {
  if (!result.figures) {
    std::vector<std::string> names;
    for (const ResultQuantity& kind : study::response_kinds()) names.emplace_back(kind.key);
    study::Outcome outcome;
    study::ResponseReader reader(names);
    reader(result.solution, outcome);
    result.figures = std::move(outcome.values);
  }
  return *result.figures;
}

const std::vector<double>* column_of(const dashpad::History& history, std::string_view name) {
  const auto columns = dashpad::history_columns();
  const auto found = std::ranges::find(columns, name, &dashpad::HistoryColumn::key);
  if (found != columns.end()) return &(history.*found->values);
  constexpr std::string_view layer = "layer_strain_";
  if (!name.starts_with(layer)) return nullptr;
  const std::string_view digits = name.substr(layer.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc{} && end == digits.data() + digits.size();
  return is_number && number >= 1 && number <= history.layer_strain.size() ? &history.layer_strain[number - 1]
                                                                           : nullptr;
}

}  // namespace

dashpad_solver* dashpad_solver_new(void) {
  return guarded(nullptr, [] { return std::make_unique<dashpad_solver>().release(); });
}
void dashpad_solver_free(dashpad_solver* solver) { delete solver; }

dashpad_result* dashpad_solve(dashpad_solver* solver, const dashpad_case* given, double tolerance,
                              dashpad_faults** faults) {
  return guarded(faults, [&] {
    dashpad::Options options = of(given).read.options;
    if (tolerance != 0) options.tolerance = tolerance;
    std::vector<Violation> broken;
    check_bounds(options, "", broken);
    if (!broken.empty()) throw InputError({fault_of(broken.front().key, broken.front().rule)});
    auto made = std::make_unique<dashpad_result>();
    made->impact = given->read.impact;
    made->solution = of(solver).solver.solve(made->impact, options);
    made->status = to_string(made->solution.summary.status);
    return made.release();
  });
}
void dashpad_result_free(dashpad_result* result) { delete result; }

const char* dashpad_result_status(const dashpad_result* result) {
  return result == nullptr ? "not run" : result->status.c_str();
}
int dashpad_result_is_trustworthy(const dashpad_result* result) {
  return result != nullptr && result->solution.summary.trustworthy() ? 1 : 0;
}

double dashpad_result_figure(dashpad_result* result, const char* key) {
  return value_of([&] {
    const auto& kinds = study::response_kinds();
    const auto kind = std::ranges::find(kinds, text_of(key), &ResultQuantity::key);
    return kind == kinds.end() ? dashpad::no_value
                               : figures_of(of(result))[std::size_t(kind - kinds.begin())];
  });
}
size_t dashpad_figures_size(void) { return study::response_kinds().size(); }
const char* dashpad_figure_key(size_t i) { return figure_at(i) == nullptr ? nullptr : figure_at(i)->key; }
const char* dashpad_figure_unit(size_t i) {
  return figure_at(i) == nullptr ? nullptr : figure_at(i)->si_unit;
}
const char* dashpad_figure_title(size_t i) { return figure_at(i) == nullptr ? nullptr : figure_at(i)->title; }

size_t dashpad_result_flags_size(dashpad_result* result) {
  return guarded(nullptr, [&] {
    if (!of(result).flags) {
      std::vector<std::string> lines;
      for (const dashpad::Flag& flag : flags(result->solution.summary)) lines.push_back(flag.text);
      result->flags = std::move(lines);
    }
    return result->flags->size();
  });
}
const char* dashpad_result_flag(dashpad_result* result, size_t i) {
  return i < dashpad_result_flags_size(result) ? (*result->flags)[i].c_str() : nullptr;
}

const double* dashpad_result_history(const dashpad_result* result, const char* column, size_t* size) {
  const std::vector<double>* const found =
      result == nullptr || column == nullptr ? nullptr : column_of(result->solution.history, column);
  const bool is_there = found != nullptr && !found->empty();
  if (size != nullptr) *size = is_there ? found->size() : 0;
  return is_there ? found->data() : nullptr;
}

const char* dashpad_history_key(size_t i) {
  const auto columns = dashpad::history_columns();
  return i < columns.size() ? columns[i].key : nullptr;
}

const char* dashpad_result_json(dashpad_result* result) {
  return guarded(nullptr, [&] {
    std::string& json = of(result).json;
    if (json.empty())
      json = dashpad::output::result_json(result->impact, result->solution.summary,
                                          dashpad::injury::whole_pulse_figures(result->solution));
    return json.c_str();
  });
}
