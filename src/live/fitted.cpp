#include "live/fitted.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/fit/proposal.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/proposal.hpp"
#include "live/request.hpp"

namespace dashpad::live {

Json fit_tests(const Json& request) {
  const std::vector<std::string> names = texts_of(request, "files");
  const std::vector<std::filesystem::path> files(names.begin(), names.end());
  std::vector<double> rates;
  if (const auto given = request.find("rates"); given != request.end() && given->is_array())
    for (const Json& rate : *given) rates.push_back(rate.is_number() ? rate.get<double>() : 0);
  auto proposal = fit::propose(files, rates, {});
  if (!proposal) {
    // Whether it is the rates alone that are missing.
    const std::vector<double> some(files.size(), 1.0);
    if (rates.empty() && fit::propose(files, some, {})) return {{"rates", files.size()}};
    return faults_json(proposal.faults());
  }
  const fit::AutoFit result = fit::run_proposal(*std::move(proposal));
  Json answer{{"card", output::card_toml(result.report.material)}};
  add_page(answer, output::proposal_document(result, units_of(request), output::Pictures::drawn),
           units_of(request));
  return answer;
}

}  // namespace dashpad::live
