#include "input/measurement/pulse_bounds.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {

void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults) {
  if (pulse.time.size() < 2) return;
  const Magnitudes times = measured_magnitudes("s"), accelerations = measured_magnitudes("m/s2");
  const double begin = pulse.time.front(), end = pulse.time.back();
  const double latest = std::max(std::abs(begin), std::abs(end));
  const double step = (end - begin) / static_cast<double>(pulse.time.size() - 1);
  if (!(latest <= times.most))
    faults.add(
        line, "time", "",
        fmt::format("goes to {:.3g} s; must be within {:g} s: is the unit right?", latest, times.most));
  else if (step > 0 && step < times.least)
    faults.add(
        line, "time", "",
        fmt::format("samples are {:.3g} s apart; must be {:g} s or more, as no sensor is read more often: "
                    "is the unit right?",
                    step, times.least));
  double peak = 0;
  for (const double value : pulse.acceleration) peak = std::max(peak, std::abs(value));
  if (!accelerations.admit(peak))
    faults.add(
        line, "acceleration", "",
        fmt::format("its largest magnitude is {:.3g} m/s2; must be between {:g} and {:g} m/s2, as beyond "
                    "there is no impact: is the unit right?",
                    peak, accelerations.least, accelerations.most));
}

}  // namespace dashpad::input
