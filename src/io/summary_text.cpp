#include "dashpad/io/summary_text.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dashpad/io/case_text.hpp"
#include "dashpad/version.hpp"
#include "io/text.hpp"

namespace dashpad {

namespace {

/// Figures right-aligned one below the other, each with its unit, error and a remark.
class Table {
 public:
  explicit Table(const UnitSystem& units) : units_(units) {}

  void add(const std::string& label, double value, const std::string& si_unit, std::optional<double> error,
           const std::string& remark = "") {
    add_shown(label, significant(value_in(units_, value, si_unit)), shown_unit(unit_for(units_, si_unit)),
              error, remark);
  }

  void add_shown(const std::string& label, const std::string& value, const std::string& unit,
                 std::optional<double> error, const std::string& remark = "") {
    std::string line = fmt::format("  {:<19}{:>11} {:<7} {:<12} {}", label, value, unit,
                                   error ? "± " + shown_error(*error) : "", remark);
    line.erase(line.find_last_not_of(' ') + 1);
    text_ += line + "\n";
  }

  /// Below a millionth of the figure nobody looks for digits.
  static std::string shown_error(double error) { return error < 1e-6 ? "< 0.0001 %" : percentage(error); }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  const UnitSystem& units_;
  std::string text_;
};

std::string outcome(const Summary& summary) {
  switch (summary.status) {
    case Status::released: return "The impactor rebounded and left the pad.";
    case Status::bottomed_out: return "The pad bottomed out on its rigid support: no finite force beyond.";
    case Status::time_limit: return "The impactor was still on the pad when the time was up.";
    case Status::tolerance_not_met:
      return summary.release ? "The impactor rebounded and left the pad."
                             : "The computation stopped before the impactor left the pad.";
    case Status::not_run: return "Nothing was computed.";
  }
  return "";
}

std::string bottomed_flag(const Summary& summary, const UnitSystem& units) {
  const Moment& moment = *summary.bottomed;
  const bool rigid = summary.status == Status::bottomed_out;
  return fmt::format(
      "BOTTOMED at {}, the impactor still moving at {}{}\n", brief_quantity(moment.time, "s", units),
      brief_quantity(moment.velocity, "m/s", units),
      rigid ? "; figures are up to that moment" : "; while it stayed so, only the support gave way");
}

std::string flags(const Summary& summary, const UnitSystem& units) {
  std::string text;
  if (summary.status == Status::tolerance_not_met)
    text += fmt::format(
        "TOLERANCE NOT MET: asked for {}; do not rely on these figures beyond their ±, nor on the "
        "± itself\n",
        percentage(summary.tolerance));
  if (summary.status == Status::time_limit) text += "TIME LIMIT: no rebound figures\n";
  if (summary.bottomed) text += bottomed_flag(summary, units);
  for (const std::string& reason : summary.extrapolations) text += "EXTRAPOLATED: " + one_line(reason) + "\n";
  if (summary.extrapolated && summary.extrapolations.empty())
    text += "EXTRAPOLATED: outside the range in which the material was fitted\n";
  return text;
}

void add_force(Table& table, const Summary& summary) {
  if (!summary.peak_force) {
    table.add_shown("Peak force", "none", "", {}, "not finite once the pad is fully compressed");
    return;
  }
  table.add("Peak force", *summary.peak_force, "N", summary.errors.peak_force);
  if (summary.peak_acceleration)
    table.add_shown("Peak acceleration", significant(*summary.peak_acceleration / standard_gravity), "g",
                    summary.errors.peak_force);
  if (summary.time_of_peak_force)
    table.add("Time to peak force", *summary.time_of_peak_force, "s", summary.errors.time_of_peak_force);
}

/// Close to full compression the rounded percentage would look like bottoming: there, what is left is said.
std::string part_of_pad(double penetration, double thickness) {
  const double left = 1 - penetration / thickness;
  return left > 0 && left < 5e-5 ? fmt::format("all but {} of the pad", percentage(left))
                                 : fmt::format("{} % of the pad", significant(100 * (1 - left)));
}

void add_travel(Table& table, const ImpactCase& impact, const Summary& summary) {
  table.add("Peak penetration", summary.peak_penetration, "m", summary.errors.peak_penetration,
            part_of_pad(summary.peak_penetration, impact.pad.thickness));
  table.add("Peak motion", summary.peak_motion, "m", summary.errors.peak_motion, "pad and support");
}

void add_rebound(Table& table, const Summary& summary) {
  if (summary.rebound_speed)
    table.add("Rebound speed", *summary.rebound_speed, "m/s", summary.errors.rebound_speed,
              summary.restitution ? "restitution " + significant(*summary.restitution) : "");
  if (summary.release) table.add("Time of release", summary.release->time, "s", summary.errors.release_time);
}

void add_energy(Table& table, const Summary& summary, const UnitSystem& units) {
  table.add_shown("Energy absorbed", significant(100 * summary.energy_absorbed_fraction), "%",
                  summary.errors.energy_absorbed,
                  fmt::format("of the {} of the impact", brief_quantity(summary.energy.initial, "J", units)));
}

void add_details(Table& table, const Summary& summary, const UnitSystem& units) {
  table.add("Peak strain", summary.peak_strain, "1", {}, "on the axis");
  table.add("Peak strain rate", summary.peak_strain_rate, "1/s", {});
  if (summary.weight)
    table.add("Force below weight", summary.weight->time, "s", summary.errors.weight,
              "rebounding at " + brief_quantity(-summary.weight->velocity, "m/s", units));
}

std::string tolerance_text(const Summary& summary) {
  const std::string tolerance = percentage(summary.tolerance);
  return summary.trustworthy() ? "to a tolerance of " + tolerance
                               : "without meeting the tolerance of " + tolerance;
}

std::string duration(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

std::string numbers_text(const Summary& summary) {
  const std::string stations =
      summary.stations > 0 ? fmt::format("{} stations", summary.stations) : "contact force in closed form";
  return fmt::format("Solved {}: {} steps, {}, {} runs, {}; energy residual {} (dashpad {})\n",
                     tolerance_text(summary), summary.steps, stations, summary.runs,
                     duration(summary.wall_time),
                     percentage(std::abs(summary.energy.residual / summary.energy.initial)), version());
}

}  // namespace

std::string summary_text(const ImpactCase& impact, const Summary& summary, const UnitSystem& units) {
  std::string text = case_text(impact, units) + "\n" + outcome(summary) + "\n" + flags(summary, units);
  if (summary.status == Status::not_run) return text;
  Table table{units};
  add_force(table, summary);
  add_travel(table, impact, summary);
  add_rebound(table, summary);
  add_energy(table, summary, units);
  add_details(table, summary, units);
  return text + "\n" + table.text() + "\n" + numbers_text(summary);
}

}  // namespace dashpad
