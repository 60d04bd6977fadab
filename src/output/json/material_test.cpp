// A material test for programs.

#include "dashpad/output/materials.hpp"
#include "json/json_values.hpp"
#include "output/json/parts.hpp"

namespace dashpad::output {

namespace {

/// The request. Entries that the kind of test does not use are null.
Json request_json(const laboratory::MaterialTest& material_test) {
  const bool cyclic = material_test.kind == laboratory::TestKind::cyclic,
             creep = material_test.kind == laboratory::TestKind::creep,
             measured = material_test.kind == laboratory::TestKind::history;
  return {{"kind", to_string(material_test.kind)},
          {"strain", number_if(!creep && !measured, material_test.strain)},
          {"hold_s",
           number_if(creep || material_test.kind == laboratory::TestKind::relaxation, material_test.hold)},
          {"stress_Pa", number_if(creep, material_test.stress)},
          {"low_strain", number_if(cyclic, material_test.low)},
          {"cycles", cyclic ? Json(material_test.cycles) : Json(nullptr)},
          {"history", measured ? Json(material_test.history_name) : Json(nullptr)},
          {"history_remarks", material_test.history_remarks},
          {"stress_limits_Pa", numbers(material_test.stress_limits)},
          {"steps_of_1984", made_of(material_test.steps_of_1984, [](int steps) { return steps; })}};
}

Json point(const laboratory::CushionPoint& cushion_point) {
  return {{"strain", number(cushion_point.strain)},
          {"stress_Pa", number(cushion_point.stress)},
          {"energy_J_per_m3", number(cushion_point.energy)},
          {"efficiency", number(cushion_point.efficiency)},
          {"ideality", number(cushion_point.ideality)}};
}

Json figures(const laboratory::MaterialTestRun& run) {
  const laboratory::CushionFigures& cushion_figures = run.figures;
  return {{"peak_stress_Pa", number(cushion_figures.peak_stress)},
          {"peak_stress_strain", number(cushion_figures.strain_at_peak)},
          {"energy_in_J_per_m3", number(cushion_figures.energy_in)},
          {"energy_returned_J_per_m3", number_if(run.unloads, cushion_figures.energy_returned)},
          {"hysteresis", number_if(run.unloads, cushion_figures.hysteresis)},
          {"best_efficiency", point(cushion_figures.best_efficiency)}};
}

Json limits(const laboratory::MaterialTestReport& report, const laboratory::MaterialTestRun& run) {
  Json array = Json::array();
  for (std::size_t i = 0; i < run.at_limits.size(); ++i)
    array.push_back(
        {{"limit_Pa", number(report.test.stress_limits[i])}, {"reached", made_of(run.at_limits[i], point)}});
  return array;
}

Json relaxation(const laboratory::RelaxedStress& relaxed_stress) {
  return {{"end_of_ramp_Pa", number(relaxed_stress.at_end_of_ramp)},
          {"after_tenth_of_hold_Pa", number(relaxed_stress.after_tenth)},
          {"after_hold_Pa", number(relaxed_stress.after_hold)}};
}

Json creep_json(const laboratory::CreptStrain& crept_strain) {
  return {{"end_of_loading_strain", number(crept_strain.at_end_of_loading)},
          {"after_hold_strain", number(crept_strain.after_hold)}};
}

Json turn(const laboratory::StressAtTurn& stress_at_turn) {
  return {{"last_loading_Pa", number(stress_at_turn.last_loading)},
          {"next_Pa", number(stress_at_turn.next)},
          {"jump_Pa", number(stress_at_turn.jump())}};
}

Json update(const laboratory::UpdateOf1984& update_of1984) {
  return {{"step_s", number(update_of1984.step)},
          {"stress_discontinuity", made_of(update_of1984.update_at_turn, turn)},
          {"exact_stress_at_the_same_times", made_of(update_of1984.exact_at_turn, turn)},
          {"time_s", numbers(update_of1984.time)},
          {"strain", numbers(update_of1984.strain)},
          {"stress_Pa", numbers(update_of1984.stress)},
          {"exact_stress_Pa", numbers(update_of1984.exact)}};
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

Json event_json(const laboratory::ColumnEvent& column_event) {
  return {{"event", name_of(column_event.kind)},
          {"time_s", number(column_event.time)},
          {"strain", number(column_event.strain)},
          {"stress_before_Pa", number(column_event.stress_before)},
          {"stress_after_Pa", number(column_event.stress_after)}};
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
  const auto run = [&](const laboratory::MaterialTestRun& material_test_run) {
    return run_json(report, material_test_run);
  };
  return result_json_text({{"test", request_json(report.test)},
                           {"material", material_json(report.material)},
                           {"runs", array_of(report.runs, run)},
                           {"program", program_json()}});
}

}  // namespace dashpad::output
