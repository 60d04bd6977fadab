#pragma once
/// A study that is solved in no time, and rows for it that nobody computed.

#include <sqlite3.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "dashpad/model/pad/elastic.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::test {

/// An elastic pad on a rigid support, struck with `rows` speeds from 1 to 3 m/s.
inline study::Study small_study(std::size_t rows = 1000) {
  study::Study study;
  study.title = "Speeds";
  study.text = "title = \"Speeds\"\n";
  study.base.impactor = {.mass = 5, .nose = Sphere{0.08}, .speed = 1};
  study.base.pad.thickness = 0.05;
  study.base.pad.material.law = Elastic{.modulus = 3e5};
  std::vector<double> speeds(rows);
  for (std::size_t i = 0; i < rows; ++i)
    speeds[i] = 1 + 2 * static_cast<double>(i) / static_cast<double>(rows);
  study.factors.push_back(
      {.key = "impactor.speed", .unit = "m/s", .spread = study::Levels{speeds}, .lowest = {}, .highest = {}});
  study.responses = {"peak_force", "rebound_speed"};
  return study;
}

/// Recognisable values; every seventh row lacks its second response.
inline study::StoredRow made_up_row(std::uint64_t number) {
  const auto x = static_cast<double>(number);
  study::StoredRow row{.row = number, .factors = {1 + 1e-3 * x}, .outcome = {}};
  row.outcome.status = number % 7 == 0 ? Status::time_limit : Status::released;
  row.outcome.extrapolated = number % 3 == 0 ? study::extrapolated_strain : 0U;
  row.outcome.bottomed = number % 5 == 0;
  row.outcome.error = 1e-5 * std::sqrt(x);
  row.outcome.values = {std::exp(1e-3 * x),
                        number % 7 == 0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(x + 0.3)};
  return row;
}

inline std::vector<study::StoredRow> made_up_batch(const study::Store& store, std::uint64_t batch) {
  std::vector<study::StoredRow> rows;
  for (std::uint64_t i = batch * store.batch_size(); i < store.rows() && rows.size() < store.batch_size();
       ++i)
    rows.push_back(made_up_row(i));
  return rows;
}

inline void fill(study::Store& store) {
  for (const std::uint64_t batch : store.missing_batches())
    store.write_batch(batch, made_up_batch(store, batch));
}

/// What another tool does to a store.
inline void edit(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  const int code = sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
  const std::string message = sqlite3_errmsg(database);
  sqlite3_close(database);
  if (code != SQLITE_OK) throw std::runtime_error(message);
}

}  // namespace dashpad::test
