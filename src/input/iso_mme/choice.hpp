#pragma once
/// Which channels of an ISO-MME test the user means.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/iso_mme/iso_mme.hpp"

namespace dashpad::input {

/// "3" and "003" are 3; a code is no number, even one of digits only.
std::optional<int> channel_number(const std::string& text);

/// One of `all`, or the two or three of a resultant in the order X, Y, Z. Throws InputError that names those
/// that could be meant. `file` is for messages.
std::vector<IsoMmeChannel> chosen_channels(const std::filesystem::path& file,
                                           const std::vector<IsoMmeChannel>& all,
                                           const IsoMmeOptions& options);

}  // namespace dashpad::input
