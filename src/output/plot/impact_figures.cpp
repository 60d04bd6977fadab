#include "output/plot/impact_figures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/plot/axis_with_unit.hpp"

namespace dashpad::output {

namespace {

constexpr const char* no_finite_limit = "The force is unbounded at full compression and runs off the plot.";

CaptionedPlot figure(std::string title, Panel panel, std::string note = {}) {
  return {.plot = {.title = std::move(title), .panels = {std::move(panel)}}, .note = std::move(note)};
}

/// Force over a distance, solid on the way in and dashed on the way back.
Panel loop(const char* key, const std::vector<double>& way, const Solution& solution,
           const UnitSystem& units) {
  const std::vector<double> x = values_in(units, way, "m"), y = values_in(units, solution.history.force, "N");
  Panel panel{.x = axis_of(key, units), .y = axis_of("force", units)};
  panel.x.low = panel.y.low = 0;
  panel.y.high = 1.06 * std::ranges::max(y);
  end_before_bottoming(panel.y, solution, y);
  const auto palette_index = static_cast<std::size_t>(std::ranges::max_element(x) - x.begin());
  Series there{.label = result_quantity(key).title, .style = SeriesStyle::solid_line, .palette_index = 0};
  Series back{.style = SeriesStyle::dashed_line, .palette_index = 0, .has_arrow = true, .of = there.label};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i <= palette_index) there.add(x[i], y[i]);
    if (i >= palette_index) back.add(x[i], y[i]);
  }
  panel.series = {std::move(there), std::move(back)};
  return panel;
}

/// A quantity that is plotted over time.
struct OverTime {
  const char* key;
  const std::vector<double>& values;  ///< SI, an entry for each of the history
  std::size_t palette_index;
};

Panel over_time(const History& history, Axis y, const std::vector<OverTime>& columns,
                const UnitSystem& units) {
  Panel panel{.x = axis_of("time", units), .y = std::move(y)};
  for (const OverTime& over_time : columns)
    panel.series.push_back({.label = result_quantity(over_time.key).title,
                            .x = values_in(units, history.time, "s"),
                            .y = values_in(units, over_time.values, panel.y.si_unit),
                            .palette_index = over_time.palette_index});
  return panel;
}

Panel force_panel(const Solution& solution, const UnitSystem& units) {
  const History& history = solution.history;
  Panel panel = over_time(history, axis_of("force", units), {{"force", history.force, 0}}, units);
  panel.y.high = 1.06 * std::ranges::max(panel.series.front().y);
  show_bottoming(panel, solution, std::vector(panel.series.front().y), units);
  return panel;
}

/// Rounding below nothing would begin the axis at the next tick below, and must not be cut off by it.
void begin_at_zero(Panel& panel) {
  double lowest = 0, highest = 0;
  for (const Series& series : panel.series)
    for (const double value : series.y) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  if (lowest <= -1e-6 * highest) return;
  panel.y.low = 0;
  for (Series& series : panel.series)
    for (double& value : series.y) value = std::max(value, 0.0);
}

std::string percent(double share) { return fmt::format("{} %", significant(100 * share, 2)); }

/// Nearer to full compression than half a hundredth, stress has no finite limit.
double highest_stress(const std::vector<ContactSnapshot>& snapshots) {
  double highest = 0;
  for (const ContactSnapshot& snapshot : snapshots)
    for (std::size_t i = 0; i < snapshot.stress.size(); ++i)
      if (snapshot.strain[i] < 0.995) highest = std::max(highest, snapshot.stress[i]);
  return highest;
}

/// The largest relative difference between the force and the integral of stresses that the law determines.
double deviation_of_stress(const std::vector<ContactSnapshot>& snapshots) {
  double deviation = 0;
  for (const ContactSnapshot& snapshot : snapshots)
    if (snapshot.determined)
      deviation = std::max(deviation, std::abs(snapshot.force_of_stress() / snapshot.force - 1));
  return deviation;
}

std::string note_on_stress(const std::vector<ContactSnapshot>& snapshots, double highest) {
  const auto known = std::ranges::count_if(snapshots, &ContactSnapshot::determined);
  const bool leaves = std::ranges::any_of(snapshots, [&](const ContactSnapshot& snapshot) {
    return std::ranges::any_of(snapshot.stress, [&](double stress) { return stress > highest; });
  });
  std::string note;
  if (known > 0)
    note += fmt::format("The integral of these stresses differs from the force by at most {}. ",
                        percent(deviation_of_stress(snapshots)));
  if (known < std::ssize(snapshots))
    note +=
        "When the pad is locked or the rigid foam is at rest, the law determines the force but not its "
        "distribution. ";
  if (leaves) note += "Within 0.5 % of full compression, the stress is off the scale. ";
  return note.substr(0, note.find_last_not_of(' ') + 1);
}

/// Sets the axis of stresses. Where the stress near full compression exceeds all others by far, it spans four
/// decades up to that stress.
void set_stress_axis(Axis& axis, const std::vector<ContactSnapshot>& snapshots, double highest,
                     double factor) {
  double lowest = highest;
  for (const ContactSnapshot& snapshot : snapshots)
    if (!snapshot.stress.empty()) lowest = std::min(lowest, std::ranges::max(snapshot.stress));
  if (!(highest > 0)) return;
  axis.low = 0;
  axis.high = 1.06 * highest * factor;
  if (!(highest > 30 * lowest)) return;
  const double top = std::pow(10, std::ceil(std::log10(highest * factor)));
  axis = {.label = axis.label,
          .si_unit = axis.si_unit,
          .per_si = axis.per_si,
          .logarithmic = true,
          .low = top / 1e4,
          .high = top};
}

/// Integral of a force over the way that it goes, up to each entry, by trapezoids.
template <class Way>
std::vector<double> work_of(const std::vector<double>& force, Way&& way) {
  std::vector<double> work(force.size(), 0.0);
  for (std::size_t i = 1; i < force.size(); ++i)
    work[i] = work[i - 1] + (force[i - 1] + force[i]) / 2 * (way(i) - way(i - 1));
  return work;
}

}  // namespace

std::vector<CaptionedPlot> impact_figures(const ImpactCase& impact, const Solution& solution,
                                          const std::optional<injury::InjuryFigures>& injury,
                                          const UnitSystem& units) {
  const History& history = solution.history;
  if (history.size() == 0) return {};
  const std::string note = bottomed_on_rigid_support(solution.summary) ? no_finite_limit : "";
  const ImpactEnergies energies = impact_energies(impact, history);
  const EnergyLedger& audit = solution.summary.energy;
  Panel deceleration = deceleration_panel(solution, injury, units);
  deceleration.title.clear();
  const bool is_rigid = impact.support.is_rigid() && !solution.summary.support;
  std::vector<OverTime> ways{{"penetration", history.penetration, 1}};
  std::vector<OverTime> parts{{"kinetic_energy", energies.kinetic, 0},
                              {"pad_energy", energies.pad, 1},
                              {"total_energy", energies.total, 6}};
  if (!is_rigid) {
    ways.push_back({"motion", history.motion, 0});
    ways.push_back({"support_deflection", history.support_deflection, 2});
    parts.push_back({"support_energy", energies.support, 2});
  }
  Panel distances = over_time(history, axis_with_unit("Distance", "m", units), ways, units);
  Panel energy = over_time(history, axis_with_unit("Energy", "J", units), parts, units);
  for (Panel* const panel : {&distances, &energy}) begin_at_zero(*panel);
  std::vector<CaptionedPlot> figures{
      figure("Force over time", force_panel(solution, units), note),
      figure("Deceleration over time", std::move(deceleration), note),
      figure("Force against penetration", loop("penetration", history.penetration, solution, units), note)};
  if (!is_rigid)
    figures.push_back(
        figure("Force against displacement", loop("motion", history.motion, solution, units), note));
  figures.push_back(figure(is_rigid ? "Penetration over time" : "Penetration and displacement over time",
                           std::move(distances)));
  figures.push_back(figure(
      "Energy over time", std::move(energy),
      fmt::format(
          "The sum of the energies (work by the trapezoidal rule) stays within {} of the impact energy. The "
          "solver's energy audit, which is of higher order, gives a residual of {} at the end.",
          percent(energies.largest_deviation), percent(std::abs(audit.residual / audit.impact)))));
  return figures;
}

std::vector<CaptionedPlot> contact_figures(const std::vector<ContactSnapshot>& snapshots,
                                           const UnitSystem& units) {
  if (snapshots.empty()) return {};
  Panel stress{.x = axis_with_unit("Radius", "m", units), .y = axis_with_unit("Stress", "Pa", units)};
  Panel strain{.x = stress.x, .y = {.label = "Strain"}};
  const double highest = highest_stress(snapshots);
  set_stress_axis(stress.y, snapshots, highest, value_in(units, 1, "Pa"));
  for (std::size_t palette_index = 0; palette_index < snapshots.size(); ++palette_index) {
    const ContactSnapshot& snapshot = snapshots[palette_index];
    const std::string label =
        fmt::format("{}, {}", brief_quantity(snapshot.time, "s", units, 3), snapshot.when);
    const std::vector<double> radius = values_in(units, snapshot.radius, "m");
    stress.series.push_back({.label = label,
                             .x = radius,
                             .y = values_in(units, snapshot.stress, "Pa"),
                             .palette_index = palette_index});
    strain.series.push_back(
        {.label = label, .x = radius, .y = snapshot.strain, .palette_index = palette_index});
  }
  // Next to full compression stations of their own do not find the force again.
  constexpr double max_deviation = 0.05;
  if (!(deviation_of_stress(snapshots) <= max_deviation))
    return {figure("Strain across the contact", std::move(strain),
                   "The stress across the contact is not shown: near full compression, its integral differs "
                   "from the force by more than 5 %.")};
  return {figure("Stress across the contact", std::move(stress), note_on_stress(snapshots, highest)),
          figure("Strain across the contact", std::move(strain))};
}

ImpactEnergies impact_energies(const ImpactCase& impact, const History& history) {
  const std::vector<double> back = work_of(history.force_of_pad(), [&](std::size_t i) {
    return history.support_deflection[i] + (history.body_motion.empty() ? 0 : history.body_motion[i]);
  });
  // A sheet on the pad takes its share of the energy from the impactor.
  const bool has_sheet = !history.pad_force.empty();
  ImpactEnergies energies;
  energies.pad = work_of(
      history.force, [&](std::size_t i) { return has_sheet ? history.motion[i] : history.penetration[i]; });
  const double weight = impact.impactor.mass * impact.impactor.gravity;
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (has_sheet) energies.pad[i] -= back[i];
    energies.kinetic.push_back(impact.impactor.mass * history.velocity[i] * history.velocity[i] / 2);
    // As long as a support is only elastic, its energy is a function of the force.
    const double elastic = impact.support.is_rigid() ? 0.0 : impact.support.energy(history.force_of_pad()[i]);
    energies.support.push_back(history.body_motion.empty() ? elastic : back[i]);
    energies.total.push_back(energies.kinetic[i] + energies.support[i] + energies.pad[i] -
                             weight * history.motion[i]);
    energies.largest_deviation =
        std::max(energies.largest_deviation, std::abs(energies.total[i] / energies.kinetic.front() - 1));
  }
  return energies;
}

}  // namespace dashpad::output
