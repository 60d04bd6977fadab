#pragma once
/// Output of the validation study: text, JSON, figures, page and tables. Units of the report (lb, in).

#include <map>
#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/report1986/validation/study.hpp"

namespace dashpad::report1986 {

/// A figure of the report, drawn again, or an additional one.
struct ValidationFigure {
  std::string name = {};  ///< "Figure 3-4"
  std::string slug = {};  ///< for a file's name: "figure-3-4"
  output::Plot plot = {};
  std::string note = {};  ///< omissions and caveats
};

/// Figures 3-3 to 3-9 and 4-1 to 4-5 of the report, then the nose radius and the ratio of the forces.
/// Readings whose test is lost are not drawn; the notes give their number.
std::vector<ValidationFigure> validation_figures(const Study& study);

/// The slugs of these figures, in their order. They do not depend on a study.
std::vector<std::string> validation_figure_slugs();

/// The whole study: constants, claims, errors by test, all predictions. Keys name the units.
std::string validation_json(const Study& study);

/// The rules with their outcomes; with all tables and figures on the page.
output::Document validation_document(const Study& study,
                                     output::Pictures pictures = output::Pictures::left_out);

/// The Markdown tables of docs/validation.md by NAME, as in "<!-- begin NAME -->" and "<!-- end NAME -->".
std::map<std::string, std::string> validation_markdown_tables(const Study& study);

/// Whether the accurate solver passes the rules of each support and quantity (docs/decisions/0007).
bool passes(const Study& study);

}  // namespace dashpad::report1986
