#pragma once
/// Parts of the command that are loaded on first use, because their libraries take many times longer to load
/// than an impact to solve. Each is a shared library whose function dashpad_part() returns the functions of
/// the part, with a copy of what they need of dashpad.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/study/store.hpp"
#include "input/iso_mme/test_files.hpp"

namespace dashpad::app {

/// PNG and PDF of pictures, by librsvg and cairo.
struct PicturePart {
  static constexpr const char* name = "pictures";
  std::string (*png)(std::string_view svg);
  std::string (*pdf)(std::string_view svg, const std::string& title);
};

/// Zip and tar, by libarchive.
struct ArchivePart {
  static constexpr const char* name = "archives";
  std::vector<std::string> (*names)(const std::filesystem::path& archive);
  input::MmeMembers (*read)(const std::filesystem::path& archive, const std::vector<std::string>& names,
                            std::size_t most, bool cut);
  std::string (*zip)(const std::map<std::string, std::string>& files);
};

/// Stores as HDF5.
struct Hdf5Part {
  static constexpr const char* name = "hdf5";
  void (*write)(const study::Store& store, const std::filesystem::path& file, const std::string& shown);
};

/// Writes a store as HDF5: one data set per column with a value for each computed row, by row number, named
/// as in the CSV, with the attributes `unit` and `meaning`. Groups: /factors, /responses, /rows (row, status,
/// extrapolated, bottomed, error). The study's text, the program and the names of `status` are attributes of
/// the file. Missing values are NaN. Memory does not grow with the rows. Replaces an existing file. Throws
/// std::runtime_error that calls the file `shown`, and leaves no file then.
void write_hdf5(const study::Store& store, const std::filesystem::path& file, const std::string& shown);

}  // namespace dashpad::app
