#include "dashpad/case/case_field.hpp"

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {
namespace {

template <class Owner>
void add_fields(const std::string& table, std::vector<CaseField>& into) {
  for (const Parameter<Owner>& parameter : Owner::parameters)
    into.push_back({table, parameter.key, parameter.unit, rule_of(parameter.bounds, parameter.unit),
                    parameter.left_out, parameter.of(Owner()), parameter.meaning});
}

}  // namespace

std::vector<CaseField> case_fields() {
  std::vector<CaseField> all;
  add_fields<Impactor>("impactor", all);
  add_fields<Pad>("pad", all);
  add_fields<PadCondition>("pad", all);
  add_fields<PadLayer>("pad.layers", all);
  add_fields<PadCondition>("pad.layers", all);
  add_fields<Backing>("support", all);
  add_fields<Blows>("blows", all);
  add_fields<Options>("solver", all);
  return all;
}

}  // namespace dashpad
