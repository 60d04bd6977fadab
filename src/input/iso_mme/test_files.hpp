#pragma once
/// Which files of a folder or archive make up an ISO-MME test.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dashpad/input/input_file.hpp"
#include "input/iso_mme/members.hpp"

namespace dashpad::input {

struct MmeTestFiles {
  std::filesystem::path source;  ///< folder or archive
  bool in_archive = false;
  std::string main_file;                ///< name of the .mme file
  std::string channel_list;             ///< name of the .chn file; empty if there is none
  std::map<int, std::string> channels;  ///< name of the file, by its number

  /// For messages: "test.zip/Channel/test.001".
  [[nodiscard]] std::string shown(const std::string& name) const { return (source / name).string(); }
  /// All files of the test, or the archive.
  [[nodiscard]] std::vector<InputFile> files() const;
  /// The beginning of some of the files.
  [[nodiscard]] MmeMembers beginnings(const std::vector<std::string>& names) const;
  /// Whole files.
  [[nodiscard]] MmeMembers whole(const std::vector<std::string>& names) const;
};

/// `file` is a folder, a .mme file, or an archive with one test in it. Throws InputError.
MmeTestFiles find_mme_test(const std::filesystem::path& file);

}  // namespace dashpad::input
