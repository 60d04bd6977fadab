#pragma once
/// Computed tests to be written in the format ISO-MME (ISO/TS 13499).

#include <map>
#include <string>
#include <vector>

namespace dashpad::output {

/// The codes of a computed impact on a head form: test object 1, no seat (0), the whole head, no dummy (00),
/// along the impact (X). Filter class 0 means unfiltered; P would imply a filter in the measuring chain.
inline constexpr const char* computed_acceleration_code = "10HEAD000000ACX0";
inline constexpr const char* computed_force_code = "10HEAD000000FOX0";

struct IsoMmeHistory {
  std::string code;            ///< sixteen letters and digits, capitals
  std::string name;            ///< in words
  std::string dimension;       ///< in words, "Acceleration"
  std::string unit;            ///< "m/s2"
  std::vector<double> values;  ///< in `unit`
};

/// All histories have the same even times.
struct IsoMmeTest {
  std::string name = "dashpad";  ///< of the files: letters, digits, - and _
  std::string title = {};
  std::string laboratory = {};
  std::string comment = {};         ///< such as the program and its version
  double time_of_first_sample = 0;  ///< s
  double sampling_interval = 0;     ///< s
  std::vector<IsoMmeHistory> histories = {};
};

/// File names, with / after the folder, and their texts: NAME.mme, Channel/NAME.chn, Channel/NAME.001 and so
/// on. Unknown values are NOVALUE; there is no date, so that the same test gives the same files. Numbers read
/// back as the same double. Throws std::invalid_argument for an invalid test.
std::map<std::string, std::string> iso_mme_files(const IsoMmeTest& test);

/// The bytes of a zip of files, in their order and without dates, so that the same files give the same bytes.
/// Throws std::runtime_error with libarchive's reason.
std::string zip_of(const std::map<std::string, std::string>& files);

}  // namespace dashpad::output
