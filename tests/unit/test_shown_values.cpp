// What is drawn and what is printed, against the values behind it, in every system of units.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/output/pulse.hpp"
#include "dashpad/report1986/comparison.hpp"
#include "dashpad/spit1984/run.hpp"
#include "distinct_numbers.hpp"
#include "output/documents/pulse.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/plot/impact_figures.hpp"
#include "sample_case.hpp"
#include "shown_values.hpp"

namespace dashpad::test {
namespace {

using namespace output;

struct Solved {
  ImpactCase impact;
  Solution solution;
  std::optional<injury::InjuryFigures> injury;
};

Solved solved(const std::string& example) {
  const input::CaseFile file = input::read_case(source / "examples" / example, materials).value();
  Solved of{file.impact, solve(file.impact, file.options), {}};
  of.injury = injury::whole_pulse_figures(of.solution);
  return of;
}

/// A support that moves, crushes and damps; a sheet; layers; one that bottoms out.
const std::vector<Solved>& impacts() {
  static const std::vector<Solved> all{solved("head-on-door-panel.toml"), solved("rubber-top-on-a-mat.toml"),
                                       solved("playground-mat-in-layers.toml"),
                                       solved("rigid-floor-bottoming.toml")};
  return all;
}

std::string without_case(const std::string& markdown) {
  return markdown.substr(0, markdown.find("## The case"));
}

std::string title(const char* key) { return result_quantity(key).title; }

std::vector<double> decelerations(const History& history) {
  std::vector<double> all;
  for (const double a : history.acceleration) all.push_back(-a);
  return all;
}

// --- One impact ---

TEST(ShownValues, OfAnImpactAreThoseOfItsHistory) {
  for (const UnitSystem& units : unit_systems())
    for (const Solved& solved : impacts()) {
      const History& history = solved.solution.history;
      const std::vector<double>& time = history.time;
      const Plot still = result_plot(solved.impact, solved.solution, solved.injury, units);
      expect_series(still.panels.at(0), title("deceleration"), time, decelerations(history));
      expect_series(still.panels.at(1), title("motion"), history.motion, history.force);
      expect_series(still.panels.at(1), title("penetration"), history.penetration, history.force);
      const std::vector<Plot> figures =
          plots_of(impact_figures(solved.impact, solved.solution, solved.injury, units));
      ASSERT_GE(figures.size(), 5U);
      for (const Plot& figure : figures) {
        const Panel& panel = figure.panels.at(0);
        if (figure.title == "Force over time") {
          expect_series(panel, title("force"), time, history.force);
        } else if (figure.title == "Deceleration over time") {
          expect_series(panel, title("deceleration"), time, decelerations(history));
        } else if (figure.title == "Force against penetration") {
          expect_series(panel, title("penetration"), history.penetration, history.force);
        } else if (figure.title == "Force against displacement") {
          expect_series(panel, title("motion"), history.motion, history.force);
        } else if (figure.title == "Energy over time") {
          const ImpactEnergies energies = impact_energies(solved.impact, history);
          expect_series(panel, title("kinetic_energy"), time, energies.kinetic);
          expect_series(panel, title("pad_energy"), time, energies.pad);
          expect_series(panel, title("total_energy"), time, energies.total);
        } else {
          const bool is_rigid = solved.impact.support.is_rigid();
          EXPECT_EQ(figure.title,
                    is_rigid ? "Penetration over time" : "Penetration and displacement over time");
          expect_series(panel, title("penetration"), time, history.penetration);
          EXPECT_EQ(panel.series.size(), is_rigid ? 1U : 3U);
          if (is_rigid) continue;
          expect_series(panel, title("motion"), time, history.motion);
          expect_series(panel, title("support_deflection"), time, history.support_deflection);
        }
      }
      if (!solved.injury) continue;
      const Panel panel = panel_in_si(still.panels.at(0));
      for (const Series& series : panel.series) {
        if (series.style == SeriesStyle::horizontal_line) {
          EXPECT_NEAR(series.y.at(0), solved.injury->clip_3ms.level, 1e-9);
        } else if (series.label.starts_with(title("hic15"))) {
          EXPECT_NEAR(series.x.front(), solved.injury->hic15.begin, 1e-12);
          EXPECT_NEAR(series.x.back(), solved.injury->hic15.end, 1e-12);
          EXPECT_NEAR(std::ranges::max(series.y), 0.07 * solved.injury->peak.magnitude, 1e-9);
        }
      }
    }
}

TEST(ShownValues, OfAnImpactAreTheSameInAllUnits) {
  for (const Solved& solved : impacts()) {
    const auto snapshots = contact_snapshots(solved.impact, solved.solution.history);
    expect_same_in_all_units([&](const UnitSystem& units) {
      std::vector<Plot> plots =
          plots_of(impact_figures(solved.impact, solved.solution, solved.injury, units));
      for (Plot& plot : plots_of(contact_figures(snapshots, units))) plots.push_back(std::move(plot));
      plots.push_back(result_plot(solved.impact, solved.solution, solved.injury, units));
      if (auto curve = foam_curve_plot(solved.impact.pad, solved.solution.summary, units))
        plots.push_back(*std::move(curve));
      return plots;
    });
    const Options options;
    const ImpactReport report{solved.impact, options, solved.solution, solved.injury};
    for (const auto& written : std::vector<std::function<std::string(const Document&)>>{
             [](const Document& document) { return to_terminal(document, Detail::main); },
             // The case to copy is in SI.
             [](const Document& document) { return without_case(to_markdown(document)); }})
      expect_same_numbers_in_all_units(
          [&](const UnitSystem& units) { return numbers_in(written(impact_document(report, units))); }, 1e-2);
  }
}

TEST(ShownValues, OfTwoBodiesAreTheSameInAllUnits) {
  const Body first{3, 8}, second{11, -2};
  const ImpactCase impact = relative_motion(impacts()[0].impact, first, second);
  const Solution solution = solve(impact, {});
  expect_same_numbers_in_all_units(
      [&](const UnitSystem& units) {
        return numbers_in(
            to_terminal(post_impact_document(first, second, impact, solution, units), Detail::main));
      },
      1e-3);
}

// --- Pulses ---

/// A pulse of two humps, the second one higher, of a sensor that is mounted either way.
injury::PulseReport two_humps(double side) {
  injury::PulseReport report;
  report.file = "drop.csv";
  for (int i = 0; i <= 500; ++i) {
    const double time = 1e-4 * i;
    report.pulse.time.push_back(time - 5e-3);
    const double first = time < 10e-3 ? 300 * std::sin(std::numbers::pi * time / 10e-3) : 0;
    const double second =
        time > 12e-3 && time < 44e-3 ? 500 * std::sin(std::numbers::pi * (time - 12e-3) / 32e-3) : 0;
    report.pulse.acceleration.push_back(side * (first + second));
  }
  report.measured.pulse = report.pulse;
  report.figures = injury::injury_figures(report.pulse);
  report.impact = injury::after_fall(0.6);
  report.windows = {{7e-3, injury::hic(report.pulse, 7e-3)}};
  report.dwells = {{200, 11e-3, 6e-3}};
  return report;
}

TEST(ShownValues, OfAPulseAreItsSamplesAndItsFiguresOnTheirSide) {
  for (const double side : {1.0, -1.0}) {
    const injury::PulseReport report = two_humps(side);
    const Panel panel = panel_in_si(pulse_plot(report, unit_system("us")).panels.at(0));
    const Series& pulse = series_of(panel, "pulse");
    expect_values(pulse.x, report.pulse.time, "time");
    expect_values(pulse.y, report.pulse.acceleration, "acceleration");
    std::size_t brackets = 0;
    for (const Series& series : panel.series) {
      if (series.style == SeriesStyle::horizontal_line) {
        EXPECT_NEAR(series.y.at(0), side * report.figures.clip_3ms.level, 1e-9);
      }
      if (!series.label.starts_with("HIC")) continue;
      ++brackets;
      const injury::Hic& hic =
          series.label.starts_with("HIC15") ? report.figures.hic15 : report.figures.hic36;
      EXPECT_NEAR(series.x.front(), hic.begin, 1e-12) << series.label;
      EXPECT_NEAR(series.x.back(), hic.end, 1e-12) << series.label;
      for (const double y : series.y) EXPECT_GT(side * y, 0) << series.label;
    }
    EXPECT_EQ(brackets, 2U);
  }
}

/// Of 400 ms the 44 ms of the impact with something on either side; all samples are there.
TEST(ShownValues, OfALongRecordTheImpactIsInTheMiddle) {
  injury::PulseReport report = two_humps(1);
  EXPECT_FALSE(pulse_plot(report, unit_system("si")).panels.at(0).x.low);
  report.contact = injury::contact_of(report.pulse);
  for (int i = 1; i <= 3550; ++i) {
    report.pulse.time.push_back(45e-3 + 1e-4 * i);
    report.pulse.acceleration.push_back(0);
  }
  const Panel panel = pulse_plot(report, unit_system("si")).panels.at(0);
  EXPECT_NEAR(*panel.x.low, -5, 1e-9);  // ms: where the record begins
  EXPECT_GT(*panel.x.high, 39);
  EXPECT_LT(*panel.x.high, 60);
  EXPECT_EQ(series_of(panel, "pulse").x.size(), report.pulse.time.size());
}

TEST(ShownValues, OfDwellTimesAreAllAndTheLongest) {
  const std::string text = to_markdown(pulse_document(two_humps(-1), unit_system("si")));
  EXPECT_THAT(text, testing::ContainsRegex("11.000 ms \\| in total; longest interval 6 ms"));
}

TEST(ShownValues, OfAPulseAreTheSameInAllUnits) {
  const injury::PulseReport report = two_humps(-1);
  const Solved& impact = impacts()[0];
  const injury::PulseComparison comparison = injury::compare_pulses(
      report, impact.solution, injury::MeasuredImpact{.speed = impact.impact.impactor.speed},
      injury::Alignment::onset);
  const PulseComparisonReport both{"case.toml", impact.impact, impact.solution, report, comparison};
  expect_same_in_all_units([&](const UnitSystem& units) {
    return std::vector<Plot>{pulse_plot(report, units), pulse_comparison_plot(both, units)};
  });
  expect_same_numbers_in_all_units(
      [&](const UnitSystem& units) {
        std::vector<double> all = numbers_in(to_markdown(pulse_document(report, units)));
        for (const std::string& note : comparison_notes(both, units))
          for (const double number : numbers_in(note)) all.push_back(number);
        for (const std::vector<std::string>& row : comparison_table(both, units).rows)
          for (std::size_t i = 2; i < row.size(); ++i)
            for (const double number : numbers_in(row[i]))
              all.push_back(number * (i < 5 ? in_si(row[1]) : 1));  // shares follow
        return all;
      },
      1e-2);
}

/// What is laid over each other: the measured pulse moved by the shift that the text tells of.
TEST(ShownValues, OfTwoPulsesAreBothWithTheShiftThatIsTold) {
  const Solved& impact = impacts()[0];
  for (const double later : {-60e-3, 60e-3}) {
    injury::PulseReport report = two_humps(-1);
    for (double& time : report.pulse.time) time += later;
    const injury::PulseComparison pulse_comparison = injury::compare_pulses(
        report, impact.solution, injury::MeasuredImpact{.speed = impact.impact.impactor.speed},
        injury::Alignment::onset);
    ASSERT_LT(pulse_comparison.shift * later, 0);
    const PulseComparisonReport both{"case.toml", impact.impact, impact.solution, report, pulse_comparison};
    const Panel panel = panel_in_si(pulse_comparison_plot(both, unit_system("si")).panels.at(0));
    const Series& measured = series_of(panel, "measured");
    std::vector<double> times = report.pulse.time, values = report.pulse.acceleration;
    for (double& time : times) time += pulse_comparison.shift;
    for (double& value : values) value = -value;
    ASSERT_EQ(measured.x.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) ASSERT_NEAR(measured.x[i], times[i], 1e-12);
    expect_values(measured.y, values, "measured");
    std::vector<double> computed = pulse_comparison.computed_pulse.acceleration;
    for (double& value : computed) value = -value;
    expect_values(series_of(panel, "computed").y, computed, "computed");
    const double peak =
        pulse_comparison.computed->peak.magnitude / pulse_comparison.measured.peak.magnitude - 1;
    ASSERT_GT(std::abs(peak), 0.01);
    EXPECT_THAT(comparison_answer(both), testing::HasSubstr(peak < 0 ? "% lower than the measured one"
                                                                     : "% higher than the measured one"));
    EXPECT_THAT(to_markdown(pulse_comparison_document(both, unit_system("si"))),
                testing::HasSubstr(later > 0 ? "ms subtracted from the measured times"
                                             : "ms added to the measured times"));
  }
}

// --- Material tests ---

TEST(ShownValues, OfAMaterialTestAreThoseOfItsRuns) {
  for (const laboratory::TestKind kind :
       {laboratory::TestKind::constant_rate, laboratory::TestKind::relaxation, laboratory::TestKind::creep}) {
    laboratory::MaterialTest test;
    test.kind = kind;
    test.rates = {1, 20};
    test.strain = 0.6;
    test.stress = 50e3;
    test.hold = 0.3;
    test.stress_limits = {60e3};
    if (kind == laboratory::TestKind::constant_rate) test.steps_of_1984 = 20;
    const laboratory::MaterialTestReport report = run_material_test(
        input::read_material(materials / "ensolite-aac-9.toml").value(), test, spit1984::stresses_of_update);
    const auto panels = [&](const UnitSystem& units) {
      return std::vector<Panel>{stress_over_strain(report, units),    stress_over_time(report, units),
                                strain_over_time(report, units),      energy_over_strain(report, units),
                                efficiency_over_strain(report),       ideality_over_strain(report),
                                efficiency_over_stress(report, units)};
    };
    for (const UnitSystem& units : unit_systems()) {
      const std::vector<Panel> drawn = panels(units);
      for (std::size_t i = 0; i < report.runs.size(); ++i) {
        const laboratory::ColumnTest& column = report.runs[i].column;
        const laboratory::CushionCurve& cushion = report.runs[i].cushion;
        const std::string label = drawn[0].series.at(i).label;
        expect_series(drawn[0], label, column.strain, column.stress);
        expect_series(drawn[1], label, column.time, column.stress);
        expect_series(drawn[2], label, column.time, column.strain);
        expect_series(drawn[3], label, cushion.strain, cushion.energy);
        expect_series(drawn[4], label, cushion.strain, cushion.efficiency);
        expect_series(drawn[5], label, cushion.strain, cushion.ideality);
        expect_series(drawn[6], label, cushion.stress, cushion.efficiency);
      }
      EXPECT_NEAR(panel_in_si(drawn[6]).series.back().x.at(0), 60e3, 1e-6);
    }
    expect_same_in_all_units([&](const UnitSystem& units) {
      return std::vector<Plot>{{.panels = panels(units)}, material_test_plot(report, units)};
    });
    expect_same_numbers_in_all_units(
        [&](const UnitSystem& units) {
          std::vector<double> all;
          for (const Table& table : tables_of(report, units))
            for (const double number : numbers_in(table)) all.push_back(number);
          return all;
        },
        1e-3);
  }
}

TEST(ShownValues, OfFoamsAreTheSameInAllUnits) {
  std::vector<Material> foams;
  for (const char* name : {"vn600.toml", "ensolite-aac-9.toml", "eps-19.toml"})
    foams.push_back(input::read_material(materials / name).value());
  expect_same_in_all_units(
      [&](const UnitSystem& units) { return std::vector<Plot>{materials_plot(foams, units)}; });
}

// --- The program of 1984 beside the accurate solver ---

TEST(ShownValues, OfTheComparisonWith1984AreThoseOfItsRuns) {
  report1986::Comparison comparison;
  Distinct made;
  for (const char* name : {"accurate", "reference", "program"}) {
    report1986::ComparedRun run;
    run.name = name;
    run.finished = true;
    run.peak_force = 1000 + made.next();
    run.time_of_peak_force = made.next();
    run.peak_penetration = made.next();
    run.peak_motion = made.next();
    run.end_speed = 10 + made.next();
    run.end_time = made.next();
    run.time = made.list(3);
    run.force = made.list(3);
    run.penetration = made.list(3);
    for (double& penetration : run.penetration) penetration *= 1e-3;
    comparison.runs.push_back(run);
  }
  const report1986::ComparedRun& reference = comparison.runs[report1986::Comparison::reference];
  const ImpactCase impact = impacts()[0].impact;
  for (const UnitSystem& units : unit_systems()) {
    const std::string text = to_terminal(comparison_document(comparison, impact, units), Detail::main);
    const Plot plot = comparison_plot(comparison, impact, units);
    for (const report1986::ComparedRun& run : comparison.runs) {
      const std::string line = text.substr(text.find("\n" + run.name + " ") + 1 + run.name.size());
      const std::vector<double> shown = numbers_in(line.substr(0, line.find('\n')));
      const auto scaled = [&](double value, const char* si) { return value_in(units, value, si); };
      std::vector<double> expected{scaled(*run.peak_force, "N"),      scaled(*run.time_of_peak_force, "s"),
                                   scaled(run.peak_penetration, "m"), scaled(run.peak_motion, "m"),
                                   scaled(*run.end_speed, "m/s"),     scaled(*run.end_time, "s")};
      if (&run != &reference) {
        expected.insert(expected.begin() + 1, 100 * (*run.peak_force / *reference.peak_force - 1));
        expected.insert(expected.end() - 1, 100 * (*run.end_speed / *reference.end_speed - 1));
      }
      ASSERT_EQ(shown.size(), expected.size()) << text;
      for (std::size_t i = 0; i < shown.size(); ++i)
        EXPECT_NEAR(shown[i], expected[i],
                    1e-4 * std::abs(expected[i]) + (shown.size() > 6 && (i == 1 || i == 6) ? 6e-3 : 0))
            << run.name << ", number " << i + 1;
      if (&run == &comparison.runs.front()) continue;
      expect_series(plot.panels.at(0), run.name, run.time, run.force);
      expect_series(plot.panels.at(1), run.name, run.time, run.penetration);
    }
  }
}

}  // namespace
}  // namespace dashpad::test
