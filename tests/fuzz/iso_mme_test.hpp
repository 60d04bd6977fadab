#pragma once
/// What a test in ISO-MME must keep to, be it in a folder or in an archive.

#include <filesystem>

namespace dashpad::fuzz {

/// Lists the channels of a test and reads some of them in every way there is.
void read_iso_mme_test(const std::filesystem::path& test);

}  // namespace dashpad::fuzz
