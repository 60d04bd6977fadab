#pragma once
/// The files of an ISO-MME test in a folder or archive, and their texts. No name reaches a file outside.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/input/reading.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// Names are relative to the folder or archive, with / between folder and file.
using MmeMembers = std::map<std::string, std::string>;

/// A zip, a tar or a gzipped tar, by its first bytes.
bool is_archive(const std::filesystem::path& file);

/// The regular files in `folder` and in its folder Channel. Throws InputError.
std::vector<std::string> names_in_folder(const std::filesystem::path& folder);
/// Reads files, at most `most` bytes of each; more is a fault unless `cut`. No links. Throws InputError.
MmeMembers read_from_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                            std::size_t most, bool cut);

/// The regular files in an archive. Throws InputError, also if a name leads out of the archive or occurs
/// twice, or for more than 10,000 names.
std::vector<std::string> names_in_archive(const std::filesystem::path& archive);
/// Like read_from_folder(). At most largest_measurement is unpacked in all, whatever it claims.
MmeMembers read_from_archive(const std::filesystem::path& archive, const std::vector<std::string>& names,
                             std::size_t most, bool cut);

struct MmeTestFiles {
  std::filesystem::path source;  ///< folder or archive
  bool in_archive = false;
  std::string main_file;                ///< name of the .mme file
  std::string channel_list;             ///< name of the .chn file; empty if there is none
  std::map<int, std::string> channels;  ///< name of the file, by its number

  /// The name for messages: "test.zip/Channel/test.001".
  [[nodiscard]] std::string shown(const std::string& name) const { return (source / name).string(); }
  [[nodiscard]] std::vector<InputFile> files() const;
  /// The texts of some files, whole or up to the end of their labels.
  [[nodiscard]] MmeMembers texts(const std::vector<std::string>& names, bool only_labels) const;
};

/// `file` is a folder, a .mme file, or an archive. `test`: the name of its .mme file without ending, or its
/// folder, where there are several; else "". Throws InputError.
MmeTestFiles find_mme_test(const std::filesystem::path& file, const std::string& test);

struct MmeLabel {
  std::string name;
  std::string value;  ///< UTF-8; empty for NOVALUE
  std::size_t line = 0;
};

class MmeLabels {
 public:
  void add(MmeLabel label) { labels_.push_back(std::move(label)); }
  /// The first label of that name, ignoring case; null if there is none.
  [[nodiscard]] const MmeLabel* find(std::string_view name) const;
  /// The value of that label; "" if there is none.
  [[nodiscard]] std::string value(std::string_view name) const {
    const MmeLabel* label = find(name);
    return label == nullptr ? "" : label->value;
  }
  [[nodiscard]] const std::vector<MmeLabel>& all() const { return labels_; }

 private:
  std::vector<MmeLabel> labels_;
};

/// The labels up to the first other line, which is the end of .mme and .chn files.
MmeLabels read_mme_labels(std::string_view text);

struct MmeChannelText {
  MmeLabels labels;
  std::vector<double> values;      ///< NaN at both ends for NOVALUE
  std::size_t begin = 0, end = 0;  ///< of those with a value
};

/// Reads a whole channel file, which must have as many samples as it claims and none missing between two
/// others.
MmeChannelText read_mme_channel(std::string_view text, MeasurementFaults& faults);

}  // namespace dashpad::input
