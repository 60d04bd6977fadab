#pragma once
/// The subcommands of `dashpad material`.

#include <filesystem>

#include "command.hpp"

namespace dashpad::app {

void add_material_import(CLI::App& material, Action& action);
void add_material_export(CLI::App& material, Action& action, const std::filesystem::path& executable);

/// Adds --units, a system of units for decks.
void add_deck_units(CLI::App& app, std::string& units);
/// The system of that name; absent where it is none, of which `wrong` is told.
std::optional<UnitSystem> deck_units_of(const std::string& name, std::vector<std::string>& wrong);

}  // namespace dashpad::app
