// dashpad explore: writes a case as a page that solves it anew while its numbers are dragged.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/standard_file.hpp"
#include "input/disk.hpp"
#include "live/live_page.hpp"
#include "live_files.hpp"
#include "output/text/case_toml.hpp"
#include "output_files.hpp"

namespace dashpad::app {

namespace {

constexpr const char* explore_footer = R"(Examples:
  dashpad explore examples/dashboard-20mph.toml --out ./my-page.html
  dashpad explore examples/helmet-pad-10fps.toml --standard en-1078 --out ./my-page.html
  dashpad explore examples/dashboard-20mph.toml --set pad.thickness="30 mm" --units us --out ./my-page.html

The page is one file of 1.2 MB that opens in a browser without a network, also on a phone. It contains the solver:
change thickness, speed, mass, foam, nose, support or standard, and the answer, the drawing and the curves follow. The
page compares up to four pads side by side, finds the thinnest one that passes, and lets you copy the case as a file or
a link. Its numbers are those of dashpad run and dashpad assess.

The engine of the page is compiled once, by ./do wasm.

Exit codes: 0 written; 1 the page could not be written; 2 invalid input or command line (nothing was written).)";

struct ExploreRequest {
  GivenCase given;
  std::string standard;
  OutputFiles files;
};

int explore(const ExploreRequest& request) {
  std::vector<std::string> errors;
  const std::string engine = read_engine(errors);
  const live::Folders folders{chosen_folder(""), chosen_standards("")};
  const std::optional<input::CaseFile> given = read_case(request.given, errors);
  std::vector<input::InputFile> files = files_of(request.given.file, given);
  check_live_standard("--standard", request.standard, errors);
  if (errors.empty() && !request.standard.empty())
    standard_of(request.standard, folders.standards, files, errors);
  if (request.files.of("--out").empty())
    errors.emplace_back("--out: is missing; give the page to write, such as --out page.html");
  judge_files(request.files, files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));

  const live::LivePage page{.case_text = live_case_text(request.given, *given),
                            .standard = request.standard,
                            .units = unit_system(request.files.units).name,
                            .engine = engine};
  publish(
      request.files.targets(), request.files.force,
      [&](const Target&) { return live::live_page(page, folders); },
      fmt::format("Wrote {}: it solves the case again as you change its numbers.\n",
                  request.files.of("--out")));
  return exit_done;
}

}  // namespace

std::string read_engine(std::vector<std::string>& errors) {
  const std::filesystem::path file = chosen_engine();
  std::ifstream stream(file, std::ios::binary);
  std::string engine{std::istreambuf_iterator<char>(stream), {}};
  if (engine.empty())
    errors.push_back(fmt::format(
        "{}: the engine of the live page is missing; ./do wasm makes it in two minutes", file.string()));
  return engine;
}

std::string live_case_text(const GivenCase& request, const input::CaseFile& given) {
  const std::filesystem::path shipped = chosen_folder("");
  const bool is_plain =
      request.settings.empty() && request.materials.empty() &&
      std::ranges::all_of(given.files.begin() + 1, given.files.end(),
                          [&](const input::InputFile& file) { return file.file.parent_path() == shipped; });
  return is_plain ? input::read_text_file(request.file).value()
                  : output::case_toml(given.impact, given.options);
}

void check_live_standard(const char* option, const std::string& name, std::vector<std::string>& errors) {
  if (input::standard_choice(name).name.ends_with(".toml"))
    errors.push_back(fmt::format("{} {}: a live page has the standards that come with the program, not files",
                                 option, name));
}

void add_explore(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<ExploreRequest>(
      app, action, "explore", "Write a live page that solves the case again as you drag its numbers",
      explore_footer, explore);
  add_case(sub, request.given);
  add_file(sub, request.files, "--out", "The page (.html)");
  add_option(sub, "--standard NAME[:VARIANT]", request.standard, "Standard to begin with");
  add_units(sub, request.files.units);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
