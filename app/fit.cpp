// dashpad fit: from measurements to a material card.

#include <memory>
#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/fit/fit_file.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/fit.hpp"
#include "output.hpp"
#include "progress_line.hpp"

namespace dashpad::app {

namespace {

constexpr const char* fit_footer = R"(Examples:
  dashpad fit examples/fits/vn600.toml                         what the data say, and what they leave open
  dashpad fit examples/fits/vn600.toml --output my-foam.toml   the card, with its origin
  dashpad fit my-fit.toml --json fit.json --posterior 1000 draws.csv

A fit file names the law with its starting values, the unknowns with their bounds, and the measurements:

  [pad]
  law = "foam"
  [pad.parameters]
  friction = 0.05
  [pad.curve]                      # as in a case; the numbers are where the search begins
  form = "hyperfoam"
  rate = "0.01 1/s"
  first_modulus = "50 kPa"
  first_exponent = 8
  second_modulus = "0 kPa"
  second_exponent = 1
  highest_strain = 0.6
  [unknowns]
  "pad.curve.first_modulus" = {bounds = ["1 kPa", "1 MPa"]}
  "pad.parameters.friction" = {bounds = [0, 0.4], prior = {mean = 0.05, deviation = 0.02}}
  [[tests]]
  file = "loop.csv"                # columns strain and stress_kPa
  strain_unit = "fraction"
  rate = "0.01 1/s"
  noise = "1 %"

[[impacts]] fit the law through impacts: case = "drop.toml", peak_force = {value = "1.8 kN", deviation = "5 %"}.
docs/fits.md has every key, and what the numbers mean.

An interval that is open says that the data do not determine the unknown: leave it fixed, give it a prior, or test more.

Files: - as FILE is standard output. An existing file is kept unless --force is given. A file is written whole or not
at all. A fit that did not converge writes no card.

Exit codes: 0 done, 1 a result could not be written, 2 the fit file or its data have faults and nothing was written,
3 the fit did not converge.)";

struct FitRequest {
  std::string file;
  std::optional<std::string> card, json;
  std::vector<std::string> posterior;  ///< N and FILE
  std::string units;
  std::string materials;
  bool force = false;
};

constexpr std::size_t most_draws = 1'000'000;

/// 0 without --posterior, or where it is wrong.
std::size_t draws_of(const FitRequest& request, std::vector<std::string>& wrong) {
  if (request.posterior.empty()) return 0;
  const std::string& text = request.posterior.front();
  const bool digits =
      !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t count = digits ? std::stoul(text) : 0;
  if (count >= 1 && count <= most_draws) return count;
  wrong.push_back(
      fmt::format("--posterior {}: must be a whole number of draws, 1 to {}, then a file", text, most_draws));
  return 0;
}

std::vector<Target> fit_targets(const FitRequest& request) {
  std::vector<Target> targets;
  if (request.card) targets.push_back({"--output", *request.card});
  if (request.json) targets.push_back({"--json", *request.json});
  if (request.posterior.size() == 2) targets.push_back({"--posterior", request.posterior.back()});
  return targets;
}

int fit_material(const FitRequest& request, const std::filesystem::path& materials) {
  std::vector<std::string> wrong;
  const std::size_t draws = draws_of(request, wrong);
  std::optional<fit::FitFile> input;
  try {
    input = fit::read_fit(request.file, materials);
  } catch (const input::InputError& error) {
    add_lines(error.faults(), wrong);
  }
  std::vector<Target> targets = fit_targets(request);
  judge_targets(targets, input ? input->files : std::vector<input::InputFile>{{"the fit file", request.file}},
                request.force, wrong);
  if (!wrong.empty()) throw Refused(std::move(wrong));
  const fit::FitReport report = [&] {
    const ProgressLine line{"Fitting"};
    return fit::run_fit(input->fit, draws);
  }();
  // Without convergence there is no card and no sample.
  if (!report.converged) std::erase_if(targets, [](const Target& of) { return of.option != "--json"; });
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return output::fit_json(report);
    if (target.option == "--posterior") return output::posterior_csv(report);
    return output::card_toml(report.material);
  };
  std::string account = output::fit_text(report, unit_system(request.units));
  for (const Target& target : targets)
    if (!target.is_standard_output()) account += "written: " + target.file + "\n";
  if (!report.posterior.empty())
    account +=
        "The draws are from the Laplace approximation: normal in the coordinates of the search, cut off at "
        "the "
        "bounds.\n";
  publish(targets, request.force, text_of, account);
  return report.converged ? exit_done : exit_not_trusted;
}

}  // namespace

void add_fit(CLI::App& app, Action& action, const std::filesystem::path& executable) {
  CLI::App* sub = app.add_subcommand("fit", "A material card from measurements, with its uncertainty");
  const auto request = std::make_shared<FitRequest>();
  sub->add_option("FIT", request->file, "Fit file (TOML)")->required()->type_name("");
  sub->add_option("-o,--output", request->card, "Write the material card (- for standard output)")
      ->type_name("FILE");
  sub->add_option("--json", request->json, "Write everything as JSON, SI (- for standard output)")
      ->type_name("FILE");
  sub->add_option("--posterior", request->posterior, "Write N draws of the unknowns as CSV")
      ->expected(2)
      ->type_name("N FILE");
  add_units(*sub, request->units);
  add_force(*sub, request->force);
  add_material_folder(*sub, request->materials);
  sub->footer(fit_footer);
  sub->callback([request, &action, executable] {
    action = [request, executable] {
      return fit_material(*request, chosen_folder(request->materials, executable));
    };
  });
}

}  // namespace dashpad::app
