// The program of 1984.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "contenders.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/spit1984/run.hpp"

namespace dashpad::bench {
namespace {

constexpr double inch = 0.0254, pound = 4.4482216152605;

/// The cases have the constants of 1984 in their SI values already: undone, the deck of c1 says 20 mph.
spit1984::Deck deck_of(ImpactCase impact, double time_step_ms) {
  impact.impactor.speed *= 17.6 / 17.64;
  impact.impactor.mass *= 386.4 * inch / standard_gravity;
  spit1984::Deck deck = spit1984::deck_of(impact);
  deck.time_step_ms = time_step_ms;
  return deck;
}

std::optional<Outcome> outcome_of(const spit1984::Run& run) {
  if (run.abend != spit1984::Abend::none) return std::nullopt;
  double deepest = 0;
  for (const spit1984::Step& step : run.history) deepest = std::max(deepest, step.penetration_in);
  return Outcome{-run.peak_force_lb * pound, deepest * inch,
                 std::abs(run.history.back().speed_in_per_s) * inch};
}

}  // namespace

std::vector<Contender> spit1984_contenders(const ImpactCase& impact) {
  struct Version {
    const char* name;
    spit1984::Defects defects;
  };
  // With all mended, law 5 ends in an ABEND.
  const bool law_5 = std::holds_alternative<TwentyOneParameter>(impact.pad.material.law);
  const spit1984::Defects mended = law_5 ? spit1984::Defects{.edge_residue = false} : spit1984::all_mended;
  std::vector<Contender> contenders;
  for (const Version& version : {Version{"1984 as printed", {}}, {"1984 mended", mended}})
    for (const double step_ms : {0.4, 0.2, 0.1, 0.05, 0.025}) {
      spit1984::Settings settings;
      settings.arithmetic = spit1984::Arithmetic::binary32;
      settings.defects = version.defects;
      settings.max_steps = settings.max_stations = 4000;  // the listing's 1000 end a run at small steps
      contenders.push_back({version.name, fmt::format("step {} ms", step_ms),
                            [=](double share) {
                              return outcome_of(
                                  spit1984::run(deck_of(at_speed(impact, share), step_ms), settings));
                            },
                            true});
    }
  return contenders;
}

}  // namespace dashpad::bench
