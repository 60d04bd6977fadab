#pragma once
/// A test in ISO-MME with four channels, and what is said about tests.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::test {

using Files = std::map<std::string, std::string>;

inline void write(const std::filesystem::path& folder, const Files& files) {
  for (const auto& [name, text] : files) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
  }
}

inline std::string channel(const std::string& code, const std::string& samples = "0\n1\n2\n",
                           const std::string& unit = "g", const std::string& more = "") {
  const auto count = std::count(samples.begin(), samples.end(), '\n');
  return "Test object number          :1\nName of the channel         :In words: " + code +
         "\nChannel code                :" + code + "\nUnit                        :" + unit +
         "\nReference channel           :implicit\nTime of first sample        :-0.001\n" +
         "Sampling interval           :0.001\nNumber of samples           :" + std::to_string(count) + "\n" +
         more + samples;
}

inline Files sample_test() {
  return {{"v1.mme", "Data format edition number :1.6\nTitle :A test\nTime of test :10:30\n"},
          {"Channel/v1.chn",
           "Number of channels :4\nName of channel 001 :11HEAD0000H3ACXA / Head x\n"
           "Name of channel 002 :11HEAD0000H3ACYA / Head y\nName of channel 003 :11HEAD0000H3ACZA / Head z\n"
           "Name of channel 004 :11CHST0000H3FOXB / Force\n"},
          {"Channel/v1.001", channel("11HEAD0000H3ACXA", "0\n-3\n2\n")},
          {"Channel/v1.002", channel("11HEAD0000H3ACYA", "0\n0\n1\n")},
          {"Channel/v1.003", channel("11HEAD0000H3ACZA", "9.80665\n39.2266\n-19.6133\n", "m/s2")},
          {"Channel/v1.004", channel("11CHST0000H3FOXB", "0\n1\n2\n", "kN")}};
}

inline std::string said(const std::filesystem::path& file, const input::PulseOptions& options) {
  try {
    input::read_iso_mme(file, options).value();
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "";
}

/// What is said about `files` in a folder.
inline std::string said(const Files& files, const input::PulseOptions& options = {.channel = "1"}) {
  const test::TemporaryFolder folder;
  write(folder.path(), files);
  return said(folder.path(), options);
}

/// The sample test with another text for the first channel.
inline Files with_first(const std::string& text) {
  Files files = sample_test();
  files["Channel/v1.001"] = text;
  return files;
}

}  // namespace dashpad::test
