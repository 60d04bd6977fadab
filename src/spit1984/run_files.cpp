#include "dashpad/spit1984/run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "json/json_values.hpp"
#include "spit1984/fortran_format.hpp"

namespace dashpad::spit1984 {

namespace {

// Each function below is one FORMAT statement of subroutine SPIT, or a few that always follow each other.

/// 608 to 612. After ABEND 904 the listing runs into its END and prints nothing more; but according to the
/// user's guide (report, Appendix A.4) printing continues after every ABEND. We follow the guide.
void print_abend(PrintedRecords& out, const Run& run, Device device) {
  const bool terminal = device == Device::terminal;
  switch (run.abend) {
    case Abend::none: return;
    case Abend::too_many_iterations: out.text("0ABEND - TOO MANY ITERATIONS").end_record(); return;
    case Abend::bisection_failed: out.text("0ABEND - BISECTION FAILED").end_record(); return;
    case Abend::too_many_time_steps: out.text("0ABEND - TOO MANY TIME STEPS").end_record(); return;
    case Abend::rate_sensitive_instability:
      if (terminal)
        out.text("0ABEND - RATE-SENSITIVE INSTABILITY - SPEED ERROR=")
            .e(run.speed_error.value_or(0), 10, 3)
            .end_record();
      return;
    case Abend::too_many_contact_divisions:
      if (terminal) out.text("0ABEND - TOO MANY CONTACT DIVISIONS").end_record();
      return;
  }
}

void print_sphere_and_pad(PrintedRecords& out, const Deck& deck, const Run& run) {  // 601
  out.text("0SPHERE PARMS:").end_record();
  out.text("0RADIUS=").skip(12).e(deck.radius_in, 10, 3).text(" INCHES").end_record();
  out.text(" WEIGHT=").skip(12).e(deck.weight_lb, 10, 3).text(" LBS").end_record();
  out.text("0INITIAL SPEED=").skip(5).e(deck.speed_mph, 10, 3).text(" MPH").end_record();
  out.text(" REBOUND SPEED=").skip(5).e(run.rebound_speed_mph, 10, 3).text(" MPH").end_record();
  out.text("0PAD MATL TYPE=").skip(10).i(static_cast<int>(deck.pad), 5).end_record();
  out.text(" THICKNESS=").skip(9).e(deck.thickness_in, 10, 3).text(" INCHES").end_record();
  out.text(" PROPERTIES=").end_record();
}

void print_pad_parameters(PrintedRecords& out, const Deck& deck) {  // 602: eight to a line
  constexpr std::size_t on_a_line = 8;
  for (std::size_t index = 0; index < deck.pad_parameters.size(); ++index) {
    if (index % on_a_line == 0) out.skip(1);
    out.e(deck.pad_parameters[index], 15, 3);
    if (index % on_a_line == on_a_line - 1 || index + 1 == deck.pad_parameters.size()) out.end_record();
  }
}

void print_support(PrintedRecords& out, const Deck& deck, const Run& run) {  // 603, 604, 605
  out.text("0SUPPORT TYPE=").skip(11).i(deck.support, 5).end_record();
  out.text(" X= ");
  for (std::size_t index = 0; index < 8; index += 2) out.e(deck.support_parameters[index], 15, 3);
  out.end_record().text(" F= ");
  for (std::size_t index = 1; index < 8; index += 2) out.e(deck.support_parameters[index], 15, 3);
  out.end_record().text(" K= ");
  for (const double stiffness : run.tangent_stiffness_lb_per_in) out.e(stiffness, 15, 3);
  out.end_record();
}

void print_impact(PrintedRecords& out, const Deck& deck, const Run& run) {  // 606, first page
  out.text("0INITIAL DELTA-T=").skip(3).e(deck.time_step_ms, 10, 3).text(" MS").end_record();
  out.text(" IMPACT DURATION=").skip(3).e(run.duration_ms, 10, 3).text(" MS").end_record();
  out.text(" TIME TO PEAK FORCE=").e(run.time_of_peak_force_ms, 10, 3).text(" MS").end_record();
  out.text(" PEAK FORCE=").skip(8).e(run.peak_force_lb, 10, 3).text(" LB").end_record();
}

void print_heading(PrintedRecords& out) {  // 606, second page
  out.text("1RUN SUMMARY").end_record();
  out.text("0").skip(6).text("TIME (MS)").skip(5).text("FORCE (LB)").skip(6).text("ACCEL (G)");
  out.skip(4).text("SPEED (IPS)").skip(4).text("MOTION (IN)").skip(4).text("PENETR (IN)").end_record();
  out.end_record();
}

void print_step(PrintedRecords& out, const Step& step) {  // 607
  out.skip(1).e(step.time_ms, 15, 3).e(step.force_lb, 15, 3).e(step.acceleration_g, 15, 3);
  out.e(step.speed_in_per_s, 15, 3).e(step.motion_in, 15, 3).e(step.penetration_in, 15, 3).end_record();
}

/// Prints every NDEL-th step from first contact up to NDEL before the end, then all of the last NDEL steps:
/// the loops that end at the labels 270 and 290. Steps in between are not printed. In a run of fewer steps
/// than NDEL the listing's second loop begins outside the history; in that case, and if NDEL is not positive,
/// we print all steps.
void print_history(PrintedRecords& out, const Deck& deck, const Run& run) {
  const long steps = static_cast<long>(run.history.size());
  const long interval = std::max(deck.print_interval, 1);
  const long last_group = std::max(steps - interval, 0L);
  for (long step = 0; step < last_group; step += interval)
    print_step(out, run.history[static_cast<std::size_t>(step)]);
  for (long step = last_group; step < steps; ++step)
    print_step(out, run.history[static_cast<std::size_t>(step)]);
}

Json defects_json(const Defects& given) {
  Json table = Json::object();
  for (const Defect& defect : defects) table[defect.name] = given.*defect.present ? "as printed" : "mended";
  return table;
}

Json abend_json(const Run& run) {
  if (run.abend == Abend::none) return nullptr;
  const AbendText text = text_of(run.abend);
  return {{"number", static_cast<int>(run.abend)},
          {"message", text.message},
          {"advice", text.advice},
          {"speed_error", number(run.speed_error)}};
}

Json precision_stops_json(const Run& run) {
  Json list = Json::array();
  for (const PrecisionStop& stop : run.precision_stops)
    list.push_back(
        {{"step", stop.step}, {"force_lbf", number(stop.force_lb)}, {"error", number(stop.error)}});
  return list;
}

Json deck_json(const Deck& deck) {
  return {{"RAD_in", deck.radius_in},     {"VIN_mph", deck.speed_mph},
          {"WGT_lbf", deck.weight_lb},    {"KEYP", static_cast<int>(deck.pad)},
          {"PPAR", deck.pad_parameters},  {"THK_in", deck.thickness_in},
          {"KEYS", deck.support},         {"SPAR", deck.support_parameters},
          {"DELT_ms", deck.time_step_ms}, {"NDEL", deck.print_interval}};
}

}  // namespace

std::string listing(const Deck& deck, const Run& run, Device device) {
  PrintedRecords out;
  out.text("1SPHERE/PAD IMPACT TRACKER").end_record().end_record();  // 6000
  if (device == Device::terminal)
    for (const PrecisionStop& stop : run.precision_stops) {  // 613
      out.text("0STEP").i(stop.step, 5).text(" FORCE=").e(stop.force_lb, 10, 3);
      out.text(" ERROR=").e(stop.error, 10, 3).end_record();
    }
  print_abend(out, run, device);
  print_sphere_and_pad(out, deck, run);
  print_pad_parameters(out, deck);
  print_support(out, deck, run);
  print_impact(out, deck, run);
  print_heading(out);
  print_history(out, deck, run);
  return out.printed();
}

std::string run_json(const Deck& deck, const Settings& settings, const Run& run) {
  const Json result{{"program", "SPIT/PAD Version 2, December 1984"},
                    {"arithmetic", to_string(settings.arithmetic)},
                    {"defects", defects_json(settings.defects)},
                    {"peak_force_lbf", number(run.peak_force_lb)},
                    {"time_of_peak_force_ms", number(run.time_of_peak_force_ms)},
                    {"rebound_speed_mph", number(run.rebound_speed_mph)},
                    {"duration_ms", number(run.duration_ms)},
                    {"abend", abend_json(run)},
                    {"precision_stops", precision_stops_json(run)},
                    {"steps", run.history.size()},
                    {"most_stations", run.max_stations},
                    {"trials", run.trials},
                    {"halvings", run.halvings},
                    {"settings",
                     {{"most_steps", settings.max_steps},
                      {"most_stations", settings.max_stations},
                      {"most_iterations", settings.max_iterations},
                      {"equilibrium_tolerance", settings.equilibrium_tolerance},
                      {"precision_tolerance", settings.precision_tolerance}}},
                    {"deck", deck_json(deck)},
                    {"dashpad", {{"version", version()}, {"commit", build_facts().git_commit}}}};
  return result_json_text(result);
}

std::string run_csv(const Run& run) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "time_ms,force_lbf,acceleration_g,speed_in_per_s,motion_in,penetration_in\n");
  for (const Step& step : run.history) {
    const char* separator = "";
    for (const double value : {step.time_ms, step.force_lb, step.acceleration_g, step.speed_in_per_s,
                               step.motion_in, step.penetration_in}) {
      fmt::format_to(out, "{}", separator);
      if (std::isfinite(value)) fmt::format_to(out, "{}", value);
      separator = ",";
    }
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

}  // namespace dashpad::spit1984
