#include "dashpad/output/page/figures_page.hpp"

#include "output/page/html.hpp"

namespace dashpad::output {

std::string figures_page(const FiguresPage& page) { return framed(html_of({{nullptr, page}})); }

}  // namespace dashpad::output
