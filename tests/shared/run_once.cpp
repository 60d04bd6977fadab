#include "shared/run_once.hpp"

#include "impact/contacts.hpp"
#include "impact/march.hpp"

namespace dashpad::test {

Run run_once(const ImpactCase& impact, double resolution, const Options& options) {
  Run run;
  Contacts().visit(impact, ColumnMath::vector, [&](auto& contact) {
    March march(impact, contact, options);
    run.figures = march.run(resolution, run.track);
  });
  return run;
}

}  // namespace dashpad::test
