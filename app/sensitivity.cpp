// dashpad sensitivity: the effect of each number of a case on the figures of its impact.

#include <algorithm>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/output/sensitivity.hpp"
#include "dashpad/sensitivity/sensitivity.hpp"
#include "dashpad/study/responses.hpp"
#include "input/spelling.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

constexpr const char* sensitivity_footer = R"(Examples:
  dashpad sensitivity examples/dashboard-20mph.toml
  dashpad sensitivity examples/dashboard-20mph.toml --figure hic15 --report ./what-matters.html
  dashpad sensitivity examples/head-on-door-panel.toml --picture ./tornado.svg
  dashpad sensitivity examples/dashboard-20mph.toml --set pad.thickness="1 in" --csv - | sort

Shows by how many per cent each figure changes if a number of the case grows by 1 % (the elasticity d ln f / d ln p),
with its numerical error and the derivative, and alongside it the effect of what is uncertain about the foam and the
model. A number at its bound is varied to one side only; a number that is 0 is left out, since 1 % of 0 is 0. "kink" and
"jump" mark figures that are not smooth at the value of the case. For large changes, use a study.

Exit codes: 0 success, 1 a result could not be written, 2 invalid input or command line (nothing was run), 3 the tolerance
was not met, so that the figures are not reliable, or the impact does not have the figure.)";

struct SensitivityRequest {
  GivenCase given;
  std::string figure = "peak_acceleration";
  std::optional<std::string> tolerance;
  bool no_intervals = false;
  OutputFiles files;
};

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const ResultQuantity& kind : study::response_kinds()) names.emplace_back(kind.key);
  return names;
}

int run_sensitivity(const SensitivityRequest& request) {
  std::vector<std::string> errors;
  const std::vector<std::string> names = figure_names();
  if (std::ranges::find(names, request.figure) == names.end())
    errors.push_back(fmt::format("--figure {}: no such figure{}", request.figure,
                                 input::meant_or_listed(request.figure, names)));
  judge_picture(request.files, errors);
  const input::CaseFile input = case_to_solve(
      request.given, request.tolerance, std::move(errors),
      [&](const auto& files, auto& complaints) { judge_files(request.files, files, complaints); });
  const sensitivity::Answer answer = [&] {
    ProgressLine line{"Varying the numbers of the case"};
    constexpr std::size_t all = 1000;
    return sensitivity::sensitivities(input.impact, input.options, !request.no_intervals, [&](double share) {
      line.show(static_cast<std::size_t>(share * static_cast<double>(all)), all);
    });
  }();
  const auto found = std::ranges::find(answer.figures, request.figure,
                                       [](const ResultQuantity* figure) { return std::string(figure->key); });
  if (found == answer.figures.end()) {
    std::string others;
    for (const ResultQuantity* one : answer.figures)
      others += std::string(others.empty() ? "" : ", ") + one->key;
    for (const Flag& flag : answer.flags) write_error(flag.text + "\n");
    write_error(fmt::format("{}: the impact does not have this figure, or it is 0; --figure may name {}\n",
                            request.figure, others));
    return exit_not_trusted;
  }
  const auto figure = static_cast<std::size_t>(found - answer.figures.begin());
  const UnitSystem& units = unit_system(request.files.units);
  publish(request.files,
          [&](output::Pictures pictures) {
            return output::sensitivity_document(answer, figure, request.given.file, units, pictures);
          },
          {{"--json", [&](const Target&) { return output::sensitivity_json(answer, request.given.file); }},
           {"--csv", [&](const Target&) { return output::sensitivity_csv(answer); }},
           {"--picture", [&](const Target& target) {
              return picture_text(output::sensitivity_plot(answer, figure), target);
            }}});
  const bool is_unusable = std::ranges::any_of(
      answer.flags, [](const Flag& flag) { return severity_of(flag.name) == Severity::unusable; });
  return is_unusable ? exit_not_trusted : exit_done;
}

}  // namespace

void add_sensitivity(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<SensitivityRequest>(
      app, action, "sensitivity", "Show which numbers of a case affect the result most", sensitivity_footer,
      run_sensitivity);
  add_case(sub, request.given);
  add_option(sub, "--figure NAME", request.figure, "The figure to answer about (default: peak_acceleration)");
  add_file(sub, request.files, "--json",
           "Write all derivatives as JSON, in SI units (- for standard output)");
  add_file(sub, request.files, "--csv", "Write a row for each number and figure");
  add_file(sub, request.files, "--picture", "Draw the effect of 1 % of each number: .svg, .png or .pdf");
  add_documents(sub, request.files);
  add_units(sub, request.files.units);
  add_all(sub, request.files.detail);
  add_tolerance(sub, request.tolerance);
  add_no_intervals(sub, request.no_intervals);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
