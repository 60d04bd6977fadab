// A material test as a page: where the foam is used best first, then why.

#include "dashpad/output/material_test.hpp"
#include "dashpad/output/page/figures_page.hpp"
#include "output/page/material_test_lead.hpp"
#include "output/plot/material_test.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

std::string material_test_page(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  const auto figure = [](Panel panel, std::string note = {}) {
    std::string title = panel.title;
    return CaptionedPlot{.plot = {.title = std::move(title), .panels = {std::move(panel)}},
                         .note = std::move(note)};
  };
  FiguresPage page;
  page.title = material_words(report.material);
  page.lead = material_test_lead(report, units);
  page.warnings = flag_words(report);
  page.sections = {
      {.heading = "Figures", .paragraphs = {}, .tables = tables_of(report, units), .figures = {}},
      {.heading = "What it rests on",
       .paragraphs = material_test_basis(report, units),
       .tables = {},
       .figures = {}},
      {.heading = "Stress",
       .paragraphs = {},
       .tables = {},
       .figures = {figure(stress_over_strain(report, units)), figure(stress_over_time(report, units)),
                   figure(strain_over_time(report, units))}},
      {.heading = "Cushioning",
       .paragraphs = {},
       .tables = {},
       .figures = {
           figure(energy_over_strain(report, units)),
           figure(efficiency_over_strain(report), "Efficiency is energy over the largest stress so far."),
           figure(ideality_over_strain(report), "Ideality is efficiency over the strain."),
           figure(efficiency_over_stress(report, units),
                  "The foam is used best at the stress where the efficiency is highest.")}}};
  return figures_page(page);
}

}  // namespace dashpad::output
