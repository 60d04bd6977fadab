#pragma once
/// A store as text for spreadsheets and scripts.

#include <functional>
#include <string_view>

#include "dashpad/study/store.hpp"

namespace dashpad::study {

/// A column as files have it: SI, but accelerations in g.
struct ExportedColumn {
  std::string name;  ///< with the unit: "peak_force_N", "impactor.speed_m_per_s"
  std::string unit;  ///< "" for a material
  double scale = 1;  ///< what the values of the store are multiplied with
};
ExportedColumn exported(const StoredColumn& column);

/// Passes the CSV on in pieces, so that memory does not grow with the rows: a heading, then one line a row
/// done, by row number. Columns: row, status, extrapolated, extrapolated_strain, extrapolated_rate and
/// bottomed (0 or 1), error, factors, responses; the heading names units: "impactor.speed_m_per_s". Numbers
/// read back as the same, but for accelerations, which the store has in m/s2; a value that a row does not
/// have is empty. What `write` throws passes through.
void export_csv(const Store& store, const std::function<void(std::string_view)>& write);

}  // namespace dashpad::study
