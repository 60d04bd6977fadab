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
  std::vector<input::Fault> faults;
  const auto rate = value_of(request, "rate", "--rate", "1/s", faults);
  input::StressStrainColumns columns;
  columns.thickness = value_of(request, "thickness", "--thickness", "m", faults);
  columns.area = value_of(request, "area", "--area", "m2", faults);
  if (!faults.empty()) return faults_json(faults);
  const std::vector<double> rates(rate ? names.size() : 0, rate.value_or(0));
  auto proposal = fit::propose({names.begin(), names.end()}, rates, columns);
  if (!proposal) return faults_json(proposal.faults());
  const fit::AutoFit result = fit::run_proposal(*std::move(proposal));
  Json answer;
  if (result.report.converged) answer["card"] = output::card_toml(result.report.material);
  add_page(answer, output::proposal_document(result, units_of(request), output::Pictures::drawn),
           units_of(request));
  return answer;
}

}  // namespace dashpad::live
