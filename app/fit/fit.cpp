// dashpad fit: from measurements to a material card.

#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/fit.hpp"
#include "dashpad/version.hpp"
#include "fit/request.hpp"
#include "input/measurement/measurement_text.hpp"
#include "quantities/text.hpp"

namespace dashpad::app {

namespace {

constexpr const char* fit_footer = R"(Examples:
  dashpad fit examples/fits/vn600.toml                         the fitted values, and what the data do not determine
  dashpad fit examples/fits/vn600.toml --output my-foam.toml   the card, which states its origin
  dashpad fit my-fit.toml --json fit.json --posterior 1000 draws.csv
  dashpad fit my-fit.toml --report fit.html                    a page: model and data, intervals, what is not determined
  dashpad fit my-fit.toml --case fitted.toml                   the case with the fitted support, nose or mass
  dashpad fit my-fit.toml --state my-fit.state                 saves the fit's progress; repeat the command to resume
  dashpad fit --auto examples/fits/vn600-quasi-static.csv --strain-unit fraction --rate "8.4e-5 1/s"   without a fit file
  dashpad fit --auto slow.csv fast.csv --rate "0.01 1/s" --rate "100 1/s" --proposal my-fit.toml -o my-foam.toml

A fit file states the law with its starting values, the unknowns with their bounds, and the measurements:

  [pad]
  law = "foam"
  [pad.parameters]
  friction = 0.05
  [pad.curve]                      # as in a case; the numbers are the starting values
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
  file = "loop.csv"                # with columns strain and stress_kPa
  strain_unit = "fraction"
  rate = "0.01 1/s"
  noise = "1 %"

[[impacts]] fits the law to impacts, using individual figures or whole measured pulses:

  [[impacts]]
  case = "drop.toml"
  peak_force = {value = "1.8 kN", deviation = "5 %"}
  hic15 = {value = 640, deviation = "5 %"}          # also hic36, hic_unlimited, clip_3ms, rebound_speed, ...
  pulse = {file = "drop.csv", deviation = "3 g", filter = "CFC180"}   # or relative to its peak, "5 %"

With --auto, the files are compression tests (as for dashpad material import), one foam in all of them. The law, its
base curve and the unknowns are chosen from what was measured (rates, unloading, holds, highest strain); several are
tried, and the answer states what the tests do not determine and what to measure next. Rates are computed from the times
in the files, or given by --rate, one for each. --proposal writes the fit file, to which [[impacts]] can be added.

docs/fits.md describes every key and what the results mean.

If the recoil of a foam is not given and the impacts depend on it, it is fitted too; to keep it fixed, give it in
[pad.parameters]. The card gives the tested range in [fitted], and what is not known in reservations and [uncertainty].

An unbounded interval means that the data do not determine the unknown: keep it fixed, give it a prior, or test more.

Files: - as FILE means standard output. An existing file is not overwritten unless --force is given. A file is
written completely or not at all. If the fit does not converge, no card is written.

If the fit is interrupted (Ctrl-C, SIGTERM), no result is written, but the file given with --state contains the
finished searches and intervals, and the same command resumes from there. The state of a different fit is rejected.

Exit codes: 0 success, 1 a result could not be written, 2 errors in the fit file or the data (nothing was written),
3 the fit did not converge, 130 or 143 stopped by Ctrl-C or SIGTERM.)";

constexpr std::size_t max_draws = 1'000'000;

/// Depends on the contents of all input files, and on the version.
std::string fingerprint_of(const std::vector<input::InputFile>& files) {
  std::vector<std::string> texts{std::string{version()}};
  for (const input::InputFile& input_file : files) texts.push_back(input::read_measurement(input_file.file));
  return fingerprint(texts);
}

/// Checks --state, which unlike the results may exist, since it is read.
void judge_state(const FitRequest& request, const std::vector<Target>& targets,
                 const std::vector<input::InputFile>& inputs, const fit::Fit& fit,
                 const fit::RunOptions& options, std::vector<std::string>& errors) {
  if (!request.state) return;
  if (*request.state == "-") {
    errors.emplace_back("--state -: must be a file");
    return;
  }
  std::vector<Target> all = targets;
  all.push_back({"--state", *request.state});
  const std::size_t before = errors.size();
  judge_targets(all, inputs, true, errors);
  if (errors.size() > before) return;
  try {
    fit::check_state(fit, options);
  } catch (const std::runtime_error& error) {
    errors.push_back(fmt::format("--state {}", error.what()));
  }
}

/// A note on numbers that no card holds, unless --case is given.
std::string kept_by_case(const FitRequest& request, const fit::FitReport& report) {
  if (!request.files.of("--case").empty() || !report.fitted_case) return "";
  std::string keys;
  for (const fit::FittedUnknown& fitted_unknown : report.unknowns)
    if (!fitted_unknown.is_nuisance && !fit::is_of_card(fitted_unknown.key))
      keys += (keys.empty() ? "" : ", ") + fitted_unknown.key;
  return "Fitted but not part of a card: " + keys + "; --case FILE writes the whole fitted case.\n";
}

int fit_material(const FitRequest& request) {
  if (request.is_auto) return fit_automatically(request);
  // Covers everything from reading to writing, so that neither is left half done.
  const StopSignal signal;
  std::vector<std::string> errors;
  const std::size_t draws = draws_of(request, errors);
  if (request.inputs.size() > 1)
    errors.emplace_back("FILE: only one fit file can be given; to fit tests without one, give --auto");
  if (!request.tests.rates.empty() || request.tests.has_columns() || !request.files.of("--proposal").empty())
    errors.emplace_back(
        "--rate, --strain, --stress, --time, --time-unit, --strain-unit, --stress-unit, --thickness, --area, "
        "--proposal: "
        "need "
        "--auto; a fit file has keys for them");
  const std::string& file = request.inputs.front();
  std::optional<fit::FitFile> input = taken(fit::read_fit(file, chosen_folder(request.materials)), errors);
  std::vector<Target> targets = fit_targets(request);
  const std::vector<input::InputFile> files =
      input ? input->files : std::vector<input::InputFile>{{"the fit file", file}};
  judge_targets(targets, files, request.files.force, errors);
  if (const std::string& fitted_case = request.files.of("--case");
      !fitted_case.empty() && input && !fit::finds_more_than_a_card(input->fit))
    errors.push_back(
        fmt::format("--case {}: this fit has no unknown outside the card "
                    "(support.stiffness would be one); use --output, which writes all fitted values",
                    fitted_case));
  fit::RunOptions options{.posterior = draws};
  if (request.state && input) {
    options.state = *request.state;
    options.fingerprint = fingerprint_of(files);
    judge_state(request, targets, files, input->fit, options, errors);
  }
  if (!errors.empty()) throw Refused(std::move(errors));
  fit::FitReport report;
  try {
    report =
        with_progress(options, [&](const fit::RunOptions& with) { return fit::run_fit(input->fit, with); });
  } catch (const fit::Stopped& stop) {
    return stopped(request, stop.kept());
  }
  // Without convergence there is neither card nor sample.
  if (!report.converged) drop_results(targets);
  const auto document = [&](output::Pictures pictures) {
    return output::fit_document(report, unit_system(request.files.units), pictures);
  };
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return output::fit_json(report);
    if (target.option == "--posterior") return output::posterior_csv(report);
    if (target.option == "--case") return output::fitted_case_toml(report);
    return is_document(target) ? document_text(target, document) : output::card_toml(report.material);
  };
  const std::string account =
      output::to_terminal(document(output::Pictures::left_out), output::Detail::main) +
      written_words(request, targets, report);
  publish(targets, request.files.force, text_of, account);
  return report.converged ? exit_done : exit_not_trusted;
}

}  // namespace

std::size_t draws_of(const FitRequest& request, std::vector<std::string>& errors) {
  if (request.posterior.empty()) return 0;
  const std::string& text = request.posterior.front();
  const bool digits =
      !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t count = digits ? std::stoul(text) : 0;
  if (count >= 1 && count <= max_draws) return count;
  errors.push_back(fmt::format(
      "--posterior {}: must be a whole number of draws from 1 to {}, followed by a file", text, max_draws));
  return 0;
}

std::vector<Target> fit_targets(const FitRequest& request) {
  std::vector<Target> targets = request.files.targets();
  if (request.posterior.size() == 2) targets.push_back({"--posterior", request.posterior.back()});
  return targets;
}

void drop_results(std::vector<Target>& targets) {
  std::erase_if(targets, [](const Target& target) { return target.option != "--json"; });
}

std::string written_words(const FitRequest& request, const std::vector<Target>& targets,
                          const fit::FitReport& report) {
  std::string words;
  for (const Target& target : targets)
    if (!target.is_standard_output()) words += "written: " + target.file + "\n";
  if (!request.is_auto) words += kept_by_case(request, report);
  if (!report.posterior.empty())
    words +=
        "The draws are from the Laplace approximation: normal in the search coordinates, and truncated at "
        "the bounds.\n";
  return words;
}

int stopped(const FitRequest& request, std::size_t kept) {
  if (kept > 0) {
    write_error(
        fmt::format("Stopped; nothing was written except {} (finished searches and interval limits: {}). "
                    "Run the same command again to resume.\n",
                    *request.state, kept));
  } else if (request.is_auto) {
    write_error("Stopped; nothing was written.\n");
  } else if (request.state) {
    write_error("Stopped before any search was finished; nothing was written.\n");
  } else {
    write_error(
        "Stopped; nothing was written. With --state FILE, finished searches and intervals are saved, and the "
        "same command resumes from them.\n");
  }
  return StopSignal::exit_code();
}

void add_fit(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<FitRequest>(
      app, action, "fit", "Fit a material card to measurements, with uncertainties", fit_footer,
      fit_material);
  add_option(sub, "FILE", request.inputs, "Fit file (TOML), or with --auto tables of compression tests")
      ->required();
  add_flag(sub, "--auto", request.is_auto,
           "Propose law, base curve and unknowns from what the tests measured, and fit them");
  add_file(sub, request.files, "--proposal",
           "Write the proposed fit file, to be edited (- for standard output)");
  add_test_columns(sub, request.tests);
  add_option(sub, "--time COLUMN", request.tests.columns.time,
             "Column of times, from which the rates are computed (default: the only one)");
  add_option(sub, "--time-unit UNIT", request.tests.columns.time_unit, "Unit of the times, such as s");
  add_file(sub, request.files, "-o,--output", "Write the material card (- for standard output)");
  add_file(sub, request.files, "--case",
           "Write the case with the fitted foam and any other fitted values, such as the support stiffness "
           "(- for standard output)");
  add_file(sub, request.files, "--json", "Write everything as JSON, in SI units (- for standard output)");
  sub.add_option("--posterior", request.posterior, "Write N draws of the unknowns as CSV")
      ->expected(2)
      ->type_name("N FILE");
  add_documents(sub, request.files);
  add_option(sub, "--state FILE", request.state,
             "Save finished searches and intervals in this file, and resume from it");
  add_units(sub, request.files.units);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.materials);
}

}  // namespace dashpad::app
