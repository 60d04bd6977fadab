#pragma once
/// Tests in the format ISO-MME (ISO/TS 13499): a folder, its .mme file, or a zip or tar of it. docs/pulses.md
/// has the rules.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dashpad/measurement/measured_pulse.hpp"
#include "dashpad/measurement/sensitivity.hpp"

namespace dashpad {

/// Whether to read `file` as ISO-MME: a folder, a name that ends in .mme, or a zip or tar archive.
bool is_iso_mme(const std::filesystem::path& file);

struct IsoMmeChannel {
  int number = 0;       ///< the ending of its file: 1 for .001
  std::string code;     ///< sixteen characters, such as 11HEAD0000H3ACXA; empty if the file has none
  std::string name;     ///< in words
  std::string unit;     ///< as in the file
  std::string samples;  ///< their number, as the file claims
  std::string problem;  ///< why it cannot be read; empty if nothing is known against it
};

/// All channels, by number. Throws InputError.
std::vector<IsoMmeChannel> iso_mme_channels(const std::filesystem::path& file);

struct IsoMmeOptions {
  std::string channel = {};  ///< number, or code in which ? stands for any character; empty: the only
                             ///< acceleration
  std::string acceleration_unit = {};         ///< empty: that of the file
  bool resultant = false;                     ///< combine the directions X, Y, Z that `channel` matches
  std::vector<Sensitivity> sensitivity = {};  ///< as in PulseCsvOptions; the directions in the order X, Y, Z
};

/// Nothing outside of the folder or archive is read: links are not followed, and an archive with a name that
/// leads elsewhere is refused. Throws InputError with all faults, or the first 200. At most 1 GiB unpacked
/// and 50 million samples a channel.
MeasuredPulse read_iso_mme(const std::filesystem::path& file, const IsoMmeOptions& options);

/// The codes of a computed impact on a head form. Test object 1, no seat (0), the whole head, no dummy (00),
/// along the impact (X). Filter class 0, unfiltered: P would say that a filter of the measuring chain has
/// been at work, and here there is none.
inline constexpr const char* computed_acceleration_code = "10HEAD000000ACX0";
inline constexpr const char* computed_force_code = "10HEAD000000FOX0";

/// A time history to write.
struct IsoMmeHistory {
  std::string code;            ///< sixteen letters and digits, capitals
  std::string name;            ///< in words
  std::string dimension;       ///< in words, "Acceleration"
  std::string unit;            ///< "m/s2"
  std::vector<double> values;  ///< in `unit`
};

/// A test to write. All histories have the same even times.
struct IsoMmeTest {
  std::string name = "dashpad";  ///< of the files: letters, digits, - and _
  std::string title = {};
  std::string laboratory = {};
  std::string comment = {};         ///< such as the program and its version
  double time_of_first_sample = 0;  ///< s
  double sampling_interval = 0;     ///< s
  std::vector<IsoMmeHistory> histories = {};
};

/// File names, with / between folder and file, and their texts: NAME.mme, Channel/NAME.chn, Channel/NAME.001
/// and so on. What is not known is NOVALUE; no date, so that the same test gives the same files. Numbers read
/// back as the same double. Throws std::invalid_argument that says what is wrong with `test`.
std::map<std::string, std::string> iso_mme_files(const IsoMmeTest& test);

/// The bytes of a zip of files, in their order, without dates: the same files give the same bytes. Throws
/// std::runtime_error with libarchive's reason.
std::string zip_of(const std::map<std::string, std::string>& files);

}  // namespace dashpad
