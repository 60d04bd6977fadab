#pragma once
/// A store as HDF5, for tools that read large arrays.

#include <filesystem>
#include <string>

#include "dashpad/study/store.hpp"

namespace dashpad::app {

/// One data set a column, one value a row done, by row number; named as in the CSV and with the attributes
/// `unit` and `meaning`. Groups: /factors, /responses, /rows (row, status, extrapolated, bottomed, error).
/// The study's text, the program and what `status` counts are attributes of the file. NaN where a row has no
/// value. Memory does not grow with the rows. Replaces the file if it is there. Throws std::runtime_error
/// that calls it `shown`; then no file is left.
void write_hdf5(const study::Store& store, const std::filesystem::path& file, const std::string& shown);

}  // namespace dashpad::app
