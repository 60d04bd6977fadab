// dashpad post-impact: the motion of two bodies after the impact, and the energy.

#include <limits>
#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/impact.hpp"
#include "output_files.hpp"

namespace dashpad::app {

namespace {

constexpr const char* post_impact_footer = R"(Examples:
  dashpad post-impact examples/dashboard-20mph.toml
  dashpad post-impact examples/dashboard-20mph.toml --other-mass "1500 kg" --units us
  dashpad post-impact examples/dashboard-20mph.toml --other-mass "3000 lb" --other-velocity "-10 mph" --json -

Computes the velocities after the impact from Eqs. 1 to 4 of the 1986 report, as input to a simulation of the motion
that follows. The mass and velocity of the impactor are those of the case; the other body carries the support of the
pad and is held in place unless --other-mass is given. All velocities are positive in the impactor's direction, so the
other body moves away if its velocity is positive. The energy absorbed by the pad is computed for the relative motion.

Exit codes: 0 success, 1 a result could not be written, 2 invalid input (nothing was run), 3 the results do not
meet the tolerance, or there is no rebound.)";

struct PostImpactRequest {
  GivenCase given;
  std::optional<std::string> other_mass, other_velocity;
  OutputFiles files;
};

struct PostImpactInput {
  input::CaseFile file;
  Body first, second;
};

PostImpactInput read_and_check(const PostImpactRequest& request) {
  std::vector<std::string> errors;
  PostImpactInput input;
  constexpr double held = std::numeric_limits<double>::infinity();
  input.second.mass = positive_quantity_of("--other-mass", request.other_mass, "kg", errors).value_or(held);
  input.second.velocity = quantity_of("--other-velocity", request.other_velocity, "m/s", errors).value_or(0);
  std::optional<input::CaseFile> file = read_case(request.given, errors);
  judge_files(request.files, files_of(request.given.file, file), errors);
  if (file) {
    input.file = *std::move(file);
    if (input.file.impact.blows)
      errors.push_back(request.given.file + ": blows: the two bodies collide only once; remove this table");
    if (input.file.impact.backing != Backing{} || input.file.impact.impactor.gravity != 0)
      errors.push_back(
          request.given.file +
          ": post-impact allows no gravity and no property of the support except its force curve; to obtain "
          "the velocities of both bodies, use dashpad run with the other body as support.body_mass");
    const Impactor& impactor = input.file.impact.impactor;
    input.first = {impactor.mass, impactor.speed};
    if (!(impactor.speed > input.second.velocity))
      errors.push_back(fmt::format(
          "--other-velocity {}: the bodies must approach each other; the impactor moves at {} m/s",
          *request.other_velocity, impactor.speed));
  }
  if (errors.empty()) {
    input.file.impact = relative_motion(input.file.impact, input.first, input.second);
    for (const Violation& violation : violations(input.file.impact))
      errors.push_back(fmt::format("the relative motion of the two bodies: {} = {}: {}", violation.key,
                                   violation.value, violation.rule));
  }
  if (!errors.empty()) throw Refused(std::move(errors));
  return input;
}

int run(const PostImpactRequest& request) {
  const PostImpactInput input = read_and_check(request);
  const ImpactCase& impact = input.file.impact;
  const Solution solution = solve_with_progress(impact, input.file.options);
  if (!solution.summary.release) {
    write_error("dashpad: no rebound (" + to_string(solution.summary.status) +
                "); dashpad run shows what happened\n");
    return exit_not_trusted;
  }
  const auto document = [&](output::Pictures) {
    return output::post_impact_document(input.first, input.second, impact, solution,
                                        unit_system(request.files.units));
  };
  const auto json = [&](const Target&) {
    return output::post_impact_json(input.first, input.second, impact, solution);
  };
  publish(request.files, document, {{"--json", json}});
  return solution.summary.trustworthy() ? exit_done : exit_not_trusted;
}

}  // namespace

void add_post_impact(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<PostImpactRequest>(
      app, action, "post-impact", "Velocities of two bodies after an impact, and the energy absorbed",
      post_impact_footer, run);
  add_case(sub, request.given);
  add_option(sub, "--other-mass MASS", request.other_mass, "Mass of the other body (default: held in place)");
  add_option(sub, "--other-velocity SPEED", request.other_velocity,
             "Velocity of the other body before the impact (default: 0)");
  add_file(sub, request.files, "--json", "Write the result as JSON, in SI units (- for standard output)");
  add_documents(sub, request.files);
  add_units(sub, request.files.units);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
