#include "dashpad/output/page/figures_page.hpp"

#include <stdexcept>

#include "dashpad/output/page/page.hpp"
#include "output/page/figures_page_check.hpp"
#include "output/page/figures_page_data.hpp"
#include "output/page/html.hpp"
#include "output/page/page_template.hpp"

namespace dashpad::output {

std::string figures_page(const FiguresPage& page) {
  check(page);
  if (!has_page()) throw std::runtime_error(no_page);
  return filled(figures_page_parts, html_of(page), figures_page_data(page));
}

}  // namespace dashpad::output
