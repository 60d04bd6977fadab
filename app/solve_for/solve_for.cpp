// dashpad solve-for: where the verdict about a case turns as one of its numbers varies.

#include "command.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/output/margin.hpp"
#include "output_files.hpp"
#include "solve_for/question.hpp"

namespace dashpad::app {

namespace {

constexpr const char* solve_for_footer = R"(Examples:
  dashpad solve-for pad.thickness examples/dashboard-20mph.toml --standard fmvss-201-instrument-panel
  dashpad solve-for impactor.speed examples/dashboard-20mph.toml --until "hic15 = 700"
  dashpad solve-for pad.scale examples/dashboard-20mph.toml --until "peak_acceleration <= 80 g" --between 0.2..5
  dashpad solve-for pad.thickness examples/dashboard-20mph.toml --until "hic_d <= 1000" \
    --probability "95 %" --vary pad.scale="5 %" --vary impactor.speed="14.5 mph..15.5 mph"
  dashpad solve-for pad.thickness examples/disc-on-mat.toml --until "hic15 <= 150" --vary foam --draws 256
  dashpad solve-for pad.thickness examples/dashboard-20mph.toml --until "hic15 <= 700" --report ./how-thick.html

KEY is a number of the case as studies name it: pad.thickness, impactor.speed, impactor.drop_height, pad.scale,
pad.temperature, support.stiffness, ... The limits are those of a standard, with its impactor, or your own: any
response of studies, as "hic15 <= 700", "rebound_speed >= 1 m/s", or "hic15 = 700" to ask where it has that value. With
several limits, all must be kept.

The whole range is searched and all solutions are reported, since a figure may fall and rise again: a pad that is too
soft bottoms out, one that is too stiff stops the impactor too hard. Without --between, the range is a quarter of the
value in the case to four times that value.

Without --vary, the interval of a solution is the range in which it may lie given the uncertainty of foam and model; see
docs/theory.md, section 6.2. With --vary, the answer is the value at which the given share of the draws keeps all limits,
and its interval is due to the number of draws. --vary KEY="5 %" draws from a normal distribution with that standard
deviation about the value of the case, "A..B" evenly from A to B, "M +- S" from a normal distribution; --vary foam
draws all that the card of the foam leaves uncertain, and --vary STUDY.toml what a study draws.

Exit codes: 0 some value passes, or the aim is reached; 4 no value of the range passes, or the aim is not reached; 3 no
value passes with its interval, but some may, or the search is incomplete or not reliable; 1 a result could not be written;
2 invalid input or command line (nothing was run).)";

int run_solve_for(const SolveForRequest& request) {
  const margin::Answer answer = solve_for_with_progress(question_of(request));
  const UnitSystem& units = unit_system(request.files.units);
  const auto document = [&](output::Pictures pictures) {
    return output::margin_document(answer, request.given.file, units, pictures);
  };
  publish(request.files, document,
          {{"--json", [&](const Target&) { return output::margin_json(answer); }},
           {"--csv", [&](const Target&) { return output::margin_csv(answer); }},
           {"--picture",
            [&](const Target& target) { return picture_text(output::margin_plot(answer, units), target); }}});
  return exit_code(answer);
}

}  // namespace

void add_solve_for(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<SolveForRequest>(
      app, action, "solve-for",
      "Find the value at which a verdict changes, such as the least thickness that passes", solve_for_footer,
      run_solve_for);
  add_option(sub, "KEY", request.key, "Number of the case, such as pad.thickness")->required();
  add_case(sub, request.given);
  add_option(sub, "--standard NAME[:VARIANT]", request.standards,
             "Keep the limits of a standard, with its impactor; may be repeated")
      ->take_all();
  add_option(sub, "--until LIMIT", request.until, "Keep a limit, such as \"hic15 <= 700\"; may be repeated")
      ->take_all();
  add_option(sub, "--between RANGE", request.between, "Range to search, such as \"10 mm..60 mm\"");
  add_option(sub, "--vary KEY=SCATTER", request.vary,
             "Draw a number, such as pad.scale=\"5 %\", foam, or what a study draws; may be repeated")
      ->take_all();
  add_option(sub, "--probability P", request.probability,
             "Share of the draws that must keep all limits (default: 95 %)");
  add_option(sub, "--draws N", request.draws, "Number of draws (default: 1024)")
      ->check(CLI::Range(64, 1000000));
  add_option(sub, "--seed N", request.seed, "Seed of the draws (default: 1)");
  add_file(sub, request.files, "--json",
           "Write the answer as JSON, in SI units and g (- for standard output)");
  add_file(sub, request.files, "--csv", "Write a row for each value that was evaluated");
  add_file(sub, request.files, "--picture", "Draw the figures over the range: .svg, .png or .pdf");
  add_documents(sub, request.files);
  add_units(sub, request.files.units);
  add_all(sub, request.files.detail);
  add_tolerance(sub, request.tolerance);
  add_no_intervals(sub, request.no_intervals);
  add_force(sub, request.files.force);
  add_standard_folder(sub, request.standard_folder);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
