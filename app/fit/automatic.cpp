// dashpad fit --auto: from tests to a proposed fit and its card.

#include "dashpad/fit/proposal.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/fit.hpp"
#include "dashpad/output/proposal.hpp"
#include "fit/request.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

int fit_automatically(const FitRequest& request) {
  const StopSignal signal;
  std::vector<std::string> errors;
  const std::size_t draws = draws_of(request, errors);
  if (request.state) errors.emplace_back("--state: does not go with --auto, whose fits are short");
  if (!request.files.of("--case").empty())
    errors.emplace_back("--case: does not go with --auto, which fits tests of the foam alone");
  const std::vector<double> rates = rates_of(request.tests, request.inputs.size(), errors);
  const input::StressStrainColumns columns = columns_of(request.tests, errors);
  const std::vector<fs::path> files(request.inputs.begin(), request.inputs.end());
  std::vector<input::InputFile> inputs;
  for (const fs::path& file : files) inputs.push_back({"the measurements", file});
  std::vector<Target> targets = fit_targets(request);
  judge_targets(targets, inputs, request.files.force, errors);
  std::optional<fit::Proposal> proposal;
  if (errors.empty()) proposal = taken(fit::propose(files, rates, columns), errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  fit::AutoFit result;
  try {
    result = with_progress({.posterior = draws}, [&](const fit::RunOptions& with) {
      return fit::run_proposal(*std::move(proposal), with);
    });
  } catch (const fit::Stopped& stop) {
    return stopped(request, stop.kept());
  }
  if (!result.report.converged) drop_results(targets);
  const auto document = [&](output::Pictures pictures) {
    return output::proposal_document(result, unit_system(request.files.units), pictures);
  };
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return output::proposal_json(result);
    if (target.option == "--posterior") return output::posterior_csv(result.report);
    if (target.option == "--proposal")
      return output::proposal_toml(
          result, target.is_standard_output() ? fs::path(".") : fs::path(target.file).parent_path());
    return is_document(target) ? document_text(target, document) : output::card_toml(result.report.material);
  };
  publish(targets, request.files.force, text_of,
          output::to_terminal(document(output::Pictures::left_out), output::Detail::main) +
              written_words(request, targets, result.report));
  return result.report.converged ? exit_done : exit_not_trusted;
}

}  // namespace dashpad::app
