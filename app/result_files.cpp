#include "result_files.hpp"

#include <fmt/format.h>

#include "dashpad/injury/figures.hpp"
#include "dashpad/output/impact.hpp"

namespace dashpad::app {

void add_result_files(CLI::App& app, OutputFiles& files) {
  add_file(app, files, "--json", "Write the summary as JSON (- for standard output)");
  add_file(app, files, "--csv",
           "Write the history (of the last blow, if there are several) as CSV (- for standard output)");
  add_documents(app, files);
  add_file(app, files, "--png", "Draw the acceleration and hysteresis curves (.png)");
  add_file(app, files, "--drawing",
           "Draw nose, pad and support to scale, at first contact and at greatest penetration (.svg, "
           ".png, .pdf)");
  add_units(app, files.units);
  add_all(app, files.detail);
}

void judge_result_files(const OutputFiles& files, const std::vector<input::InputFile>& inputs,
                        std::vector<std::string>& errors) {
  judge_files(files, inputs, errors);
  const std::string &drawing = files.of("--drawing"), &png = files.of("--png");
  if (!drawing.empty() && drawing != "-" && !output::picture_format(drawing))
    errors.push_back(fmt::format("--drawing {}: must end in .svg, .png or .pdf", drawing));
  if (!png.empty() && png != "-" && output::picture_format(png) != output::PictureFormat::png)
    errors.push_back(fmt::format("--png {}: must end in .png", png));
}

void publish(const OutputFiles& files, const SolvedCase& solved, std::string_view heading,
             std::string_view after) {
  const ImpactCase& impact = solved.impact;
  const Solution& solution = solved.solution;
  const UnitSystem& units = unit_system(files.units);
  const std::optional<injury::InjuryFigures> injury = injury::whole_pulse_figures(solution);
  const std::vector<output::BlowResult> blows = output::blow_results(solved.blows);
  const ImpactCase& last_blow = solved.blows.empty() ? impact : solved.blows.back().impact;
  output::ImpactReport report{impact, solved.options, solution, injury, blows};
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return output::result_json(impact, solution.summary, injury, blows);
    if (target.option == "--png")
      return output::picture(output::result_plot(impact, solution, injury, units),
                             output::PictureFormat::png);
    if (target.option == "--drawing")
      return output::impact_drawing(last_blow, solution, units,
                                    output::picture_format(target.file).value_or(output::PictureFormat::svg));
    if (target.option == "--csv") return output::history_csv(solution.history, units_of_files(units));
    report.snapshots = contact_snapshots(last_blow, solution.history);
    return target.option == "--markdown" ? output::to_markdown(output::impact_document(report, units))
                                         : output::impact_page(report, units);
  };
  std::string summary =
      std::string{heading} + output::to_terminal(output::impact_document(report, units), files.detail);
  publish(files.targets(), files.force, text_of, summary.append(after));
}

}  // namespace dashpad::app
