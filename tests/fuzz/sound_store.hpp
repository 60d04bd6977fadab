#pragma once
/// A store of a small study to doctor, and what its readers must keep to.

#include <filesystem>
#include <string>

namespace dashpad::fuzz {

/// The bytes of a sound store with all its rows.
const std::string& sound_store();
/// Its account of the study, JSON.
const std::string& sound_account();

/// A copy of the sound store in the folder.
std::filesystem::path fresh_store();

/// Reads all of a store: what it says of itself, its rows, its columns, its study.
void read_store(const std::filesystem::path& file);

}  // namespace dashpad::fuzz
