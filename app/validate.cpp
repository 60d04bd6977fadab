// dashpad validate: repeats the validation study of the 1986 report.

#include <algorithm>
#include <csignal>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/report1986/validation_report.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* validate_footer = R"(Examples:
  dashpad validate --report validation.html --json validation.json --figures figures
  dashpad validate --strict --data my-readings

Compares the accurate solver and the 1984 program with the 33 validation tests of Crash Padding Research,
Volume III (1986): errors test by test, verdicts based on rules fixed before the first run, refitted trend
lines, the report's own statements, and the nose radius that the readings favour. All values are in the units of
the report: lb, in, mph, ms. docs/validation.md gives the results and states what remains uncertain.

Files: the report is a single HTML file; the figures are image files in a folder that is created if necessary.
- as FILE means standard output; the summary then goes to standard error. Existing files are not overwritten unless
--force is given. The files are written all together at the end, or not at all.

Exit codes: 0 success, whether or not the predictions pass; 4 with --strict, if the accurate solver does not meet
a rule; 1 a result could not be written; 2 invalid input (nothing was run).)";

constexpr const char* material = "ensolite-aac-9.toml";

struct ValidateRequest {
  OutputFiles files;
  std::optional<std::string> figures;
  std::string format = "svg";
  std::string data;
  std::string materials;
  bool strict = false;
};

struct ValidateInput {
  report1986::ValidationData data;
  Material ensolite;
};

std::vector<Target> stills(const ValidateRequest& request) {
  std::vector<Target> wanted;
  if (!request.figures) return wanted;
  for (const std::string& slug : report1986::validation_figure_slugs())
    wanted.push_back({"--figures", (fs::path{*request.figures} / (slug + "." + request.format)).string()});
  return wanted;
}

/// The files to be written, as far as can be checked before the run; the folder of figures may not exist.
std::vector<Target> targets_to_judge(const ValidateRequest& request, std::vector<std::string>& errors) {
  std::vector<Target> targets = request.files.targets();
  if (!request.figures) return targets;
  const fs::path folder{*request.figures};
  std::error_code error;
  if (folder.empty() || folder == "-")
    errors.emplace_back("--figures: needs the name of a folder");
  else if (fs::is_directory(folder, error))
    std::ranges::move(stills(request), std::back_inserter(targets));
  else if (fs::exists(fs::symlink_status(folder, error)))
    errors.push_back(fmt::format("--figures {}: is not a folder", *request.figures));
  else  // a file of this name is refused for the same reasons as the folder
    targets.push_back({"--figures", (folder.has_filename() ? folder : folder.parent_path()).string()});
  return targets;
}

ValidateInput read_and_check(const ValidateRequest& request) {
  std::vector<std::string> errors;
  const std::vector<Target> targets = targets_to_judge(request, errors);

  ValidateInput input;
  std::vector<input::Fault> faults;
  input.data = report1986::read_validation_data(chosen_measured_tests(request.data), faults);
  add_lines(faults, errors);
  std::vector<input::InputFile> inputs = input.data.files;
  inputs.push_back({"the material card", chosen_folder(request.materials) / material});
  judge_targets(targets, inputs, request.files.force, errors);
  if (auto card = taken(input::read_material(inputs.back().file), errors)) input.ensolite = *std::move(card);
  if (!errors.empty()) throw Refused(std::move(errors));
  return input;
}

/// Holds back interrupts while it lives, so that all files are published together.
class InterruptsHeld {
 public:
  InterruptsHeld() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&signals, signal);
    ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
  }
  ~InterruptsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  InterruptsHeld(const InterruptsHeld&) = delete;
  InterruptsHeld& operator=(const InterruptsHeld&) = delete;

 private:
  sigset_t before_{};
};

/// The texts of all files, by file, before the first is written.
std::map<std::string, std::string> texts_of(const ValidateRequest& request, const report1986::Study& study) {
  std::map<std::string, std::string> texts;
  const auto document = [&](output::Pictures pictures) {
    return report1986::validation_document(study, pictures);
  };
  for (const Target& target : request.files.targets())
    texts[target.file] =
        is_document(target) ? document_text(target, document) : report1986::validation_json(study);
  if (!request.figures) return texts;
  const std::vector<Target> targets = stills(request);
  const std::vector<report1986::ValidationFigure> figures = report1986::validation_figures(study);
  ProgressLine line{"Drawing the figures"};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    texts[targets[i].file] = picture_text(figures[i].plot, targets[i]);
    line.show(i + 1, figures.size());
  }
  return texts;
}

void write_results(const ValidateRequest& request, const report1986::Study& study) {
  const std::map<std::string, std::string> texts = texts_of(request, study);
  std::vector<Target> targets = request.files.targets();
  for (Target& still : stills(request)) targets.push_back(std::move(still));
  const InterruptsHeld held;
  if (request.figures) fs::create_directory(*request.figures);
  publish(
      targets, request.files.force, [&](const Target& target) { return texts.at(target.file); },
      output::to_terminal(report1986::validation_document(study), output::Detail::main));
}

int run_validation(const ValidateRequest& request) {
  const ValidateInput input = read_and_check(request);
  const report1986::Study study = [&] {
    ProgressLine line{"Simulating the tests"};
    return report1986::run_study(input.data, input.ensolite,
                                 [&](std::size_t done, std::size_t all) { line.show(done, all); });
  }();
  write_results(request, study);
  return request.strict && !report1986::passes(study) ? exit_not_passed : exit_done;
}

}  // namespace

void add_validate(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<ValidateRequest>(
      app, action, "validate", "Compare the model with the validation tests of the 1986 report",
      validate_footer, run_validation);
  add_documents(sub, request.files);
  add_file(sub, request.files, "--json", "Write everything as JSON (- for standard output)");
  CLI::Option* figures =
      add_option(sub, "--figures DIR", request.figures, "Write the figures to this folder");
  add_option(sub, "--format FORMAT", request.format, "Format of the figures: svg (default), png or pdf")
      ->check(CLI::IsMember({"svg", "png", "pdf"}))
      ->needs(figures);
  add_option(sub, "--data DIR", request.data,
             "Folder of the measured tests (default: $DASHPAD_VALIDATION_DATA, or those supplied)");
  add_flag(sub, "--strict", request.strict, "Exit with code 4 if the accurate solver does not meet a rule");
  add_force(sub, request.files.force);
  add_material_folder(sub, request.materials);
}

}  // namespace dashpad::app
