#pragma once
/// What the fuzz targets have in common: a place for their files, and what a refusal must look like.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::fuzz {

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// A folder of this process alone, removed at its end.
const std::filesystem::path& folder();

/// Writes a file into the folder, with the folders on the way to it.
std::filesystem::path write(const std::filesystem::path& name, std::string_view bytes);

/// Ends the program where a rule is broken; libFuzzer then keeps the input.
void require(bool holds, const char* rule);

void require_finite(const std::vector<double>& values, const char* rule);
/// And finite.
void require_increasing(const std::vector<double>& values, const char* rule);

/// Words that a terminal shows, and does not obey.
void require_plain_text(std::string_view text, const char* rule);

/// Every fault names a file and a rule; the whole is fit for a terminal.
void require_sound(const std::vector<input::Fault>& faults);
void require_sound(const input::InputError& refusal);

/// What `read` returns; nothing where it refuses its files. Whatever else it throws ends the program.
template <class Read>
auto read_or_refuse(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const input::InputError& refusal) {
    require_sound(refusal);
    return std::nullopt;
  }
}

}  // namespace dashpad::fuzz
