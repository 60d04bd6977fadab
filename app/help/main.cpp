// dashpad-help FOLDER VERSION: writes the manual pages and the completions for shells. Only the build calls
// it.

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "command_line.hpp"
#include "help/command_help.hpp"

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

int main(int argument_count, char** arguments) {
  using namespace dashpad::app;
  if (argument_count != 3) {
    std::cerr << "usage: dashpad-help FOLDER VERSION\n";
    return exit_refused;
  }
  try {
    const std::filesystem::path folder = arguments[1];
    CLI::App app;
    Action none;
    add_commands(app, none);
    const std::vector<CommandHelp> commands = all_commands(app);
    for (const CommandHelp& command : commands)
      write(folder / "man1" / (joined(command.words, "-") + ".1"),
            manual_page(command, std::string{"dashpad "} + arguments[2]));
    write(folder / "dashpad.bash", bash_completion(commands));
    write(folder / "_dashpad", zsh_completion(commands));
    write(folder / "dashpad.fish", fish_completion(commands));
  } catch (const std::exception& error) {
    std::cerr << "dashpad-help: " << error.what() << "\n";
    return exit_failed;
  }
}
