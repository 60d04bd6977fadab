// dashpad assess: solves a case with the impactor of a test standard and applies its limits.

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/assessment.hpp"
#include "live/live_page.hpp"
#include "live_files.hpp"
#include "output_files.hpp"

namespace dashpad::app {

namespace {

constexpr const char* assess_footer = R"(Examples:
  dashpad assess examples/dashboard-20mph.toml --standard fmvss-201-instrument-panel
  dashpad assess examples/dashboard-20mph.toml --standard fmvss-201-instrument-panel:air-bag --units us
  dashpad assess examples/dashboard-20mph.toml --standard en-1177 --drop-height "1.5 m"
  dashpad assess examples/head-on-door-panel.toml --standard fmvss-201-instrument-panel --report ./my-verdict.html
  dashpad assess examples/dashboard-20mph.toml --standard fmvss-218:hemispherical:small --json -
  dashpad assess examples/helmet-pad-10fps.toml --standard en-1078 --standard cpsc-1203
  dashpad assess examples/helmet*.toml --standard en-1078 --standard cpsc-1203 --report ./my-plan.html
  dashpad assess examples/helmet-struck-by-a-ram.toml --standard fmvss-201u --keep-nose --keep-speed

The impactor (mass, radius, speed) is that of the standard unless you give other values; the pad, the support
and the solver settings are those of the case. Replaced values are listed. Values that a standard does not
specify are taken from the case. --keep-nose and --keep-speed keep the nose and the speed of the case. If the
other choice of nose or speed would change the verdict to a pass or a fail, the reservation OTHER NOSE or OTHER
SPEED says so. Several variants may follow the name, each preceded by a colon; dashpad standards lists them.
Several cases or several standards make a test plan: one row per case, with the worst case first, and one column
per standard. --all and --report add each assessment in full; --json writes an array of assessments. --set applies to every case.

Every figure has a 95 % interval for the uncertainty of the foam and the model; see docs/theory.md, section 6.2.
Verdicts: pass if every interval lies within its limit, fail if any interval lies entirely above its limit,
undecided if a limit lies within an interval. A pad that bottomed out on a rigid support fails. A pulse that ends
before contact is lost (PULSE CUT: the foam does not unload on a rigid support, or the time limit was reached)
gives only lower bounds, which fail above a limit and are undecided below it. If the impactor comes to rest on the
pad, only the peak is assessed in full. A pass is "with reservations" if the result has a flag (EXTRAPOLATED
STRAIN, BOTTOMED, PULSE CUT, ...), if a source of uncertainty has NO INTERVAL, if the material has an UNKNOWN
RANGE, if a value in the standard is UNVERIFIED or from a SECONDARY SOURCE, or if you REPLACED one. An assessment
is a computation with one rigid nose on a flat pad; it is neither a test to the standard nor a certification.

Exit codes: 0 pass, with or without reservations; 4 fail, even if the tolerance is not met; 3 no verdict
(undecided), or not reliable (the result does not meet the tolerance); 1 a result could not be written; 2 invalid
input or command line (nothing was run). For a test plan: 4 if any combination fails, otherwise 3 if any is
undecided or not reliable.)";

struct AssessRequest {
  std::vector<std::string> cases;
  std::vector<std::string> settings;
  std::vector<std::string> standards;
  std::optional<std::string> mass, radius, speed, drop_height;
  injury::Kept kept;
  OutputFiles files;
  std::optional<std::string> tolerance;
  std::string standard_folder;
  std::string materials;
  bool no_intervals = false;
};

/// A standard, and the case with its impactor.
struct Assessed {
  injury::Standard own;       ///< with its own nose and speed
  injury::Standard standard;  ///< with those of the case, if they are kept
  ImpactCase impact;
  Solution solution = {};
  injury::Assessment assessment = {};
  std::vector<injury::OtherChoice> others = {};
};

struct AssessedCase {
  std::string file;
  input::CaseFile given;
  std::vector<Assessed> standards;
};

using Complaints = std::vector<std::string>;

injury::UserValues read_user_values(const AssessRequest& request, Complaints& errors) {
  if (request.speed && request.drop_height)
    errors.emplace_back("--drop-height: give either --speed or --drop-height, not both");
  if (request.kept.nose && request.radius)
    errors.emplace_back("--keep-nose: give either --keep-nose or --radius, not both");
  if (request.kept.speed && (request.speed || request.drop_height))
    errors.push_back(fmt::format("--keep-speed: give either --keep-speed or {}, not both",
                                 request.speed ? "--speed" : "--drop-height"));
  return {.mass = positive_quantity_of("--mass", request.mass, "kg", errors),
          .radius = positive_quantity_of("--radius", request.radius, "m", errors),
          .speed = positive_quantity_of("--speed", request.speed, "m/s", errors),
          .drop_height = positive_quantity_of("--drop-height", request.drop_height, "m", errors)};
}

/// The standards with the values of the user.
std::vector<injury::Standard> read_standards(const AssessRequest& request,
                                             std::vector<input::InputFile>& files, Complaints& errors) {
  const std::filesystem::path folder = chosen_standards(request.standard_folder);
  const injury::UserValues values = read_user_values(request, errors);
  std::vector<injury::Standard> standards;
  for (const std::string& name : request.standards)
    if (const auto standard = standard_of(name, folder, files, errors))
      standards.push_back(injury::with_user_values(*standard, values));
  return standards;
}

/// --live shows one assessment whose choices its controls have.
void check_live(const AssessRequest& request, Complaints& errors) {
  if (request.files.of("--live").empty()) return;
  read_engine(errors);
  if (request.cases.size() > 1 || request.standards.size() > 1)
    errors.emplace_back("--live: shows one case and one standard");
  if (request.kept.nose || request.kept.speed)
    errors.emplace_back("--live: not together with --keep-nose and --keep-speed; its sliders set the speed");
  if (!request.standard_folder.empty()) errors.emplace_back("--live: has the standards of the program only");
  for (const std::string& name : request.standards) check_live_standard("--standard", name, errors);
}

std::string live_page_of(const AssessRequest& request, const Assessed& assessed,
                         const input::CaseFile& given) {
  Complaints none;  // it was there when everything was checked
  const std::string engine = read_engine(none);
  live::LivePage page{
      .case_text = live_case_text({request.cases.front(), request.settings, request.materials}, given),
      .standard = request.standards.front(),
      .units = unit_system(request.files.units).name,
      .engine = engine};
  const injury::Standard& standard = assessed.standard;
  for (const auto& [name, value] :
       {std::pair{"mass", &standard.mass}, {"radius", &standard.radius}, {"speed", &standard.speed}})
    if (value->chosen_by_user && value->value) page.user[name] = *value->value;
  return live::live_page(page, {chosen_folder(""), chosen_standards("")});
}

std::vector<AssessedCase> read_and_check(const AssessRequest& request) {
  Complaints errors;
  const std::optional<double> tolerance = tolerance_of(request.tolerance, errors);
  std::vector<input::InputFile> files;
  const std::vector<injury::Standard> standards = read_standards(request, files, errors);
  std::vector<AssessedCase> cases;
  check_live(request, errors);
  for (const std::string& file : request.cases) {
    std::optional<input::CaseFile> given = read_case({file, request.settings, request.materials}, errors);
    std::ranges::move(files_of(file, given), std::back_inserter(files));
    if (given) cases.push_back({.file = file, .given = *std::move(given), .standards = {}});
  }
  judge_files(request.files, files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));

  for (AssessedCase& each : cases) {
    if (tolerance) each.given.options.tolerance = *tolerance;
    for (const injury::Standard& own : standards) {
      Assessed of{.own = own,
                  .standard = injury::with_kept(own, each.given.impact.impactor, request.kept),
                  .impact = {}};
      of.impact = injury::with_impactor_of(of.standard, each.given.impact);
      for (const Violation& violation : violations(of.impact))
        errors.push_back(fmt::format("{}, with the impactor of {}: {} = {}: {}", each.file, of.standard.name,
                                     violation.key, violation.value, violation.rule));
      each.standards.push_back(std::move(of));
    }
  }
  if (!errors.empty()) throw Refused(std::move(errors));
  return cases;
}

/// Finds the verdict, and what another choice of nose or speed would have changed.
void judge(Assessed& assessed, const input::CaseFile& given, const AssessRequest& request) {
  const auto solved = [&](const injury::Standard& standard, const ImpactCase& impact,
                          const Options& options) {
    Solution solution = solve_with_progress(impact, options);
    if (!request.no_intervals)
      add_intervals_with_progress(impact, options, solution, injury::dwell_levels(standard));
    return solution;
  };
  assessed.solution = solved(assessed.standard, assessed.impact, given.options);
  assessed.assessment = injury::assess(assessed.standard, assessed.impact, assessed.solution);
  Options coarse = given.options;
  coarse.tolerance = 1e-3;
  assessed.others =
      injury::turning_choices(assessed.own, given.impact, request.kept, assessed.assessment.verdict,
                              [&](const injury::Standard& standard, const ImpactCase& impact) {
                                return injury::assess(standard, impact, solved(standard, impact, coarse));
                              });
  for (const injury::OtherChoice& choice : assessed.others)
    assessed.assessment.reservations.push_back(
        output::other_choice(choice, assessed.own, given.impact, unit_system(request.files.units)));
}

int run_assessment(const AssessRequest& request) {
  std::vector<AssessedCase> cases = read_and_check(request);
  const UnitSystem& units = unit_system(request.files.units);
  int code = exit_done;
  std::vector<output::AssessmentReport> reports;
  for (AssessedCase& each : cases)
    for (Assessed& assessed : each.standards) {
      judge(assessed, each.given, request);
      code = std::max<int>(code, exit_code(assessed.assessment.verdict, assessed.solution.summary));
      reports.push_back({assessed.standard, each.given.impact, assessed.impact, assessed.solution,
                         assessed.assessment, assessed.others, each.file});
    }
  const bool is_plan = reports.size() > 1;
  const auto document = [&](output::Pictures pictures) {
    return is_plan ? output::test_plan_document(reports, units, pictures)
                   : output::assessment_document(reports.front(), units, pictures);
  };
  const output::Detail detail = request.files.detail;
  std::string text = output::to_terminal(document(output::Pictures::left_out), detail);
  if (is_plan && detail == output::Detail::all)
    for (const output::AssessmentReport& report : reports)
      text += "\n\n" + output::to_terminal(output::assessment_document(report, units), detail);
  const auto json = [&](const Target&) {
    return is_plan ? output::assessments_json(reports) : output::assessment_json(reports.front());
  };
  const auto live = [&](const Target&) {
    return live_page_of(request, cases.front().standards.front(), cases.front().given);
  };
  publish(request.files, document, {{"--json", json}, {"--live", live}}, text);
  return code;
}

}  // namespace

void add_assess(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<AssessRequest>(
      app, action, "assess", "Compare a case with the limits of a test standard", assess_footer,
      run_assessment);
  add_option(sub, "CASE", request.cases, "Case files (TOML)")->required();
  add_settings(sub, request.settings);
  add_option(sub, "--standard NAME[:VARIANT]", request.standards,
             "Standard, with any variants (see dashpad standards); may be repeated")
      ->required()
      ->take_all();
  add_option(sub, "--speed V", request.speed, "Impact speed, such as \"15 mph\"");
  add_option(sub, "--drop-height H", request.drop_height, "Free-fall height, instead of the speed");
  add_option(sub, "--mass M", request.mass, "Mass of the impactor, such as \"6.8 kg\"");
  add_option(sub, "--radius R", request.radius, "Radius of the sphere, such as \"82.5 mm\"");
  add_flag(sub, "--keep-nose", request.kept.nose, "Use the nose of the case, not that of the standard");
  add_flag(sub, "--keep-speed", request.kept.speed, "Use the speed of the case, not that of the standard");
  add_file(sub, request.files, "--json",
           "Write the assessment as JSON, in SI units and g (- for standard output)");
  add_documents(sub, request.files);
  add_file(sub, request.files, "--live",
           "Write the page as one that solves while its numbers are dragged (dashpad explore)");
  add_units(sub, request.files.units);
  add_all(sub, request.files.detail);
  add_tolerance(sub, request.tolerance);
  add_no_intervals(sub, request.no_intervals);
  add_force(sub, request.files.force);
  add_standard_folder(sub, request.standard_folder);
  add_material_folder(sub, request.materials);
}

}  // namespace dashpad::app
