#pragma once
/// Parts of the command that are loaded when they are used: what they link takes many times longer to load
/// than an impact takes to solve. Each is a shared library with one function, dashpad_part(), which gives the
/// functions of the part; each holds a copy of what it needs of the library.

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

/// One data set a column, one value a row done, by row number; named as in the CSV and with the attributes
/// `unit` and `meaning`. Groups: /factors, /responses, /rows (row, status, extrapolated, bottomed, error).
/// The study's text, the program and what `status` counts are attributes of the file. NaN where a row has no
/// value. Memory does not grow with the rows. Replaces the file if it is there. Throws std::runtime_error
/// that calls it `shown`; then no file is left.
void write_hdf5(const study::Store& store, const std::filesystem::path& file, const std::string& shown);

}  // namespace dashpad::app
