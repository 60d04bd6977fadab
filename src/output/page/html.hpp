#pragma once
/// A page of figures as HTML that needs no script: what a mail preview, a printer or a reader who allows no
/// scripts sees of it.

#include <set>
#include <string>

#include "dashpad/output/page/figures_page.hpp"

namespace dashpad::output {

/// SVGs on their way into one page, which needs each of their styles once.
class InlineSvgs {
 public:
  /// The element alone.
  std::string add(std::string svg);
  /// The same of a plot, `width` px wide; a sentence if there is nothing to draw.
  std::string add(const Plot& plot, double width);
  /// A drawing with two pictures, and below it each half by itself: which of the two is shown is for the
  /// style of the page to say.
  std::string add_with_halves(std::string svg);
  /// The texts of all styles so far.
  [[nodiscard]] const std::set<std::string>& styles() const { return styles_; }

 private:
  std::set<std::string> styles_;
};

struct PageHtml {
  std::set<std::string> styles;  ///< those that its SVGs bring
  std::string title;             ///< what browsers show above the page
  std::string lead;              ///< the answer with its pictures and figures; may be empty
  std::string body;              ///< all below it
};
PageHtml html_of(const FiguresPage& page);

}  // namespace dashpad::output
