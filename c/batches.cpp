// Many impacts of include/dashpad.h.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <span>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/study/responses.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study.hpp"
#include "handles.hpp"
#include "input/spelling.hpp"
#include "study/run_batches.hpp"

using dashpad::Status;
using dashpad::Violation;
using dashpad::input::Fault;
using dashpad::input::InputError;
using namespace dashpad::c;
namespace study = dashpad::study;

namespace {

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
    if (study::find_response(made.responses.back())) continue;
    std::vector<std::string> names;
    for (const dashpad::ResultQuantity& kind : study::response_kinds()) names.emplace_back(kind.key);
    faults.push_back(fault_of(made.responses.back(), "is no figure" + dashpad::input::meant_or_listed(
                                                                          made.responses.back(), names)));
  }
  if (faults.empty() && batch.rows > 0)
    for (const Violation& violation : violations(made))
      faults.push_back(fault_of(violation.key, violation.rule));
  if (!faults.empty()) throw InputError(std::move(faults));
  return made;
}

unsigned char flags_of(const study::Outcome& outcome) {
  unsigned flags = 0;
  if (outcome.extrapolated & study::extrapolated_strain) flags |= DASHPAD_EXTRAPOLATED_STRAIN;
  if (outcome.extrapolated & study::extrapolated_rate) flags |= DASHPAD_EXTRAPOLATED_RATE;
  if (outcome.bottomed) flags |= DASHPAD_BOTTOMED;
  return static_cast<unsigned char>(flags);
}

}  // namespace

int dashpad_solve_batch(const dashpad_case* given, const dashpad_batch* batch, double* results,
                        unsigned char* statuses, double* errors, dashpad_faults** faults) {
  return guarded(faults, [&] {
    const study::Study asked = study_of(of(given), of(batch));
    const std::size_t width = batch->figures_size;
    if (results == nullptr) throw std::invalid_argument("there is no place for the results");
    std::fill_n(results, batch->rows * width, dashpad::no_value);
    if (statuses != nullptr) std::fill_n(statuses, batch->rows, static_cast<unsigned char>(Status::not_run));
    if (errors != nullptr) std::fill_n(errors, batch->rows, dashpad::no_value);
    if (batch->flags != nullptr) std::fill_n(batch->flags, batch->rows, static_cast<unsigned char>(0));
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
        if (batch->flags != nullptr) batch->flags[row.row] = flags_of(row.outcome);
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
