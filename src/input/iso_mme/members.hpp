#pragma once
/// The files of an ISO-MME test, in a folder or an archive. Nothing outside of it can be reached by any name.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace dashpad::input {

/// Names are relative to the folder or archive, with / between folder and file.
using MmeMembers = std::map<std::string, std::string>;

/// A zip, a tar or a gzipped tar, by its first bytes.
bool is_archive(const std::filesystem::path& file);

/// The regular files in `folder` and in its folder Channel. Throws InputError.
std::vector<std::string> names_in_folder(const std::filesystem::path& folder);
/// Those of `names`, at most `most` bytes of each. A file that has more is a fault unless `cut`. Links are
/// not followed. Throws InputError.
MmeMembers read_from_folder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                            std::size_t most, bool cut);

/// The regular files in an archive. Throws InputError, also for an archive with a name that leads out of it,
/// with the same name twice, or with more than 10,000 names.
std::vector<std::string> names_in_archive(const std::filesystem::path& archive);
/// As read_from_folder(). The sizes that the archive claims are not relied on: at most largest_measurement is
/// unpacked in all.
MmeMembers read_from_archive(const std::filesystem::path& archive, const std::vector<std::string>& names,
                             std::size_t most, bool cut);

}  // namespace dashpad::input
