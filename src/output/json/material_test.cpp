// A material test for programs.

#include <array>

#include "dashpad/output/materials.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

/// The request. Entries that the kind of test does not use are null.
Json request_json(const laboratory::MaterialTest& test) {
  const bool cyclic = test.kind == laboratory::TestKind::cyclic,
             creep = test.kind == laboratory::TestKind::creep,
             measured = test.kind == laboratory::TestKind::history;
  return {{"kind", to_string(test.kind)},
          {"strain", number_if(!creep && !measured, test.strain)},
          {"hold_s", number_if(creep || test.kind == laboratory::TestKind::relaxation, test.hold)},
          {"stress_Pa", number_if(creep, test.stress)},
          {"low_strain", number_if(cyclic, test.low)},
          {"cycles", cyclic ? Json(test.cycles) : Json(nullptr)},
          {"history", measured ? Json(test.history_name) : Json(nullptr)},
          {"history_remarks", test.history_remarks},
          {"stress_limits_Pa", numbers(test.stress_limits)},
          {"steps_of_1984", made_of(test.steps_of_1984, [](int steps) { return steps; })}};
}

Json point(const laboratory::CushionPoint& point) {
  return {{"strain", number(point.strain)},
          {"stress_Pa", number(point.stress)},
          {"energy_J_per_m3", number(point.energy)},
          {"efficiency", number(point.efficiency)},
          {"ideality", number(point.ideality)}};
}

Json figures(const laboratory::MaterialTestRun& run) {
  const laboratory::CushionFigures& figures = run.figures;
  return {{"peak_stress_Pa", number(figures.peak_stress)},
          {"peak_stress_strain", number(figures.strain_at_peak)},
          {"energy_in_J_per_m3", number(figures.energy_in)},
          {"energy_returned_J_per_m3", number_if(run.unloads, figures.energy_returned)},
          {"hysteresis", number_if(run.unloads, figures.hysteresis)},
          {"best_efficiency", point(figures.best_efficiency)}};
}

Json limits(const laboratory::MaterialTestReport& report, const laboratory::MaterialTestRun& run) {
  Json array = Json::array();
  for (std::size_t i = 0; i < run.at_limits.size(); ++i)
    array.push_back(
        {{"limit_Pa", number(report.test.stress_limits[i])}, {"reached", made_of(run.at_limits[i], point)}});
  return array;
}

Json relaxation(const laboratory::RelaxedStress& relaxed) {
  return {{"end_of_ramp_Pa", number(relaxed.at_end_of_ramp)},
          {"after_tenth_of_hold_Pa", number(relaxed.after_tenth)},
          {"after_hold_Pa", number(relaxed.after_hold)}};
}

Json creep_json(const laboratory::CreptStrain& crept) {
  return {{"end_of_loading_strain", number(crept.at_end_of_loading)},
          {"after_hold_strain", number(crept.after_hold)}};
}

Json turn(const laboratory::StressAtTurn& turn) {
  return {{"last_loading_Pa", number(turn.last_loading)},
          {"next_Pa", number(turn.next)},
          {"jump_Pa", number(turn.jump())}};
}

Json update(const laboratory::UpdateOf1984& update) {
  return {{"step_s", number(update.step)},
          {"stress_discontinuity", made_of(update.update_at_turn, turn)},
          {"exact_stress_at_the_same_times", made_of(update.exact_at_turn, turn)},
          {"time_s", numbers(update.time)},
          {"strain", numbers(update.strain)},
          {"stress_Pa", numbers(update.stress)},
          {"exact_stress_Pa", numbers(update.exact)}};
}

Json event_json(const laboratory::ColumnEvent& event) {
  constexpr std::array names{"turned", "reloaded", "contact lost", "contact taken up"};
  return {{"event", names.at(static_cast<std::size_t>(event.kind))},
          {"time_s", number(event.time)},
          {"strain", number(event.strain)},
          {"stress_before_Pa", number(event.stress_before)},
          {"stress_after_Pa", number(event.stress_after)}};
}

Json run_json(const laboratory::MaterialTestReport& report, const laboratory::MaterialTestRun& run) {
  const laboratory::ColumnTest& column = run.column;
  const laboratory::CushionCurve& cushion = run.cushion;
  return {{"rate_per_s", number(run.rate)},
          {"figures", figures(run)},
          {"stress_limits", limits(report, run)},
          {"relaxation", made_of(run.relaxed, relaxation)},
          {"creep", made_of(run.crept, creep_json)},
          {"update_of_1984", made_of(run.update_of_1984, update)},
          {"flags", flags_json(run.flags)},
          {"events", array_of(column.events, event_json)},
          {"errors",
           {{"stress_fraction_of_peak", number(column.stress_error)},
            {"energy_fraction_of_energy_in", number(run.figures.energy_error)}}},
          {"column",
           {{"time_s", numbers(column.time)},
            {"strain", numbers(column.strain)},
            {"strain_rate_per_s", numbers(column.rate)},
            {"stress_Pa", numbers(column.stress)},
            {"work_J_per_m3", numbers(column.work)}}},
          {"first_loading",
           {{"strain", numbers(cushion.strain)},
            {"largest_stress_Pa", numbers(cushion.stress)},
            {"energy_J_per_m3", numbers(cushion.energy)},
            {"efficiency", numbers(cushion.efficiency)},
            {"ideality", numbers(cushion.ideality)}}}};
}

}  // namespace

std::string material_test_json(const laboratory::MaterialTestReport& report) {
  const auto run = [&](const laboratory::MaterialTestRun& each) { return run_json(report, each); };
  return result_json_text({{"test", request_json(report.test)},
                           {"material", material_json(report.material)},
                           {"runs", array_of(report.runs, run)},
                           {"program", program_json()}});
}

}  // namespace dashpad::output
