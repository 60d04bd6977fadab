#include "io/summary_rows.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/version.hpp"
#include "io/text.hpp"

namespace dashpad {

namespace {

class Rows {
 public:
  explicit Rows(const UnitSystem& units) : units_(units) {}

  void add(const std::string& label, double value, const std::string& si_unit, std::optional<double> error,
           const std::string& remark = "") {
    add_shown(label, significant(value_in(units_, value, si_unit)), shown_unit(unit_for(units_, si_unit)),
              error, remark);
  }

  void add_shown(const std::string& label, const std::string& value, const std::string& unit,
                 std::optional<double> error, const std::string& remark = "") {
    rows_.push_back({label, value, unit, error ? shown_error(*error) : "", remark});
  }

  [[nodiscard]] const std::vector<SummaryRow>& rows() const { return rows_; }

 private:
  const UnitSystem& units_;
  std::vector<SummaryRow> rows_;
};

std::string bottomed_flag(const Summary& summary, const UnitSystem& units) {
  const Moment& moment = *summary.bottomed;
  const bool rigid = summary.status == Status::bottomed_out;
  return fmt::format(
      "BOTTOMED at {}, the impactor still moving at {}{}", brief_quantity(moment.time, "s", units),
      brief_quantity(moment.velocity, "m/s", units),
      rigid ? "; figures are up to that moment" : "; while it stayed so, only the support gave way");
}

void add_force(Rows& rows, const Summary& summary) {
  if (!summary.peak_force) {
    rows.add_shown("Peak force", "none", "", {}, "not finite once the pad is fully compressed");
    return;
  }
  rows.add("Peak force", *summary.peak_force, "N", summary.errors.peak_force);
  if (summary.peak_acceleration)
    rows.add_shown("Peak acceleration", significant(*summary.peak_acceleration / standard_gravity), "g",
                   summary.errors.peak_force);
  if (summary.time_of_peak_force)
    rows.add("Time to peak force", *summary.time_of_peak_force, "s", summary.errors.time_of_peak_force);
}

/// Close to full compression the rounded percentage would look like bottoming: there, what is left is said.
std::string part_of_pad(double penetration, double thickness) {
  const double left = 1 - penetration / thickness;
  return left > 0 && left < 5e-5 ? fmt::format("all but {} of the pad", percentage(left))
                                 : fmt::format("{} % of the pad", significant(100 * (1 - left)));
}

void add_travel(Rows& rows, const ImpactCase& impact, const Summary& summary) {
  rows.add("Peak penetration", summary.peak_penetration, "m", summary.errors.peak_penetration,
           part_of_pad(summary.peak_penetration, impact.pad.thickness));
  rows.add("Peak motion", summary.peak_motion, "m", summary.errors.peak_motion, "pad and support");
}

void add_rebound(Rows& rows, const Summary& summary) {
  if (summary.rebound_speed)
    rows.add("Rebound speed", *summary.rebound_speed, "m/s", summary.errors.rebound_speed,
             summary.restitution ? "restitution " + significant(*summary.restitution) : "");
  if (summary.contact_end)
    rows.add("End of contact", summary.contact_end->time, "s", summary.errors.contact_end,
             fmt::format("force below {} of its peak", percentage(contact_end_share)));
}

void add_energy(Rows& rows, const Summary& summary, const UnitSystem& units) {
  rows.add_shown("Energy absorbed", significant(100 * summary.energy_absorbed_fraction), "%",
                 summary.errors.energy_absorbed,
                 fmt::format("of the {} of the impact", brief_quantity(summary.energy.initial, "J", units)));
}

void add_details(Rows& rows, const Summary& summary, const UnitSystem& units) {
  rows.add("Peak strain", summary.peak_strain, "1", {}, "on the axis");
  rows.add("Peak strain rate", summary.peak_strain_rate, "1/s", {});
  if (summary.weight)
    rows.add("Force below weight", summary.weight->time, "s", summary.errors.weight,
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

}  // namespace

std::string outcome(const Summary& summary) {
  switch (summary.status) {
    case Status::released:
      return pulse_is_whole(summary) ? "The impactor rebounded and left the pad."
                                     : "The pad stopped the impactor and does not push it back.";
    case Status::bottomed_out: return "The pad bottomed out on its rigid support: no finite force beyond.";
    case Status::time_limit: return "The impactor was still on the pad when the time was up.";
    case Status::tolerance_not_met:
      return summary.release ? "The impactor rebounded and left the pad."
                             : "The computation stopped before the impactor left the pad.";
    case Status::not_run: return "Nothing was computed.";
  }
  return "";
}

std::vector<std::string> warnings(const Summary& summary, const UnitSystem& units) {
  std::vector<std::string> lines;
  for (const Flag& flag : flags(summary)) {
    if (flag.name == "NOT RUN") continue;
    lines.push_back(flag.name == "BOTTOMED" ? bottomed_flag(summary, units) : one_line(flag.text));
  }
  return lines;
}

std::vector<SummaryRow> summary_rows(const ImpactCase& impact, const Summary& summary,
                                     const UnitSystem& units) {
  if (summary.status == Status::not_run) return {};
  Rows rows{units};
  add_force(rows, summary);
  add_travel(rows, impact, summary);
  add_rebound(rows, summary);
  add_energy(rows, summary, units);
  add_details(rows, summary, units);
  return rows.rows();
}

std::string numbers_text(const Summary& summary) {
  const std::string stations =
      summary.stations > 0 ? fmt::format("{} stations", summary.stations) : "contact force in closed form";
  return fmt::format("Solved {}: {} steps, {}, {} runs, {}; energy residual {} (dashpad {})",
                     tolerance_text(summary), summary.steps, stations, summary.runs,
                     duration(summary.wall_time),
                     percentage(std::abs(summary.energy.residual / summary.energy.initial)), version());
}

std::string shown_error(double error) { return error < 1e-6 ? "< 0.0001 %" : percentage(error); }

}  // namespace dashpad
