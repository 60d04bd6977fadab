#include "dashpad/output/page/page.hpp"

#include <stdexcept>

#include "output/page/data.hpp"
#include "output/page/page_template.hpp"

namespace dashpad::output {

bool has_page() { return !page_before_data.empty(); }

std::string page(const ImpactCase& impact, const Options& options, const Solution& solution,
                 const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots,
                 const std::vector<BlowResult>& blows) {
  if (!has_page()) throw std::runtime_error(no_page);
  std::string text{page_before_data};
  text += page_data(impact, options, solution, shown, snapshots, blows);
  text += page_after_data;
  return text;
}

}  // namespace dashpad::output
