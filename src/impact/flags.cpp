#include "dashpad/impact/flags.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad {

namespace {

constexpr std::array all_flags{
    FlagKind{"NOT RUN", Severity::unusable},
    FlagKind{"TOLERANCE NOT MET", Severity::unusable},
    FlagKind{"TIME LIMIT", Severity::doubtful},
    FlagKind{"PULSE CUT", Severity::doubtful},
    FlagKind{"SHEET STRUCK FLAT", Severity::doubtful},
    FlagKind{"STILL SINKING", Severity::doubtful},
    FlagKind{"ENERGY GAINED", Severity::doubtful},
    FlagKind{"PEAK ON THE WAY BACK", Severity::doubtful},
    FlagKind{"BOTTOMED", Severity::doubtful},
    FlagKind{"SERIES CUT", Severity::doubtful},
    FlagKind{"STRUCK THROUGH", Severity::doubtful},
    FlagKind{"SOFTENING", Severity::note},
    FlagKind{"EXTRAPOLATED STRAIN", Severity::doubtful},  // a guess
    FlagKind{"EXTRAPOLATED RATE", Severity::note},        // a law
    FlagKind{"EXTRAPOLATED", Severity::doubtful},
    FlagKind{"SMALL NOSE", Severity::doubtful},
    // Flags of measured pulses
    FlagKind{"IMPOSSIBLE VELOCITY CHANGE", Severity::unusable},
    FlagKind{"DROP HEIGHT IN DOUBT", Severity::doubtful},
    FlagKind{"UNLIKE SPEEDS", Severity::doubtful},
    // Flags of critical fall heights
    FlagKind{"LIMIT NOT ENCLOSED", Severity::doubtful},
    FlagKind{"FEW DROPS", Severity::doubtful},
    FlagKind{"SCATTERED DROPS", Severity::doubtful},
    FlagKind{"FIGURE MISSING", Severity::doubtful},
    FlagKind{"DROPS NOT COUNTED", Severity::doubtful},
    FlagKind{"NO CALIBRATION", Severity::note},
    // Flags of assessments
    FlagKind{"REPLACED", Severity::note},
    FlagKind{"SHORT SPIKE", Severity::doubtful},
    FlagKind{"NO INTERVALS", Severity::doubtful},
    FlagKind{"NO INTERVAL", Severity::doubtful},
    FlagKind{"UNKNOWN RANGE", Severity::doubtful},
    FlagKind{"UNVERIFIED", Severity::doubtful},
    FlagKind{"SECONDARY SOURCE", Severity::note},
    // Flags of material tests
    FlagKind{"ASSUMPTION", Severity::note},
    FlagKind{"ENERGY GAIN", Severity::doubtful},
    FlagKind{"OUT OF BOUNDS", Severity::note},
};

std::string missed_tolerance(const Summary& summary) {
  const std::string asked = std::isfinite(summary.tolerance)
                                ? fmt::format("a tolerance of {:.2g} %", 100 * summary.tolerance)
                                : "an unknown tolerance";
  return asked + " was required; the errors may be larger than estimated";
}

std::string bottoming(const Summary& summary) {
  return fmt::format("BOTTOMED at {:.5g} ms: the pad was fully compressed {}", 1e3 * summary.bottomed->time,
                     !bottomed_on_rigid_support(summary) ? "for a time, during which only the support yielded"
                     : summary.support ? "against the mass behind it, so the force then has no finite value"
                                       : "on its rigid support, so the force then has no finite value");
}

/// Share of the impact energy that counts as rounding even if the estimate is smaller.
constexpr double rounding = 1e-9;

double energy_gained(const Summary& summary) { return -summary.energy_absorbed_fraction; }

std::string gain(const Summary& summary) {
  return fmt::format(
      "the pad returned more energy than it received, by {:.2g} % of the impact energy, which no real foam "
      "does; the law does not rule it out",
      100 * energy_gained(summary));
}

std::string pushing_back(const Summary& summary) {
  return fmt::format(
      "while the nose advanced, the force reached only {:.4g} N; the pad then pushed back with a force that "
      "grew with its rate of expansion, which no real foam does: the law depends on the magnitude of the "
      "strain rate, not its sign",
      summary.force_on_way_in);
}

/// The reason why no blow follows this one.
std::string series_cut(const Summary& summary) {
  const char* const why = !summary.trustworthy()                 ? "missed the tolerance"
                          : summary.status == Status::time_limit ? "had not ended by the time limit"
                                                                 : "compressed the pad fully";
  return fmt::format(
      "blow {} of {} {}, so the state of the pad after it is not known; no further blow was computed",
      summary.blow, summary.blows, why);
}

/// The flag of a pad that did not bottom out, or of layers, struck through, in order of time; or nothing.
std::optional<Flag> striking_through(const Summary& summary) {
  const char* const name = "STRUCK THROUGH";
  if (summary.layers.empty() && !summary.bottomed && is_struck_through(summary.peak_strain, 1))
    return flag_of(name,
                   "less than a thousandth of the pad thickness was left, a compression that no foam test "
                   "reaches; do not rely on the forces and accelerations",
                   {{"peak_strain", summary.peak_strain}});
  std::vector<std::pair<double, std::size_t>> layers;
  for (std::size_t i = 0; i < summary.layers.size(); ++i)
    if (const auto& time = summary.layers[i].struck_through) layers.emplace_back(*time, i + 1);
  if (layers.empty()) return std::nullopt;
  std::ranges::sort(layers);
  std::string text;
  std::vector<FlagFigure> figures;
  for (const auto& [time, layer] : layers) {
    figures.push_back({fmt::format("layer_{}_s", layer), time});
    text += fmt::format("{}layer {} at {:.4g} ms", text.empty() ? "" : ", then ", layer, 1e3 * time);
  }
  return flag_of(name, text + "; from then on, only the rest of the pad was compressed", std::move(figures));
}

std::string softening(const Summary& summary) {
  return fmt::format(
      "the curve at {} per second falls after its yield point; a real foam may then crush layer by layer, "
      "which a column with uniform strain cannot show",
      plain_number(summary.softening_rates.front()));
}

/// Relative change of a figure below which there is no reservation.
constexpr double worth_saying = 0.01;

/// Ends of the keys of an effect's figures.
constexpr const char *lower = "_lower_fraction", *higher = "_higher_fraction";

/// Effect of a source on the decisive figure that it moves most.
struct Effect {
  std::string key;
  double down = 0, up = 0;  ///< shares of the nominal, >= 0

  [[nodiscard]] double largest() const { return std::max(down, up); }
};
Effect effect_of(Source source, const Intervals& intervals, const std::vector<std::string>& decisive) {
  Effect most;
  for (const std::string& key : decisive) {
    const FigureInterval* const figure = intervals.find(key);
    if (figure == nullptr || !(figure->nominal > 0)) continue;
    for (const Contribution& contribution : figure->sources)
      if (const Effect effect{key, 1 - contribution.low / figure->nominal,
                              contribution.high / figure->nominal - 1};
          contribution.source == source && effect.largest() > most.largest())
        most = effect;
  }
  return most;
}

std::string words_of(const std::string& key) {
  if (key.starts_with("hic_d")) return "HIC(d)";
  if (key.starts_with("hic")) return "HIC";
  if (key.ends_with("_3ms")) return "the clip";
  if (key.ends_with("_height") || key.ends_with("_speed") || key == "restitution") return "the rebound";
  if (key.ends_with("_penetration") || key.ends_with("_strain")) return "the penetration";
  return key == "severity_index" ? "the severity index" : "the peak";
}

/// "HIC may be anywhere from 1 % lower to 1.9 % higher"
std::string words_of(const Effect& effect) {
  const std::string what = words_of(effect.key) + " may be ";
  if (!std::isfinite(effect.up)) return what + "arbitrarily high";
  if (effect.down < worth_saying / 10) return what + percentage(effect.up) + " higher";
  if (effect.up < worth_saying / 10) return what + percentage(effect.down) + " lower";
  return what + "anywhere from " + percentage(effect.down) + " lower to " + percentage(effect.up) + " higher";
}

/// The flag of an extrapolation; nothing if it moves no decisive figure.
std::optional<Flag> extrapolation_flag(const Summary& summary, const Extrapolation& extrapolation,
                                       const std::vector<std::string>& decisive) {
  const std::string name = name_of(extrapolation.beyond);
  const Source source = extrapolation.beyond == Beyond::strain ? Source::continuation : Source::rate;
  const auto& intervals = summary.intervals;
  if (extrapolation.beyond == Beyond::other || !intervals || intervals->figures.empty() ||
      !intervals->find(source))
    return flag_of(name, extrapolation.text);
  const Effect effect = effect_of(source, *intervals, decisive);
  if (effect.largest() <= worth_saying) return std::nullopt;
  const std::string text =
      extrapolation.beyond == Beyond::strain
          ? "depending on the extrapolation, which is a guess, " + words_of(effect)
          : words_of(effect) + " if the rate dependence of the stress is different there";
  return flag_of(name, extrapolation.text + "; " + text,
                 {{effect.key + lower, effect.down}, {effect.key + higher, effect.up}});
}

}  // namespace

bool pulse_is_whole(const Summary& summary) {
  return summary.contact_end.has_value() || summary.rest.has_value();
}

bool bottomed_on_rigid_support(const Summary& summary) { return summary.bottomed && !summary.peak_force; }

bool is_cut(const Summary& summary) {
  return !pulse_is_whole(summary) && !bottomed_on_rigid_support(summary);
}

bool leaves_a_known_pad(const Summary& summary) {
  // The tolerance may be missed by the end of contact alone.
  const bool is_known = summary.trustworthy() || summary.errors.peak_penetration <= summary.tolerance;
  return summary.release && is_known && !summary.bottomed;
}

bool is_series_cut(const Summary& summary) {
  return summary.status != Status::not_run && summary.blow < summary.blows && !leaves_a_known_pad(summary);
}

bool gained_energy(const Summary& summary) {
  const double of_ledger = std::abs(summary.energy.residual / summary.energy.impact);
  return energy_gained(summary) > summary.errors.energy_absorbed + of_ledger + rounding;
}

const std::vector<std::string>& usual_figures() {
  static const std::vector<std::string> keys{"peak_acceleration", "hic15", "hic_unlimited"};
  return keys;
}

const char* to_string(Severity severity) {
  constexpr const char* names[]{"unusable", "doubtful", "note"};
  return names[static_cast<std::size_t>(severity)];
}

std::span<const FlagKind> flag_kinds() { return all_flags; }

Severity severity_of(std::string_view name) {
  const auto found = std::ranges::find(all_flags, name, &FlagKind::name);
  return found == all_flags.end() ? Severity::doubtful : found->severity;
}

Flag flag_of(const std::string& name, std::string_view words, std::vector<FlagFigure> figures) {
  return {name, fmt::format("{}: {}", name, words), std::move(figures)};
}

double largest_effect(const Flag& flag) {
  double largest = 0;
  for (const FlagFigure& figure : flag.figures)
    if (figure.key.ends_with(lower) || figure.key.ends_with(higher))
      largest = std::max(largest, figure.value);
  return largest;
}

std::vector<Flag> flags(const Summary& summary, const std::vector<std::string>& decisive) {
  std::vector<Flag> all;
  const auto add = [&all](const char* name, std::string_view words, std::vector<FlagFigure> figures = {}) {
    all.push_back(flag_of(name, words, std::move(figures)));
  };
  if (summary.status == Status::not_run)
    add("NOT RUN", "nothing was computed");
  else if (!summary.trustworthy())
    add("TOLERANCE NOT MET", missed_tolerance(summary), {{"tolerance", summary.tolerance}});
  if (summary.status == Status::time_limit)
    add("TIME LIMIT", "the impactor was still on the pad when the time limit was reached");
  if (summary.status != Status::not_run && is_cut(summary))
    add("PULSE CUT",
        "the pulse ends before the force has returned to zero; HIC, clips and the duration of the whole "
        "pulse are not known");
  if (summary.speed_to_sheet > 0)
    add("SHEET STRUCK FLAT",
        fmt::format("the flat nose loses {:.2g} m/s to the sheet at first contact, in a collision that does "
                    "not appear in the forces and accelerations",
                    summary.speed_to_sheet),
        {{"speed_lost_m_per_s", summary.speed_to_sheet}});
  if (summary.still_sinking)
    add("STILL SINKING",
        fmt::format("the pad is still creeping; at {:.2g} mm/s the impactor is treated as being at rest, and "
                    "its penetration and displacement are the values reached by then",
                    1e3 * summary.rest->velocity),
        {{"velocity_m_per_s", summary.rest->velocity}});
  if (gained_energy(summary))
    add("ENERGY GAINED", gain(summary), {{"energy_gained_fraction", energy_gained(summary)}});
  if (summary.force_on_way_in > 0)
    add("PEAK ON THE WAY BACK", pushing_back(summary), {{"force_on_way_in_N", summary.force_on_way_in}});
  if (summary.bottomed)
    all.push_back({"BOTTOMED",
                   bottoming(summary),
                   {{"time_s", summary.bottomed->time}, {"velocity_m_per_s", summary.bottomed->velocity}}});
  if (is_series_cut(summary))
    add("SERIES CUT", series_cut(summary),
        {{"blow", double(summary.blow)}, {"blows", double(summary.blows)}});
  if (std::optional<Flag> flag = striking_through(summary)) all.push_back(*std::move(flag));
  if (!summary.softening_rates.empty())
    add("SOFTENING", softening(summary), {{"rate_per_s", summary.softening_rates.front()}});
  const auto others = static_cast<std::ptrdiff_t>(all.size());
  for (const Extrapolation& extrapolation : summary.extrapolations)
    if (std::optional<Flag> flag = extrapolation_flag(summary, extrapolation, decisive))
      all.push_back(*std::move(flag));
  std::ranges::stable_sort(all.begin() + others, all.end(), std::greater<>(), [](const Flag& flag) {
    return flag.figures.empty() ? std::numeric_limits<double>::infinity() : largest_effect(flag);
  });
  if (summary.intervals && !summary.intervals->warning.empty())
    all.push_back({"SMALL NOSE", summary.intervals->warning});
  return all;
}

}  // namespace dashpad
