#pragma once
/// A store as text for spreadsheets and scripts.

#include <functional>
#include <string_view>

#include "dashpad/study/store.hpp"

namespace dashpad::study {

/// Passes the CSV on in pieces, so that memory does not grow with the rows: a heading, then one line a row
/// done, by row number. Columns: row, status, extrapolated and bottomed (0 or 1), error, factors, responses;
/// units stand in the heading: "impactor.speed (m/s)". Numbers read back as the same; a value that a row does
/// not have is empty. What `write` throws passes through.
void export_csv(const Store& store, const std::function<void(std::string_view)>& write);

}  // namespace dashpad::study
