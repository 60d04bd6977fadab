#pragma once
/// The command line as a whole: description, subcommands and closing text.

#include <string_view>

#include <CLI/CLI.hpp>

#include "command.hpp"

namespace dashpad::app {

/// Adds everything to an empty command line. If `first`, the first argument, is a subcommand, only its
/// options are added: all take longer than many an impact.
void add_commands(CLI::App& app, Action& action, std::string_view first = "");

/// Whether the subcommand of that name runs no impact.
bool only_looks(std::string_view name);

}  // namespace dashpad::app
