// dashpad standards: lists the presets of test standards, or shows one.

#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/assessment.hpp"
#include "output_files.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* standards_footer = R"(Examples:
  dashpad standards                              all presets, one per line
  dashpad standards fmvss-201-instrument-panel   one preset: impactor, limits, variants, sources
  dashpad standards en-1078:kerbstone            with a variant
  dashpad standards ./my-standard.toml           a preset from anywhere: a name that ends in .toml is read as a file

A value marked UNVERIFIED was found neither in the standard nor in a source that quotes it. dashpad assess applies a
preset to a case. docs/standards.md explains how to write a preset.

Exit codes: 0 success, 1 a page could not be written, 2 no such preset, or a preset with errors (the others are
still listed).)";

struct StandardsRequest {
  std::string name;
  OutputFiles files;
  std::string folder;
};

int show_one(const StandardsRequest& request, const fs::path& folder) {
  const input::StandardChoice choice = input::standard_choice(request.name);
  const fs::path file = input::find_standard(choice.name, folder).value();
  std::vector<std::string> errors;
  judge_files(request.files, {{"the standard", file}}, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  injury::Standard standard = input::read_standard(file).value();
  try {
    standard = injury::with_variants(standard, choice.variants);
  } catch (const std::invalid_argument& error) {
    throw Refused({error.what()});
  }
  const output::Document document = output::standard_document(standard, unit_system(request.files.units));
  publish(
      request.files, [&](output::Pictures) { return document; }, {},
      output::to_terminal(document, output::Detail::all));
  return exit_done;
}

/// A preset with faults does not hide the others.
int list_all_standards(const fs::path& folder) {
  std::string text = fmt::format("Standards in {}:\n", folder.string());
  std::vector<std::string> faults;
  for (const fs::path& file : input::list_standards(folder).value())
    if (const auto standard = taken(input::read_standard(file), faults))
      text += output::standard_line(*standard);
  write_output(text);
  if (!faults.empty()) throw Refused(std::move(faults));
  return exit_done;
}

int show_standards(const StandardsRequest& request) {
  const fs::path folder = chosen_standards(request.folder);
  if (!request.name.empty()) return show_one(request, folder);
  if (!request.files.targets().empty())
    throw Refused({"--report, --markdown: apply to a single preset; give its NAME"});
  return list_all_standards(folder);
}

}  // namespace

void add_standards(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<StandardsRequest>(
      app, action, "standards", "List the presets of test standards, or show one", standards_footer,
      show_standards);
  add_option(sub, "NAME", request.name, "Preset to show in full");
  add_documents(sub, request.files);
  add_force(sub, request.files.force);
  add_units(sub, request.files.units);
  add_standard_folder(sub, request.folder);
}

}  // namespace dashpad::app
