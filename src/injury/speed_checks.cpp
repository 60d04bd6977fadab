// What a velocity change, a speed or a drop height, and a fall in the record say of each other.

#include <cmath>

#include <fmt/format.h>

#include "dashpad/injury/pulse_report.hpp"
#include "injury/pulse_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::injury {

namespace {

constexpr double unlike = 0.01;         // of the speed or the height
constexpr double samples_in_doubt = 4;  // at the beginning and at the end of a fall

std::string shown(double speed) { return brief(speed, 4) + " m/s"; }

/// A factor next to 1 as its difference from it.
std::string other_scale(double factor) {
  constexpr double near = 0.1;
  const double change = std::abs(factor - 1);
  if (change < near) return in_percent(change) + (factor > 1 ? " greater" : " smaller");
  return brief(factor, 3) + " times this one";
}

/// What would make up for a change that is off.
std::string way_out(const SpeedCheck& check, const Contact& contact, const char* stated) {
  const bool is_short = check.shortfall > 0;
  std::string text = fmt::format(
      "There is no restitution between 0 and 1. For a velocity change that agrees with the {}", stated);
  if (check.least_scale && check.greatest_scale)
    text += fmt::format(
        " the scale (unit, sensitivity) would have to be {}, or the sensor to show {:.2g} g "
        "too {} over contact",
        other_scale(is_short ? *check.least_scale : *check.greatest_scale),
        std::abs(check.shortfall) / (contact.end - contact.begin) / standard_gravity,
        is_short ? "little" : "much");
  else
    text += " there would have to be an acceleration";
  return text + (is_short ? ", or samples to be missing." : ".");
}

}  // namespace

std::optional<SpeedCheck> speed_check(const PulseReport& report) {
  if (!report.impact) return std::nullopt;
  const double speed = report.impact->speed, sensed = report.contact.velocity_change;
  SpeedCheck check{.change = change_of_motion(report.contact, *report.impact)};
  const double given = sensed - check.change;  // by gravity
  if (check.change < (1 - rounding_of_velocity) * speed) check.shortfall = speed - check.change;
  if (check.change > (1 + rounding_of_velocity) * 2 * speed) check.shortfall = 2 * speed - check.change;
  if (sensed > 0) {
    check.least_scale = (speed + given) / sensed;
    check.greatest_scale = (2 * speed + given) / sensed;
  }
  const char* stated = report.impact->drop_height ? "drop height" : "speed";
  check.text =
      check.agrees()
          ? fmt::format(
                "Velocity change and {} agree: {} lies between {} (a body that stays) and twice that. "
                "So it would if all accelerations were {} to {} times these: a smaller error of the "
                "scale does not show here.",
                stated, shown(check.change), shown(speed), brief(*check.least_scale, 3),
                brief(*check.greatest_scale, 3))
          : way_out(check, report.contact, stated);
  return check;
}

std::optional<Flag> unlike_speeds(const MeasuredImpact& measured, const MeasuredImpact& computed) {
  const double share = computed.speed / measured.speed - 1;
  if (!(std::abs(share) > unlike)) return std::nullopt;
  return Flag{
      "UNLIKE SPEEDS",
      fmt::format("UNLIKE SPEEDS: the case strikes at {}, {} {} than the measured impact at {}{}: the "
                  "differences are those of two impacts",
                  shown(computed.speed), in_percent(std::abs(share)), share < 0 ? "slower" : "faster",
                  shown(measured.speed),
                  measured.drop_height ? fmt::format(" (from {} m)", brief(*measured.drop_height, 4)) : ""),
      {{"speed_m_per_s", computed.speed}, {"measured_speed_m_per_s", measured.speed}}};
}

std::optional<Flag> height_in_doubt(const PulseReport& report) {
  if (!report.impact || !report.impact->drop_height || !report.offset || !report.offset->offset.rest)
    return std::nullopt;
  const double fall = report.contact.begin - report.offset->offset.begin;
  const double height = standard_gravity * fall * fall / 2, said = *report.impact->drop_height;
  const std::vector<double>& time = report.measured.pulse.time;
  const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  if (std::abs(height / said - 1) <= unlike + 2 * samples_in_doubt * interval / fall) return std::nullopt;
  return Flag{
      "DROP HEIGHT IN DOUBT",
      fmt::format("DROP HEIGHT IN DOUBT: the fall in the record takes {} ms, as from {} m; {} m was said",
                  brief(1e3 * fall, 4), brief(height, 3), brief(said, 4)),
      {{"fall_s", fall}, {"height_m", height}, {"stated_height_m", said}}};
}

}  // namespace dashpad::injury
