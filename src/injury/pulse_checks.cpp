// Checks of a measured pulse: whether it is whole, zeroed, and consistent with its impact.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/injury/standard.hpp"
#include "injury/pulse_line.hpp"
#include "quantities/text.hpp"

namespace dashpad::injury {

namespace {

constexpr double lowest_cut = 0.01;         // of the peak
constexpr double cut_in_noise = 4;          // of the scatter
constexpr double max_quiet_scatter = 0.02;  // of the peak, of a part that is quiet
constexpr double worth_a_remark = 1e-3;     // of HIC15
constexpr double surely = 3;                // standard errors: a larger mean is not 0
constexpr double rounding_of_zero = 1e-9;   // of the peak
constexpr double unlike = 0.01;             // of a speed or a height
constexpr double samples_in_doubt = 4;      // at the beginning and at the end of a fall

/// Root mean square of the samples in the quiet interval, m/s2; 0 if there is none.
double scatter(const PulseReport& report, const Pulse& pulse, double peak) {
  if (!report.offset) return 0;
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < pulse.time.size() && pulse.time[i] <= report.offset->offset.end; ++i)
    if (pulse.time[i] >= report.offset->offset.begin) {
      squares += pulse.acceleration[i] * pulse.acceleration[i];
      ++count;
    }
  const double found = count > 0 ? std::sqrt(squares / count) : 0;
  return found <= max_quiet_scatter * peak ? found : 0;
}

Flag cut(const std::string& where, double acceleration, double peak, const std::string& missing) {
  const double left = std::abs(acceleration), share = left / peak;
  return flag_of("PULSE CUT",
                 fmt::format("the pulse {} at {} g, {} of its peak: either {} or the sensor has an offset; "
                             "the HIC, clips and velocity change of an incomplete pulse are lower bounds",
                             where, brief(left / standard_gravity), in_percent(share), missing),
                 {{"acceleration_m_per_s2", left}, {"peak_fraction", share}});
}

std::string shown(double speed) { return brief(speed, 4) + " m/s"; }

/// " (after subtracting 0.335 m/s due to gravity)": what the sensor shows without a change of motion.
std::string less_gravity(const PulseReport& report, const SpeedCheck& check) {
  const double given = report.contact.velocity_change - check.change;
  return given > 0 ? " (after subtracting " + brief(given, 3) + " m/s due to gravity)" : "";
}

/// "2 % greater" for a factor near 1, else "1.3 times the present one".
std::string other_scale(double factor) {
  constexpr double near = 0.1;
  const double change = std::abs(factor - 1);
  if (change < near) return in_percent(change) + (factor > 1 ? " greater" : " smaller");
  return brief(factor, 3) + " times the present one";
}

/// Possible causes of an impossible velocity change.
std::string way_out(const SpeedCheck& check, const Contact& contact, const char* stated) {
  const bool is_short = check.shortfall > 0;
  std::string text = fmt::format(
      "No restitution from 0 to 1 fits this pulse. For its velocity change to agree with the {},", stated);
  if (check.min_scale && check.greatest_scale)
    text += fmt::format(
        " the scale (unit, sensitivity) would have to be {}, or the sensor would have to read {:.2g} g too "
        "{} during contact",
        other_scale(is_short ? *check.min_scale : *check.greatest_scale),
        std::abs(check.shortfall) / (contact.end - contact.begin) / standard_gravity,
        is_short ? "low" : "high");
  else
    text += " the pulse would have to show an acceleration";
  return text + (is_short ? ", or samples would have to be missing." : ".");
}

}  // namespace

MeasuredImpact after_fall(double drop_height) {
  return {.speed = speed_after_fall(drop_height), .drop_height = drop_height, .gravity = standard_gravity};
}

double change_of_motion(const Contact& contact, const MeasuredImpact& impact) {
  return contact.velocity_change - impact.gravity * (contact.end - contact.begin);
}

std::optional<double> restitution(const Contact& contact, const MeasuredImpact& impact) {
  const double value = change_of_motion(contact, impact) / impact.speed - 1;
  const bool is_possible = value >= -rounding_of_velocity && value <= 1 + 2 * rounding_of_velocity;
  return is_possible ? std::optional{value} : std::nullopt;
}

std::vector<Flag> flags(const PulseReport& report, const Pulse& pulse) {
  std::vector<Flag> all;
  const double peak = injury::peak(pulse).magnitude;
  const double limit = std::max(lowest_cut * peak, cut_in_noise * scatter(report, pulse, peak));
  const bool begins_quietly =
      report.offset && (!report.offset->given || report.offset->offset.end <= report.contact.begin);
  if (!begins_quietly && std::abs(pulse.acceleration.front()) > limit)
    all.push_back(cut("starts", pulse.acceleration.front(), peak, "its beginning is missing"));
  if (std::abs(pulse.acceleration.back()) > limit)
    all.push_back(cut("ends", pulse.acceleration.back(), peak, "its end is missing"));
  const std::optional<SpeedCheck> check = speed_check(report);
  if (check && !check->agrees()) {
    const bool is_short = check->shortfall > 0;
    all.push_back(
        flag_of("IMPOSSIBLE VELOCITY CHANGE",
                fmt::format("{} m/s{} is {} the impact speed of {} m/s; most likely, {}",
                            brief(std::max(check->change, 0.0)), less_gravity(report, *check),
                            is_short ? "less than" : "more than twice", brief(report.impact->speed),
                            is_short ? "the pulse is cut, the unit or the sensitivity is wrong, or the "
                                       "sensor has an offset"
                                     : "the sensor has an offset, the unit or the sensitivity is wrong, "
                                       "or there is more than one impact in the pulse"),
                {{"velocity_change_m_per_s", check->change}, {"speed_m_per_s", report.impact->speed}}));
  }
  if (std::optional<Flag> flag = height_in_doubt(report)) all.push_back(*std::move(flag));
  return all;
}

std::string each_in_g(const std::vector<double>& accelerations, double peak) {
  std::string text;
  for (const double value : accelerations)
    text += fmt::format("{}{:.3g}", text.empty() ? "" : ", ",
                        std::abs(value) < rounding_of_zero * peak ? 0 : value / standard_gravity);
  return text + " g";
}

std::string in_percent(double fraction) {
  return fraction < 0.99 ? percentage(fraction) : fmt::format("{:.0f} %", 100 * fraction);
}

std::string change_of_hic15(const OffsetEffect& effect) {
  if (!(effect.hic15_without > 0))
    return fmt::format("HIC15 is {} with the offset and 0 without", brief(effect.hic15_with));
  const double change = effect.hic15_with / effect.hic15_without - 1;
  return fmt::format("HIC15 is {} {} with the offset than without", in_percent(std::abs(change)),
                     change < 0 ? "lower" : "higher");
}

std::vector<std::string> offset_remarks(const OffsetEffect& effect, double peak) {
  const SensorOffset& offset = effect.offset;
  const double root = std::sqrt(static_cast<double>(offset.samples));
  bool is_more_than_noise = false;
  for (std::size_t i = 0; i < offset.mean.size(); ++i)
    is_more_than_noise = is_more_than_noise || std::abs(offset.mean[i]) > surely * offset.scatter[i] / root;
  std::vector<std::string> remarks;
  const double change = std::abs(effect.hic15_with - effect.hic15_without);
  if (!effect.taken_off && is_more_than_noise && change > worth_a_remark * effect.hic15_without)
    remarks.push_back(fmt::format("there is an offset of {} before the impact: {}; --zero auto subtracts it",
                                  each_in_g(offset.mean, peak), change_of_hic15(effect)));
  if (effect.given && std::ranges::max(offset.scatter) > max_quiet_scatter * peak)
    remarks.push_back(fmt::format("the --zero interval is not quiet: its scatter is {}, and the peak is {}",
                                  each_in_g(offset.scatter, peak), each_in_g({peak}, peak)));
  return remarks;
}

std::optional<SpeedCheck> speed_check(const PulseReport& report) {
  if (!report.impact) return std::nullopt;
  const double speed = report.impact->speed, sensed = report.contact.velocity_change;
  SpeedCheck check{.change = change_of_motion(report.contact, *report.impact)};
  const double given = sensed - check.change;  // by gravity
  if (check.change < (1 - rounding_of_velocity) * speed) check.shortfall = speed - check.change;
  if (check.change > (1 + rounding_of_velocity) * 2 * speed) check.shortfall = 2 * speed - check.change;
  if (sensed > 0) {
    check.min_scale = (speed + given) / sensed;
    check.greatest_scale = (2 * speed + given) / sensed;
  }
  const char* stated = report.impact->drop_height ? "drop height" : "speed";
  check.text = way_out(check, report.contact, stated);
  if (check.agrees())
    check.text = fmt::format(
        "The velocity change agrees with the {}: {}{} lies between {} (no rebound) and twice that. It would "
        "also agree if all accelerations were {} to {} times as large, so a scale error within that range "
        "goes unnoticed.",
        stated, shown(check.change), less_gravity(report, check), shown(speed), brief(*check.min_scale, 3),
        brief(*check.greatest_scale, 3));
  return check;
}

std::optional<Flag> unlike_speeds(const MeasuredImpact& measured, const MeasuredImpact& computed) {
  const double share = computed.speed / measured.speed - 1;
  if (!(std::abs(share) > unlike)) return std::nullopt;
  return flag_of(
      "UNLIKE SPEEDS",
      fmt::format("the impact speed in the case, {}, is {} {} than that of the measured impact, {}{}: the "
                  "comparison is between two different impacts",
                  shown(computed.speed), in_percent(std::abs(share)), share < 0 ? "lower" : "higher",
                  shown(measured.speed),
                  measured.drop_height ? fmt::format(" ({} m drop)", brief(*measured.drop_height, 4)) : ""),
      {{"speed_m_per_s", computed.speed}, {"measured_speed_m_per_s", measured.speed}});
}

std::optional<Flag> height_in_doubt(const PulseReport& report) {
  if (!report.impact || !report.impact->drop_height || !report.offset || !report.offset->offset.rest)
    return std::nullopt;
  const double fall = report.contact.begin - report.offset->offset.begin;
  const double height = standard_gravity * fall * fall / 2, said = *report.impact->drop_height;
  const double interval = interval_of(report.measured.pulse);
  if (std::abs(height / said - 1) <= unlike + 2 * samples_in_doubt * interval / fall) return std::nullopt;
  return flag_of("DROP HEIGHT IN DOUBT",
                 fmt::format("the recorded fall lasts {} ms, as in a drop of {} m, but {} m was given",
                             brief(1e3 * fall, 4), brief(height, 3), brief(said, 4)),
                 {{"fall_s", fall}, {"height_m", height}, {"stated_height_m", said}});
}

}  // namespace dashpad::injury
