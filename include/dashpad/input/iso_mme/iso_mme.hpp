#pragma once
/// Tests in the format ISO-MME (ISO/TS 13499): a folder, its .mme file, a zip or tar (docs/pulses.md).

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// Whether to read `file` as ISO-MME: a folder, a name that ends in .mme, or a zip or tar archive.
bool is_iso_mme(const std::filesystem::path& file);

struct IsoMmeChannel {
  int number = 0;       ///< the ending of its file: 1 for .001
  std::string code;     ///< sixteen characters, such as 11HEAD0000H3ACXA; empty if the file has none
  std::string name;     ///< in words
  std::string unit;     ///< as in the file
  std::string samples;  ///< as the file claims
  std::string problem;  ///< why it cannot be read; empty if nothing speaks against it
};

/// All channels, by number. `test`: as in PulseOptions.
Reading<std::vector<IsoMmeChannel>> iso_mme_channels(const std::filesystem::path& file,
                                                     const std::string& test = {});

/// Times are even ("implicit"), or those of another channel ("explicit"). NOVALUE at the ends is left out
/// with a remark, and a first time that is not stated is 0. Reads nothing outside of the folder or archive:
/// links are not followed, and archives with names that lead elsewhere are refused. Reports at most 200
/// faults. At most 1 GiB unpacked, 50 million samples each.
Reading<PulseFile> read_iso_mme(const std::filesystem::path& file, const PulseOptions& options);

/// Reads a test in ISO-MME or a table, whichever `file` is.
Reading<PulseFile> read_pulse(const std::filesystem::path& file, const PulseOptions& options);

}  // namespace dashpad::input
