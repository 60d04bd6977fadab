#include "dashpad/spit1984/run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "spit1984/spit.hpp"

namespace dashpad::spit1984 {

const char* to_string(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::binary32: return "binary32";
    case Arithmetic::binary64: return "binary64";
    case Arithmetic::pdp10: break;
  }
  return "pdp10";
}

AbendText text_of(Abend abend) {
  switch (abend) {
    case Abend::too_many_iterations:
      return {
          "too many iterations",
          "within the impact the penetration converges too slowly: raise --equilibrium-tolerance, shorten "
          "--time-step or allow --most-iterations. Near the end of rebound the march is too sensitive to the "
          "strain rate: the last step but one is the last to rely on, and Eq. 27 estimates its speed error"};
    case Abend::bisection_failed:
      return {"bisection failed",
              "no pair of trials brackets equilibrium, which points to an unusual sensitivity to the strain "
              "rate: "
              "look at the law and its parameters again"};
    case Abend::too_many_time_steps:
      return {"too many time steps",
              "the time history is full before the impact is over: allow --most-steps"};
    case Abend::rate_sensitive_instability:
      return {
          "rate-sensitive instability",
          "the end of contact cannot be found. The results serve if the speed error is a small fraction; the "
          "coefficient of restitution is off by about twice it times impact over rebound speed. Otherwise "
          "halve --time-step"};
    case Abend::too_many_contact_divisions:
      return {"too many contact divisions",
              "the contact field is full before the largest penetration: allow --most-stations"};
    case Abend::none: break;
  }
  return {"", ""};
}

double longest_time_step_ms(const Deck& deck) {
  const auto tangents = SupportSecant<double>(deck, true).printed();
  const double stiffest = *std::max_element(tangents.begin(), tangents.end());
  return 1000 * 0.25 * std::sqrt(deck.weight_lb / 386.4 / stiffest);
}

Run run(const Deck& deck, const Settings& settings, const Progress& progress) {
  if (const auto broken = violations(deck); !broken.empty())
    throw std::invalid_argument(broken.front().key + ": " + broken.front().rule);
  if (settings.most_steps < 3 || settings.most_stations < 2)
    throw std::invalid_argument("dimensions: three time steps and two stations at least");
  switch (settings.arithmetic) {
    case Arithmetic::binary32: return Spit<float>(deck, settings).run(progress);
    case Arithmetic::binary64: return Spit<double>(deck, settings).run(progress);
    case Arithmetic::pdp10: break;
  }
  return Spit<Pdp10>(deck, settings).run(progress);
}

}  // namespace dashpad::spit1984
