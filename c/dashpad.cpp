// include/dashpad.h in terms of the C++ interface. No exception leaves a function.

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad.h"
#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/responses.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study.hpp"
#include "dashpad/version.hpp"
#include "input/disk.hpp"
#include "input/toml_tree.hpp"
#include "json/json_values.hpp"
#include "live/answer.hpp"
#include "live/case_tables.hpp"
#include "live/request.hpp"
#include "model/parameter_values.hpp"
#include "output/text/case_toml.hpp"
#include "result/history_columns.hpp"
#include "study/run_batches.hpp"

using dashpad::CaseQuantities;
using dashpad::CaseQuantity;
using dashpad::ImpactCase;
using dashpad::ResultQuantity;
using dashpad::Status;
using dashpad::Violation;
using dashpad::input::Fault;
using dashpad::input::InputError;
namespace study = dashpad::study;

struct dashpad_faults {
  std::vector<Fault> all;
  std::vector<std::string> lines;
  std::string text;
};

struct dashpad_case {
  std::string text, file, materials;
  bool is_file = false;               ///< the text is that of the file
  std::vector<std::string> settings;  ///< "KEY=VALUE", in the order in which they were made
  dashpad::input::CaseFile read;
  std::shared_ptr<const CaseQuantities> quantities;  ///< of `read`; copies of a case share them
  std::string toml;
};

struct dashpad_solver {
  dashpad::Solver solver;
};

struct dashpad_result {
  ImpactCase impact;
  dashpad::Solution solution;
  std::string status;
  std::optional<std::vector<double>> figures;  ///< in the order of response_kinds(); once one was asked for
  std::optional<std::vector<std::string>> flags;
  std::string json;
};

namespace {

std::string text_of(const char* text) { return text == nullptr ? "" : text; }

void tell(dashpad_faults** faults, std::vector<Fault> all) {
  if (faults == nullptr) return;
  auto told = std::make_unique<dashpad_faults>();
  told->all = std::move(all);
  for (const Fault& fault : told->all) {
    std::string& line = told->lines.emplace_back(to_string(fault));
    if (line.starts_with(": ")) line.erase(0, 2);  // of no file
  }
  for (const std::string& line : told->lines) told->text += line + '\n';
  *faults = told.release();
}

Fault fault_of(std::string key, std::string rule) {
  return {.file = "", .key = std::move(key), .value = "", .rule = std::move(rule)};
}

/// The result of `make`, or that of a failure, after which `faults` say why.
template <class Make>
auto guarded(dashpad_faults** faults, Make&& make) noexcept -> decltype(make()) {
  if (faults != nullptr) *faults = nullptr;
  try {
    try {
      return make();
    } catch (const InputError& error) {
      tell(faults, error.faults());
    } catch (const std::bad_alloc&) {
      tell(faults, {fault_of("", "there is not enough memory")});
    } catch (const std::exception& error) {
      tell(faults, {fault_of("", error.what())});
    }
  } catch (...) {
    // Not even memory for a fault: the result says that there is none.
  }
  return {};
}

void take(dashpad_case& given, dashpad::input::CaseFile read) {
  given.read = std::move(read);
  given.quantities = std::make_shared<const CaseQuantities>(quantities_of(given.read.impact));
  given.toml.clear();
}

/// The settings with one more, in place of an earlier one of the same key. A material replaces the numbers of
/// the one before.
std::vector<std::string> with_setting(std::vector<std::string> settings, const std::string& key,
                                      const std::string& value) {
  constexpr std::string_view material = ".material";
  const bool is_material = key.ends_with(material);
  const std::string owner = is_material ? key.substr(0, key.size() - material.size()) : "";
  std::erase_if(settings, [&](const std::string& setting) {
    if (setting.starts_with(key + "=")) return true;
    return is_material &&
           std::ranges::any_of(std::array{".parameters.", ".curve.", ".rate."},
                               [&](const char* part) { return setting.starts_with(owner + part); });
  });
  settings.push_back(key + "=" + value);
  return settings;
}

/// What a handle stands for. NULL is a mistake of the caller, and told as a fault.
template <class Handle>
Handle& of(Handle* handle) {
  if (handle == nullptr) throw std::invalid_argument("a handle is NULL");
  return *handle;
}

/// The rows as a study of the case.
study::Study study_of(const dashpad_case& given, const dashpad_batch& batch) {
  study::Study made;
  made.base = given.read.impact;
  made.options = given.read.options;
  if (batch.tolerance != 0) made.options.tolerance = batch.tolerance;
  const bool lacks_an_array = (batch.rows > 0 && batch.keys_size > 0 && batch.values == nullptr) ||
                              (batch.keys_size > 0 && batch.keys == nullptr) ||
                              (batch.figures_size > 0 && batch.figures == nullptr);
  if (lacks_an_array) throw std::invalid_argument("an array of the batch is NULL");
  if (batch.keys_size == 0) throw std::invalid_argument("a batch needs a key whose values its rows have");
  std::vector<Fault> faults;
  const std::vector<study::FactorKey> known = study::factor_keys(made.base);
  for (std::size_t i = 0; i < batch.keys_size; ++i) {
    const std::string key = text_of(batch.keys[i]);
    const auto found = std::ranges::find(known, key, &study::FactorKey::key);
    if (found == known.end() || found->unit.empty()) {
      faults.push_back(fault_of(key, study::rule_for_unknown(key, made.base, known)));
      continue;
    }
    study::ByRow column;
    for (std::size_t row = 0; row < batch.rows; ++row)
      column.values.push_back(batch.values[row * batch.keys_size + i]);
    made.factors.push_back({.key = key, .unit = found->unit, .spread = std::move(column)});
  }
  for (std::size_t i = 0; i < batch.figures_size; ++i) {
    made.responses.push_back(text_of(batch.figures[i]));
    if (!study::find_response(made.responses.back()))
      faults.push_back(fault_of(made.responses.back(), "is no figure"));
  }
  if (faults.empty() && batch.rows > 0)
    for (const Violation& violation : violations(made))
      faults.push_back(fault_of(violation.key, violation.rule));
  if (!faults.empty()) throw InputError(std::move(faults));
  return made;
}

/// A request with a case and its changes; what is no request stays as it is.
std::string about(const dashpad_case& given, const std::string& request) {
  dashpad::Json asked = dashpad::Json::parse(request, nullptr, false);
  if (!asked.is_object()) return request;
  if (given.is_file)
    asked["file"] = given.file;
  else
    asked["case"] =
        dashpad::live::tables_of(dashpad::input::read_toml_text(given.file, given.text).value().root);
  asked["set"] = given.settings;
  return asked.dump();
}

/// The value that `find` finds, or NaN.
template <class Find>
double value_of(Find&& find) noexcept {
  try {
    return find();
  } catch (...) {
    return dashpad::no_value;
  }
}

const CaseQuantity* number_at(const dashpad_case* given, std::size_t i) {
  return i < dashpad_case_size(given) ? &*(given->quantities->begin() + std::ptrdiff_t(i)) : nullptr;
}

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

int dashpad_interface(void) { return DASHPAD_INTERFACE; }
// A literal, which ends with a 0.
const char* dashpad_version(void) { return dashpad::version().data(); }

// ------------------------------------------------------------------ what is wrong

size_t dashpad_faults_size(const dashpad_faults* faults) {
  return faults == nullptr ? 0 : faults->all.size();
}
dashpad_fault dashpad_faults_at(const dashpad_faults* faults, size_t i) {
  if (i >= dashpad_faults_size(faults)) return {"", 0, "", "", "", ""};
  const Fault& fault = faults->all[i];
  return {fault.file.c_str(),  fault.line,         fault.key.c_str(),
          fault.value.c_str(), fault.rule.c_str(), faults->lines[i].c_str()};
}
const char* dashpad_faults_text(const dashpad_faults* faults) {
  return faults == nullptr ? "" : faults->text.c_str();
}
void dashpad_faults_free(dashpad_faults* faults) { delete faults; }

// ------------------------------------------------------------------ cases

dashpad_case* dashpad_case_read(const char* file, const char* text, const char* materials,
                                dashpad_faults** faults) {
  return guarded(faults, [&] {
    auto made = std::make_unique<dashpad_case>();
    made->file = text_of(file);
    made->materials = text_of(materials);
    made->is_file = text == nullptr;
    made->text = text == nullptr ? dashpad::input::read_text_file(made->file).value() : text;
    take(*made, dashpad::input::read_case_text(made->text, made->file, made->materials).value());
    return made.release();
  });
}
dashpad_case* dashpad_case_copy(const dashpad_case* given) {
  return guarded(nullptr, [&] { return std::make_unique<dashpad_case>(of(given)).release(); });
}
void dashpad_case_free(dashpad_case* given) { delete given; }

int dashpad_case_set(dashpad_case* given, const char* key, const char* value, dashpad_faults** faults) {
  return guarded(faults, [&] {
    dashpad_case& changed = of(given);
    std::vector<std::string> settings = with_setting(changed.settings, text_of(key), text_of(value));
    take(changed,
         dashpad::input::read_case_text(changed.text, changed.file, changed.materials, settings).value());
    changed.settings = std::move(settings);
    return 1;
  });
}

int dashpad_case_set_number(dashpad_case* given, const char* key, double value, dashpad_faults** faults) {
  return guarded(faults, [&] {
    dashpad_case& changed = of(given);
    const std::string name = text_of(key);
    const CaseQuantity* const quantity = changed.quantities->find(name);
    if (quantity == nullptr) throw InputError({fault_of(name, "is not a number of this case")});
    ImpactCase impact = changed.read.impact;
    quantity->set(impact, value);
    std::vector<Fault> broken;
    for (const Violation& violation : violations(impact))
      broken.push_back(fault_of(violation.key, violation.rule));
    if (!broken.empty()) throw InputError(std::move(broken));
    changed.settings =
        with_setting(std::move(changed.settings), name, dashpad::output::toml_value(value, quantity->unit));
    changed.read.impact = std::move(impact);
    changed.toml.clear();
    return 1;
  });
}

double dashpad_case_number(const dashpad_case* given, const char* key) {
  return value_of([&] {
    const CaseQuantity* const quantity = of(given).quantities->find(text_of(key));
    return quantity == nullptr ? dashpad::no_value : quantity->get(given->read.impact);
  });
}
size_t dashpad_case_size(const dashpad_case* given) {
  return given == nullptr ? 0 : given->quantities->size();
}
const char* dashpad_case_key(const dashpad_case* given, size_t i) {
  const CaseQuantity* const quantity = number_at(given, i);
  return quantity == nullptr ? nullptr : quantity->key.c_str();
}
const char* dashpad_case_unit(const dashpad_case* given, size_t i) {
  const CaseQuantity* const quantity = number_at(given, i);
  return quantity == nullptr ? nullptr : quantity->unit.c_str();
}
const char* dashpad_case_toml(dashpad_case* given) {
  return guarded(nullptr, [&] {
    std::string& toml = of(given).toml;
    if (toml.empty()) toml = dashpad::output::case_toml(given->read.impact, given->read.options);
    return toml.c_str();
  });
}

// ------------------------------------------------------------------ solving

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

// ------------------------------------------------------------------ many impacts

int dashpad_solve_batch(const dashpad_case* given, const dashpad_batch* batch, double* results,
                        unsigned char* statuses, double* errors, dashpad_faults** faults) {
  return guarded(faults, [&] {
    const study::Study asked = study_of(of(given), of(batch));
    const std::size_t width = batch->figures_size;
    if (results == nullptr) throw std::invalid_argument("there is no place for the results");
    std::fill_n(results, batch->rows * width, dashpad::no_value);
    if (statuses != nullptr) std::fill_n(statuses, batch->rows, static_cast<unsigned char>(Status::not_run));
    if (errors != nullptr) std::fill_n(errors, batch->rows, dashpad::no_value);
    if (batch->rows == 0) return 1;

    const study::Design design(asked);
    constexpr std::uint64_t rows_of_batch = 32;
    std::vector<std::uint64_t> numbers((batch->rows + rows_of_batch - 1) / rows_of_batch);
    std::iota(numbers.begin(), numbers.end(), std::uint64_t{0});
    std::atomic<bool> stop = false;
    std::size_t done = 0;
    const auto worker = [&]() -> study::BatchWork::Compute {
      return [own = std::make_shared<study::Worker>(asked, design)](std::uint64_t number,
                                                                    std::vector<study::StoredRow>& rows) {
        own->compute(number, rows_of_batch, rows);
      };
    };
    const auto write = [&](std::uint64_t, std::span<const study::StoredRow> rows) {
      for (const study::StoredRow& row : rows) {
        std::ranges::copy(row.outcome.values, results + row.row * width);
        if (statuses != nullptr) statuses[row.row] = static_cast<unsigned char>(row.outcome.status);
        if (errors != nullptr) errors[row.row] = row.outcome.error;
      }
      done += rows.size();
      if (batch->progress != nullptr && batch->progress(batch->context, done, batch->rows) == 0) stop = true;
    };
    return study::run_batches(numbers, batch->threads, &stop, {.worker = worker, .write = write}) ? 1 : 0;
  });
}

const char* dashpad_status_name(unsigned char status) {
  static const std::array names = [] {
    std::array<std::string, 6> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = to_string(static_cast<Status>(i));
    return all;
  }();
  return status < names.size() ? names[status].c_str() : nullptr;
}

// ------------------------------------------------------------------ everything else

char* dashpad_answer(const char* request, const dashpad_case* given, const char* materials,
                     const char* standards) {
  return guarded(nullptr, [&]() -> char* {
    std::string answer;
    try {
      answer = given == nullptr
                   ? dashpad::live::answer(text_of(request), {text_of(materials), text_of(standards)})
                   : dashpad::live::answer(about(*given, text_of(request)),
                                           {given->materials, text_of(standards)});
    } catch (const std::exception& error) {
      answer = dashpad::live::fault_json("", error.what()).dump();
    }
    auto text = std::make_unique<char[]>(answer.size() + 1);
    std::memcpy(text.get(), answer.c_str(), answer.size() + 1);
    return text.release();
  });
}
void dashpad_text_free(char* text) { delete[] text; }
