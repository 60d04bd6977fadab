#include "dashpad/spit1984/run_files.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "json/json_values.hpp"

namespace dashpad::spit1984 {

namespace {

Json defects_json(const Defects& of) {
  Json table = Json::object();
  for (const Defect& defect : defects) table[defect.name] = of.*defect.present ? "as printed" : "mended";
  return table;
}

Json abend_json(const Run& run) {
  if (run.abend == Abend::none) return nullptr;
  const AbendText text = text_of(run.abend);
  return {{"number", static_cast<int>(run.abend)},
          {"message", text.message},
          {"advice", text.advice},
          {"speed_error", run.speed_error ? number(*run.speed_error) : Json(nullptr)}};
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
                    {"most_stations", run.most_stations},
                    {"trials", run.trials},
                    {"halvings", run.halvings},
                    {"settings",
                     {{"most_steps", settings.most_steps},
                      {"most_stations", settings.most_stations},
                      {"most_iterations", settings.most_iterations},
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
