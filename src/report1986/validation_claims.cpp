// The report's statements that can be computed again.

#include <fmt/format.h>

#include "dashpad/report1986/validation/claims.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

output::Table claims_table(const Study& study) {
  output::Table table{.columns = {"where", "statement", "printed", "computed", "agrees", "remark"}};
  for (const ReportClaim& claim : check_claims(study.data)) {
    const std::string unit = claim.unit == "1" ? "" : " " + shown_unit(claim.unit);
    table.rows.push_back({claim.where, claim.claim, brief(claim.printed) + unit,
                          fmt::format("{:.4g}{}", claim.computed, unit), claim.agrees ? "yes" : "NO",
                          claim.remark});
  }
  return table;
}

}  // namespace dashpad::report1986
