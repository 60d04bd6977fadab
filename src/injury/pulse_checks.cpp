// What a pulse says of itself: whether it is whole, zeroed, and of the impact that it is said to be of.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/injury/pulse_report.hpp"
#include "injury/pulse_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::injury {

namespace {

constexpr double lowest_cut = 0.01;          // of the peak
constexpr double cut_in_noise = 4;           // of the scatter
constexpr double most_quiet_scatter = 0.02;  // of the peak, of a part that is quiet
constexpr double worth_a_remark = 1e-3;      // of HIC15
constexpr double surely = 3;                 // standard errors of a mean that is not 0
constexpr double rounding = 1e-9;            // of the peak

/// Root mean square of the samples in the quiet interval, m/s2; 0 where there is none.
double scatter(const PulseReport& report, const Pulse& pulse, double peak) {
  if (!report.offset) return 0;
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < pulse.time.size() && pulse.time[i] <= report.offset->offset.end; ++i)
    if (pulse.time[i] >= report.offset->offset.begin) {
      squares += pulse.acceleration[i] * pulse.acceleration[i];
      ++count;
    }
  const double found = count > 0 ? std::sqrt(squares / count) : 0;
  return found <= most_quiet_scatter * peak ? found : 0;
}

Flag cut(const std::string& where, double acceleration, double peak, const std::string& missing) {
  const double left = std::abs(acceleration), share = left / peak;
  std::string text = fmt::format(
      "PULSE CUT: it {} at {} g, {} of its peak: {}, or the sensor has an offset; of a pulse that is not "
      "whole "
      "HIC, clips and velocity change are lower bounds",
      where, brief(left / standard_gravity), in_percent(share), missing);
  return {"PULSE CUT", std::move(text), {{"acceleration_m_per_s2", left}, {"peak_fraction", share}}};
}

}  // namespace

MeasuredImpact after_fall(double drop_height) {
  return {.speed = std::sqrt(2 * standard_gravity * drop_height),
          .drop_height = drop_height,
          .gravity = standard_gravity};
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
    all.push_back({"IMPOSSIBLE VELOCITY CHANGE",
                   fmt::format("IMPOSSIBLE VELOCITY CHANGE: {} m/s is {} the impact speed, {} m/s; likely {}",
                               brief(std::max(check->change, 0.0)),
                               is_short ? "less than" : "more than twice", brief(report.impact->speed),
                               is_short ? "the pulse is cut, the unit or the sensitivity is wrong, or the "
                                          "sensor has an offset"
                                        : "the sensor has an offset, the unit or the sensitivity is wrong, "
                                          "or there is more than one impact in the pulse"),
                   {{"velocity_change_m_per_s", check->change}, {"speed_m_per_s", report.impact->speed}}});
  }
  if (std::optional<Flag> flag = height_in_doubt(report)) all.push_back(*std::move(flag));
  return all;
}

std::string each_in_g(const std::vector<double>& accelerations, double peak) {
  std::string text;
  for (const double value : accelerations)
    text += fmt::format("{}{:.3g}", text.empty() ? "" : ", ",
                        std::abs(value) < rounding * peak ? 0 : value / standard_gravity);
  return text + " g";
}

std::string in_percent(double fraction) {
  return fraction < 0.99 ? percentage(fraction) : fmt::format("{:.0f} %", 100 * fraction);
}

std::string change_of_hic15(const OffsetEffect& effect) {
  if (!(effect.hic15_without > 0))
    return fmt::format("HIC15 is {} with it, and 0 without", brief(effect.hic15_with));
  const double change = effect.hic15_with / effect.hic15_without - 1;
  return fmt::format("HIC15 is {} {} with it than without", in_percent(std::abs(change)),
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
    remarks.push_back(fmt::format("an offset of {} before the impact: {}; --zero auto takes it off",
                                  each_in_g(offset.mean, peak), change_of_hic15(effect)));
  if (effect.given && std::ranges::max(offset.scatter) > most_quiet_scatter * peak)
    remarks.push_back(fmt::format("the interval of --zero is not quiet: its scatter is {}, and the peak {}",
                                  each_in_g(offset.scatter, peak), each_in_g({peak}, peak)));
  return remarks;
}

}  // namespace dashpad::injury
