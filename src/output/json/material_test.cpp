// A material test for programs.

#include "dashpad/output/materials.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

/// Null for what the kind of test has no use for.
Json request_json(const laboratory::MaterialTest& of) {
  const bool cyclic = of.kind == laboratory::TestKind::cyclic, creep = of.kind == laboratory::TestKind::creep,
             measured = of.kind == laboratory::TestKind::history;
  return {{"kind", to_string(of.kind)},
          {"strain", number_if(!creep && !measured, of.strain)},
          {"hold_s", number_if(creep || of.kind == laboratory::TestKind::relaxation, of.hold)},
          {"stress_Pa", number_if(creep, of.stress)},
          {"low_strain", number_if(cyclic, of.low)},
          {"cycles", cyclic ? Json(of.cycles) : Json(nullptr)},
          {"history", measured ? Json(of.history_name) : Json(nullptr)},
          {"history_remarks", of.history_remarks},
          {"stress_limits_Pa", numbers(of.stress_limits)},
          {"steps_of_1984", made_of(of.steps_of_1984, [](int steps) { return steps; })}};
}

Json point(const laboratory::CushionPoint& of) {
  return {{"strain", number(of.strain)},
          {"stress_Pa", number(of.stress)},
          {"energy_J_per_m3", number(of.energy)},
          {"efficiency", number(of.efficiency)},
          {"ideality", number(of.ideality)}};
}

Json figures(const laboratory::MaterialTestRun& run) {
  const laboratory::CushionFigures& of = run.figures;
  return {{"peak_stress_Pa", number(of.peak_stress)},
          {"peak_stress_strain", number(of.strain_at_peak)},
          {"energy_in_J_per_m3", number(of.energy_in)},
          {"energy_returned_J_per_m3", number_if(run.unloads, of.energy_returned)},
          {"hysteresis", number_if(run.unloads, of.hysteresis)},
          {"best_efficiency", point(of.best_efficiency)}};
}

Json limits(const laboratory::MaterialTestReport& report, const laboratory::MaterialTestRun& run) {
  Json array = Json::array();
  for (std::size_t i = 0; i < run.at_limits.size(); ++i)
    array.push_back(
        {{"limit_Pa", number(report.test.stress_limits[i])}, {"reached", made_of(run.at_limits[i], point)}});
  return array;
}

Json relaxation(const laboratory::RelaxedStress& of) {
  return {{"end_of_ramp_Pa", number(of.at_end_of_ramp)},
          {"after_tenth_of_hold_Pa", number(of.after_tenth)},
          {"after_hold_Pa", number(of.after_hold)}};
}

Json creep_json(const laboratory::CreptStrain& of) {
  return {{"end_of_loading_strain", number(of.at_end_of_loading)},
          {"after_hold_strain", number(of.after_hold)}};
}

Json turn(const laboratory::StressAtTurn& of) {
  return {{"last_loading_Pa", number(of.last_loading)},
          {"next_Pa", number(of.next)},
          {"jump_Pa", number(of.jump())}};
}

Json update(const laboratory::UpdateOf1984& of) {
  return {{"step_s", number(of.step)},
          {"stress_discontinuity", made_of(of.update_at_turn, turn)},
          {"exact_stress_at_the_same_times", made_of(of.exact_at_turn, turn)},
          {"time_s", numbers(of.time)},
          {"strain", numbers(of.strain)},
          {"stress_Pa", numbers(of.stress)},
          {"exact_stress_Pa", numbers(of.exact)}};
}

const char* name_of(laboratory::ColumnEvent::Kind kind) {
  switch (kind) {
    case laboratory::ColumnEvent::Kind::turned: return "turned";
    case laboratory::ColumnEvent::Kind::reloaded: return "reloaded";
    case laboratory::ColumnEvent::Kind::contact_lost: return "contact lost";
    case laboratory::ColumnEvent::Kind::contact_taken_up: return "contact taken up";
  }
  return "";
}

Json event_json(const laboratory::ColumnEvent& of) {
  return {{"event", name_of(of.kind)},
          {"time_s", number(of.time)},
          {"strain", number(of.strain)},
          {"stress_before_Pa", number(of.stress_before)},
          {"stress_after_Pa", number(of.stress_after)}};
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
  const auto run = [&](const laboratory::MaterialTestRun& of) { return run_json(report, of); };
  return result_json_text({{"test", request_json(report.test)},
                           {"material", material_json(report.material)},
                           {"runs", array_of(report.runs, run)},
                           {"program", program_json()}});
}

}  // namespace dashpad::output
