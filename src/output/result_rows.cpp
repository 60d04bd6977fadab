#include "output/result_rows.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/version.hpp"
#include "quantities/text.hpp"
#include "result/summary_values.hpp"

namespace dashpad::output {

namespace {

std::string bottomed_flag(const Summary& summary, const UnitSystem& units) {
  const Moment& moment = *summary.bottomed;
  return fmt::format("BOTTOMED at {} with the impactor still moving at {}{}",
                     brief_quantity(moment.time, "s", units), brief_quantity(moment.velocity, "m/s", units),
                     bottomed_on_rigid_support(summary) ? "; the figures cover the time until then"
                                                        : "; during bottoming, only the support yielded");
}

/// Close to full compression the rounded percentage would look like bottoming: there, what is left is said.
std::string part_of_pad(double penetration, double thickness, int digits) {
  const double left = 1 - penetration / thickness;
  return left > 0 && left < 5e-5 ? fmt::format("all but {} of the pad", percentage(left))
                                 : fmt::format("{} % of the pad", significant(100 * (1 - left), digits));
}

/// A note that an elastic rebound is an assumption, not a finding.
std::string loss_words(const Pad& pad) {
  const auto is_free = [](const Material& material) {
    const auto* const foam = std::get_if<Foam>(&material.law);
    return foam != nullptr && is_without_loss(*foam);
  };
  const bool all = pad.layers.empty() ? is_free(pad.material)
                                      : std::ranges::all_of(pad.layers, is_free, &PadLayer::material);
  return all ? "; no loss is specified for the pad" : "";
}

std::string remark_on(const std::string& key, const ImpactCase& impact, const Summary& summary,
                      const UnitSystem& units, int digits) {
  if (key == "peak_penetration") return part_of_pad(summary.peak_penetration, impact.pad.thickness, digits);
  if (key == "peak_motion") return "pad and support together";
  if (key.starts_with("peak_strain"))
    return impact.pad.layers.empty() ? "on the axis" : "of the whole pad, on the axis";
  if (key == "rebound_speed" && summary.restitution && summary.release && summary.release->velocity > 0 &&
      summary.support && summary.support->body_speed)
    return "continues forward at " + brief_quantity(summary.release->velocity, "m/s", units, digits) +
           "; restitution " + significant(*summary.restitution, digits) + loss_words(impact.pad);
  if (key == "rebound_speed" && summary.restitution)
    return "restitution " + significant(*summary.restitution, digits) + loss_words(impact.pad);
  if (key == "contact_end") return fmt::format("force below {} of its peak", percentage(contact_end_share));
  if (key == "force_below_weight")
    return (summary.force_below_weight->velocity > 0 ? "continuing forward at " : "rebounding at ") +
           brief_quantity(std::abs(summary.force_below_weight->velocity), "m/s", units, digits);
  if (key == "energy_absorbed_fraction")
    return fmt::format("of the impact energy, {}",
                       brief_quantity(summary.energy.impact, "J", units, digits)) +
           (summary.energy.weight > 0.1 * summary.energy.impact
                ? fmt::format("; gravity adds {}", brief_quantity(summary.energy.weight, "J", units, digits))
                : "");
  return "";
}

/// Largest strain of each layer on the axis.
void add_layers(std::vector<ValueRow>& rows, const Pad& pad, const Summary& summary, int digits) {
  for (std::size_t i = 0; i < summary.layers.size(); ++i) {
    const Material& material = pad.layers[i].material;
    const auto tested = range_of(material);
    std::string remark = one_line(material.name);
    if (tested) remark += fmt::format(", tested up to {}", brief(tested->highest_strain));
    remark += fmt::format("; strain rate up to {} 1/s", brief(summary.layers[i].peak_strain_rate, digits));
    rows.push_back({.key = fmt::format("layer_{}_peak_strain", i + 1),
                    .label = fmt::format("Peak strain in layer {}", i + 1),
                    .value = significant(summary.layers[i].peak_strain, digits),
                    .remark = remark});
  }
}

/// 0 for what is 0 up to rounding, compared with the whole.
double without_rounding(double part, double whole) { return std::abs(part) < 1e-9 * whole ? 0 : part; }

ValueRow row_of(const ResultQuantity& quantity, double value, const UnitSystem& units, int digits) {
  const bool is_share = quantity.key == std::string_view{"energy_absorbed_fraction"};
  const ScaledUnit shown = is_share ? ScaledUnit{100, "%"} : shown_as(quantity.si_unit, units);
  if (is_share) value = without_rounding(value, 1);
  return {.key = quantity.key,
          .label = quantity.title,
          .value = significant(shown.scale * value, digits),
          .unit = shown.unit};
}

/// The rows of a summary in the order of the text, beginning with those that designers ask for first.
const std::vector<const SummaryQuantity*>& rows_of_summary() {
  static const std::vector<const SummaryQuantity*> all = [] {
    std::vector<const SummaryQuantity*> rows;
    for (const SummaryQuantity& entry : summary_quantities())
      if (entry.quantity->role.row > 0) rows.push_back(&entry);
    std::ranges::sort(rows, {}, [](const SummaryQuantity* entry) { return entry->quantity->role.row; });
    return rows;
  }();
  return all;
}

/// `length` is that of the pulse, s.
std::string remark_on(const injury::InjuryValue& figure, double length, const UnitSystem& units, int digits) {
  const std::string key = figure.quantity->key;
  if (key == "hic_d") return "from HIC36";
  if (key == "severity_index") return "as defined by Gadd";
  if (figure.time) return "at " + brief_quantity(without_rounding(*figure.time, length), "s", units, digits);
  const std::string kind = key == "clip_3ms" ? "uninterrupted" : key == "cumulative_3ms" ? "in total" : "";
  if (!figure.begin || (*figure.end <= *figure.begin && !kind.empty())) return kind;
  return (kind.empty() ? "" : kind + ", ") + stretch(*figure.begin, *figure.end, units, digits);
}

/// Whether two searches have found one window: as far as people can see, and beyond rounding.
bool is_same(const injury::InjuryValue& a, const injury::InjuryValue& b) {
  if (!a.begin || !b.begin) return false;
  const double close = 1e-3 * (*a.end - *a.begin);
  return std::abs(a.value - b.value) <= 1e-6 * a.value && std::abs(*a.begin - *b.begin) <= close &&
         std::abs(*a.end - *b.end) <= close;
}

std::string tolerance_text(const Summary& summary) {
  return fmt::format("{} tolerance of {} for peak forces, distances and rebound",
                     summary.trustworthy() ? "to a" : "without meeting the", percentage(summary.tolerance));
}

/// The end of a completed run.
std::string end_of_contact(const Summary& summary) {
  if (summary.release && summary.support && summary.support->body_speed && summary.release->velocity > 0)
    return "The impactor left the pad but is still moving forward, more slowly than the body behind the pad.";
  return pulse_is_whole(summary) ? "The impactor rebounded and left the pad."
                                 : "The pad stopped the impactor without pushing it back.";
}

std::string duration(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

}  // namespace

std::string outcome(const Summary& summary) {
  switch (summary.status) {
    case Status::released: return end_of_contact(summary);
    case Status::at_rest: return "The impactor came to rest on the pad.";
    case Status::bottomed_out:
      return fmt::format("The pad bottomed out {}; from then on the force has no finite value.",
                         summary.support ? "against the mass behind it" : "on its rigid support");
    case Status::time_limit: return "The impactor was still on the pad when the time limit was reached.";
    case Status::tolerance_not_met:
      return summary.release ? end_of_contact(summary)
                             : "The computation stopped before the impactor left the pad.";
    case Status::not_run: return "Nothing was computed.";
  }
  return "";
}

std::vector<std::string> warnings(const Summary& summary, const UnitSystem& units) {
  std::vector<Flag> all = flags(summary);
  std::erase_if(all, [](const Flag& flag) { return flag.name == "NOT RUN"; });
  for (Flag& flag : all)
    if (flag.name == "BOTTOMED") flag.text = bottomed_flag(summary, units);
  return by_severity(std::move(all));
}

std::vector<ValueRow> summary_rows(const ImpactCase& impact, const Summary& summary, const UnitSystem& units,
                                   Detail detail) {
  std::vector<ValueRow> rows;
  if (summary.status == Status::not_run) return rows;
  const int digits = digits_of(detail);
  for (const SummaryQuantity* entry : rows_of_summary()) {
    const ResultQuantity& quantity = *entry->quantity;
    const std::string key = quantity.key;
    const EstimatedValue estimate = entry->of(summary);
    const bool is_penetration = key == "peak_motion" && impact.support.is_rigid() && !summary.support;
    if (is_penetration || (detail == Detail::main && !quantity.role.is_main)) continue;
    if (key == "peak_force" && std::isnan(estimate.value))
      rows.push_back({.key = key,
                      .label = quantity.title,
                      .value = "none",
                      .remark = "not finite once the pad is fully compressed"});
    if (std::isnan(estimate.value)) continue;
    rows.push_back(row_of(quantity, estimate.value, units, digits));
    if (quantity.has_estimate()) rows.back().error = estimate.error;
    rows.back().remark = remark_on(key, impact, summary, units, digits);
  }
  add_layers(rows, impact.pad, summary, digits);
  return rows;
}

std::vector<ValueRow> pulse_rows(const injury::InjuryFigures& figures, const UnitSystem& units,
                                 Detail detail) {
  const int digits = digits_of(detail);
  std::vector<ValueRow> rows;
  const injury::InjuryValue* before = nullptr;
  const auto values = injury::injury_values(figures);
  const double length = figures.hic_unlimited.end - figures.hic_unlimited.begin;
  std::string same;
  for (const injury::InjuryValue& figure : values) {
    const ResultQuantity& quantity = *figure.quantity;
    if (detail == Detail::main && !quantity.role.is_main) continue;
    const bool is_clip = std::string_view{quantity.key}.ends_with("_3ms");
    if (detail == Detail::main && figure.value == 0 && is_clip) continue;  // a pulse shorter than 3 ms
    if (detail == Detail::main && before != nullptr && is_same(figure, *before)) {
      same +=
          std::string(same.empty() ? "" : " and ") + (is_clip ? "the " : "") + title_in_sentence(quantity);
      rows.back().remark = stretch(*figure.begin, *figure.end, units, digits) + "; the same for " + same;
      continue;
    }
    same.clear();
    before = &figure;
    rows.push_back(row_of(quantity, figure.value, units, digits));
    if (figure.error > 0) rows.back().error = figure.error;
    rows.back().remark = remark_on(figure, length, units, digits);
  }
  return rows;
}

std::vector<ValueRow> main_rows(const ImpactCase& impact, const Summary& summary,
                                const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units) {
  std::vector<ValueRow> rows = summary_rows(impact, summary, units, Detail::main);
  if (!injury) return rows;
  std::vector<ValueRow> all = pulse_rows(*injury, units, Detail::main);
  std::erase_if(all, [](const ValueRow& row) { return row.key == "velocity_change"; });
  std::erase_if(rows, [](const ValueRow& row) { return row.key == "peak_acceleration"; });
  all.insert(all.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
  return all;
}

std::vector<ValueRow> bottoming_figures(const ImpactCase& impact, const Summary& summary,
                                        const UnitSystem& units) {
  if (!summary.bottomed) return {};
  const auto shown = [&](double value, const char* unit) { return brief_quantity(value, unit, units, 3); };
  return {{.label = "Speed when the pad bottomed out",
           .value = shown(summary.bottomed->velocity, "m/s"),
           .remark = "after " + shown(summary.bottomed->time, "s")},
          {.label = "Impact speed", .value = shown(impact.impactor.speed, "m/s")}};
}

std::string stretch(double begin, double end, const UnitSystem& units, int digits) {
  const double length = end - begin;
  return fmt::format("from {} to {}", brief(value_in(units, without_rounding(begin, length), "s"), digits),
                     brief_quantity(without_rounding(end, length), "s", units, digits));
}

std::string numbers_text(const Summary& summary) {
  const std::string stations = summary.stations > 0 ? fmt::format("{} sampling points", summary.stations)
                                                    : "contact force in closed form";
  return fmt::format("{}: {} steps, {}, {} runs, {}", tolerance_text(summary), summary.steps, stations,
                     summary.runs, duration(summary.wall_time));
}

}  // namespace dashpad::output
