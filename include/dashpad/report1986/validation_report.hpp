#pragma once
/// The validation study as people and programs read it: text, JSON, figures, a page, tables for a document.
///
/// Units are the report's (lb, in, mph, ms, in.lb), since everything is compared with it.

#include <map>
#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/report1986/validation/study.hpp"

namespace dashpad::report1986 {

/// A figure of the report drawn again, or one of ours.
struct ValidationFigure {
  std::string name = {};  ///< "Figure 3-4"
  std::string slug = {};  ///< for a file's name: "figure-3-4"
  output::Plot plot = {};
  std::string note = {};  ///< what is left out, and what to beware of
};

/// Figures 3-3 to 3-9 and 4-1 to 4-5 of the report, then the nose radius and the ratio of the forces.
/// Readings whose test is lost are not drawn; the notes say how many there are.
std::vector<ValidationFigure> validation_figures(const Study& study);

/// The slugs of these figures, in their order, known before there is a study.
std::vector<std::string> validation_figure_slugs();

/// Everything: constants, claims, errors test by test, all predictions. Keys name the units.
std::string validation_json(const Study& study);

/// Which rules are met and by how much; the page has every table and figure.
output::Document validation_document(const Study& study,
                                     output::Pictures pictures = output::Pictures::left_out);

/// Tables in Markdown by name, as docs/validation.md holds them between "<!-- begin NAME -->" and
/// "<!-- end NAME -->".
std::map<std::string, std::string> validation_markdown_tables(const Study& study);

/// Whether the accurate solver passes the rules of each support and quantity (docs/decisions/0007).
bool passes(const Study& study);

}  // namespace dashpad::report1986
