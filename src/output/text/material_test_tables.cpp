// The tables of a material test.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_events = 24;  ///< shown of a run; the JSON has all

using Row = std::vector<std::string>;

/// Cells in the units shown.
struct Cells {
  const UnitSystem& units;

  [[nodiscard]] std::string stress(double value) const { return significant(value_in(units, value, "Pa")); }
  [[nodiscard]] std::string time(double value) const { return significant(value_in(units, value, "s")); }
  [[nodiscard]] std::string stress_unit() const { return shown_unit(unit_for(units, "Pa")); }
  [[nodiscard]] std::string in_stress(const std::string& what) const {
    return fmt::format("{} ({})", what, stress_unit());
  }
  [[nodiscard]] std::string in_energy(const std::string& what) const {
    return fmt::format("{} ({})", what, energy_density_unit(units));
  }
};

std::string rate_cell(const laboratory::MaterialTestRun& run) {
  return run.rate ? brief(*run.rate) : "measured";
}

/// Strains are differences of lengths: what rounding leaves of them is nothing.
std::string strain_cell(double strain) { return std::abs(strain) < 1e-12 ? "0" : significant(strain); }

/// Rounding may leave a little less than nothing: no "-0.000".
std::string percent(double fraction) {
  const std::string text = fmt::format("{:.3f}", 100 * fraction);
  return text == "-0.000" ? "0.000" : text;
}

Table figures_table(const laboratory::MaterialTestReport& report, const Cells& cells) {
  Table table{.caption = "Figures",
              .columns = {"Rate (1/s)", cells.in_stress("Peak stress"), "at strain",
                          cells.in_energy("Energy in"), cells.in_energy("Energy returned"), "Hysteresis (%)",
                          "Best efficiency", "at strain", cells.in_stress("at stress"), "with ideality"}};
  for (const laboratory::MaterialTestRun& run : report.runs) {
    const laboratory::CushionFigures& figures = run.figures;
    table.rows.push_back(
        {rate_cell(run), cells.stress(figures.peak_stress), significant(figures.strain_at_peak),
         cells.stress(figures.energy_in), run.unloads ? cells.stress(figures.energy_returned) : "-",
         run.unloads ? percent(figures.hysteresis) : "-", significant(figures.best_efficiency.efficiency),
         significant(figures.best_efficiency.strain), cells.stress(figures.best_efficiency.stress),
         significant(figures.best_efficiency.ideality)});
  }
  return table;
}

Table limits_table(const laboratory::MaterialTestReport& report, const Cells& cells) {
  Table table{.caption = "Cushioning at a stress limit",
              .columns = {"Rate (1/s)", cells.in_stress("Limit"), "reached at strain",
                          cells.in_energy("Energy"), "Efficiency", "Ideality"}};
  for (const laboratory::MaterialTestRun& run : report.runs)
    for (std::size_t i = 0; i < run.at_limits.size(); ++i) {
      const auto& at = run.at_limits[i];
      const std::string limit = cells.stress(report.test.stress_limits[i]);
      table.rows.push_back(at ? Row{rate_cell(run), limit, significant(at->strain), cells.stress(at->energy),
                                    significant(at->efficiency), significant(at->ideality)}
                              : Row{rate_cell(run), limit, "not reached", "-", "-", "-"});
    }
  return table;
}

Table relaxation_table(const laboratory::MaterialTestReport& report, const Cells& cells) {
  const auto after = [&](double time) {
    return cells.in_stress("Stress after " + brief_quantity(time, "s", cells.units));
  };
  Table table{.caption = "Relaxation",
              .columns = {"Rate (1/s)", cells.in_stress("Stress at the end of the ramp"),
                          after(0.1 * report.test.hold), after(report.test.hold), "Remaining (%)"}};
  for (const laboratory::MaterialTestRun& run : report.runs) {
    const laboratory::RelaxedStress& relaxed = *run.relaxed;
    table.rows.push_back({rate_cell(run), cells.stress(relaxed.at_end_of_ramp),
                          cells.stress(relaxed.after_tenth), cells.stress(relaxed.after_hold),
                          percent(relaxed.after_hold / relaxed.at_end_of_ramp)});
  }
  return table;
}

Table creep_table(const laboratory::MaterialTestReport& report, const Cells& cells) {
  Table table{.caption = "Creep",
              .columns = {"Rate (1/s)", "Strain at the end of loading",
                          "Strain after " + brief_quantity(report.test.hold, "s", cells.units), "Creep"}};
  for (const laboratory::MaterialTestRun& run : report.runs)
    table.rows.push_back({rate_cell(run), significant(run.crept->at_end_of_loading),
                          significant(run.crept->after_hold),
                          significant(run.crept->after_hold - run.crept->at_end_of_loading)});
  return table;
}

Table table_of_1984(const laboratory::MaterialTestReport& report, const Cells& cells) {
  Table table{
      .caption = fmt::format("The 1984 update, {} steps in the first loading", *report.test.steps_of_1984),
      .columns = {"Rate (1/s)", fmt::format("Step ({})", shown_unit(cells.units.time)), "Stress",
                  cells.in_stress("end of loading"), cells.in_stress("one step later"),
                  cells.in_stress("Jump"), "Jump (%)"}};
  for (const laboratory::MaterialTestRun& run : report.runs) {
    const laboratory::UpdateOf1984& update = *run.update_of_1984;
    for (const auto& [name, turn] :
         {std::pair{"1984", update.update_at_turn}, {"exact", update.exact_at_turn}}) {
      Row row{rate_cell(run), cells.time(update.step), name, "-", "-", "-", "-"};
      if (turn) {
        row[3] = cells.stress(turn->last_loading);
        row[4] = cells.stress(turn->next);
        row[5] = cells.stress(turn->jump());
        if (turn->last_loading > 0) row[6] = fmt::format("{:+.2f}", 100 * turn->jump() / turn->last_loading);
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// In the order of laboratory::ColumnEvent::Kind.
constexpr std::array names_of_events{"unloading begins", "loading begins again", "contact lost",
                                     "contact regained"};

Table events_table(const laboratory::MaterialTestReport& report, const Cells& cells) {
  Table table{
      .caption = "Events",
      .columns = {"Rate (1/s)", "Event", "at strain", fmt::format("Time ({})", shown_unit(cells.units.time)),
                  cells.in_stress("Stress before"), cells.in_stress("Stress after")}};
  for (const laboratory::MaterialTestRun& run : report.runs) {
    const auto& events = run.column.events;
    for (std::size_t i = 0; i < events.size() && i < max_events; ++i) {
      const laboratory::ColumnEvent& event = events[i];
      table.rows.push_back({rate_cell(run), names_of_events.at(static_cast<std::size_t>(event.kind)),
                            strain_cell(event.strain), cells.time(event.time),
                            cells.stress(event.stress_before), cells.stress(event.stress_after)});
    }
    if (events.size() > max_events)
      table.rows.push_back(
          {rate_cell(run), fmt::format("{} more; see --json", events.size() - max_events), "", "", "", ""});
  }
  return table;
}

}  // namespace

std::string energy_density_unit(const UnitSystem& units) {
  if (units.pressure == "kPa") return "kJ/m³";
  if (units.pressure == "MPa") return "MJ/m³";
  if (units.pressure == "psi") return "in·lbf/in³";
  return "J/m³";
}

std::vector<Table> tables_of(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  const Cells cells{units};
  std::vector<Table> tables{figures_table(report, cells)};
  if (!report.test.stress_limits.empty()) tables.push_back(limits_table(report, cells));
  if (report.test.kind == laboratory::TestKind::relaxation) tables.push_back(relaxation_table(report, cells));
  if (report.test.kind == laboratory::TestKind::creep) tables.push_back(creep_table(report, cells));
  if (report.test.steps_of_1984) tables.push_back(table_of_1984(report, cells));
  if (Table events = events_table(report, cells); !events.rows.empty()) tables.push_back(std::move(events));
  return tables;
}

}  // namespace dashpad::output
