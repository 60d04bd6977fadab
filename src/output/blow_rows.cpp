#include "output/result_rows.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <variant>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double peak_in_g(const BlowResult& blow) {
  return blow.summary.peak_acceleration.value_or(none) / standard_gravity;
}
double hic15(const BlowResult& blow) { return blow.injury ? blow.injury->hic15.value : none; }

/// "61.2 g, 71 % above"
std::string with_change(double from, double to, const std::string& unit) {
  const double tenths = std::round(1000 * (to / from - 1));
  return fmt::format("{}{}, {} % {}", brief(to, 3), unit, brief(std::abs(tenths) / 10, 2),
                     tenths < 0 ? "lower" : "higher");
}

std::string why_alike(const PadLaw& law) {
  if (blow_memory(law) != BlowMemory::none) return "the pad recovers fully between blows";
  return "according to the " + name_of(law) + " law, the pad recovers fully" +
         (std::holds_alternative<Elastic>(law) ? ""
                                               : ", if the pauses are much longer than its relaxation time");
}

std::string header(const char* key, const std::string& unit) {
  return result_quantity(key).title + (unit.empty() ? "" : ", " + unit);
}

}  // namespace

std::vector<BlowResult> blow_results(std::span<const Blow> blows) {
  std::vector<BlowResult> results;
  for (const Blow& blow : blows)
    results.push_back({blow.solution.summary, injury::whole_pulse_figures(blow.solution),
                       blow.impact.pad.earlier_penetration});
  return results;
}

std::string growth_text(const ImpactCase& impact, const std::vector<BlowResult>& blows) {
  const BlowResult& first = blows.front();
  const BlowResult& last = blows.back();
  const int asked = first.summary.blows;
  if (blows.size() == 1) return fmt::format("Only the first of {} blows could be computed.", asked);
  if (first.earlier_penetration == last.earlier_penetration &&
      first.summary.peak_force == last.summary.peak_force)
    return fmt::format("All {} blows are identical: {}.", blows.size(), why_alike(impact.pad.material.law));
  std::string text = fmt::format("Blow {} ", blows.size());
  if (std::isnan(peak_in_g(last)))
    text += fmt::format("has no finite peak; blow 1 peaks at {} g", brief(peak_in_g(first), 3));
  else
    text += "peaks at " + with_change(peak_in_g(first), peak_in_g(last), " g") + " than blow 1";
  if (first.injury && last.injury) text += "; its HIC15 is " + with_change(hic15(first), hic15(last), "");
  return text + ".";
}

std::vector<std::string> reservations(const std::vector<BlowResult>& blows) {
  std::map<std::string, std::string> blows_with;
  for (const BlowResult& blow : blows) {
    Summary summary = blow.summary;
    summary.intervals = blows.back().summary.intervals;  // only the last blow has its own
    std::set<std::string> names;
    for (const Flag& flag : flags(summary)) names.insert(flag.name);
    for (const std::string& name : names) {
      std::string& list = blows_with[name];
      list += (list.empty() ? "" : ", ") + std::to_string(blow.summary.blow);
    }
  }
  // The flags of the last blow are listed with its figures.
  for (const Flag& flag : flags(blows.back().summary)) blows_with.erase(flag.name);
  std::vector<std::string> lines;
  for (const auto& [name, list] : blows_with)
    lines.push_back(
        fmt::format("{}: {} {}", name, list.find(',') == std::string::npos ? "blow" : "blows", list));
  return lines;
}

Table blow_table(const ImpactCase& impact, const std::vector<BlowResult>& blows, const UnitSystem& units,
                 Detail detail) {
  const int digits = digits_of(detail);
  const ScaledUnit acceleration = shown_as("m/s2", units);
  const ScaledUnit force = shown_as("N", units);
  const ScaledUnit length = shown_as("m", units);
  Table table;
  table.columns = {"Blow",
                   header("peak_acceleration", acceleration.unit),
                   header("hic15", ""),
                   header("peak_force", force.unit),
                   header("penetration", length.unit),
                   "% of pad",
                   header("energy_absorbed_fraction", "%")};
  for (const BlowResult& blow : blows) {
    const Summary& summary = blow.summary;
    const auto shown = [&](double value) { return std::isnan(value) ? "none" : significant(value, digits); };
    table.rows.push_back({std::to_string(summary.blow),
                          shown(acceleration.scale * summary.peak_acceleration.value_or(none)),
                          shown(hic15(blow)), shown(force.scale * summary.peak_force.value_or(none)),
                          shown(length.scale * summary.peak_penetration),
                          shown(100 * summary.peak_penetration / impact.pad.thickness),
                          shown(100 * summary.energy_absorbed_fraction)});
  }
  return table;
}

}  // namespace dashpad::output
