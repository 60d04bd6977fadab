#include "dashpad/output/text/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "model/parameter_values.hpp"
#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// `mass 4.5 kg, radius 76.2 mm and half angle 30 deg`
std::string impactor_text(const Impactor& impactor, const UnitSystem& units) {
  std::string text = "mass " + brief_quantity(impactor.mass, "kg", units);
  if (const auto* profile = std::get_if<Profile>(&impactor.nose)) {
    const Profile::Point& last = profile->points.back();
    const bool by_radius = profile->of == Profile::Of::radius;
    return text + fmt::format(" and {} points (up to {} of {} at a depth of {})", profile->points.size(),
                              by_radius ? "a radius" : "an area",
                              brief_quantity(profile->scaled_size(last), by_radius ? "m" : "m2", units),
                              brief_quantity(profile->scale * last.depth, "m", units));
  }
  const std::vector<ParameterValue> numbers = parameter_values(impactor.nose);
  for (const ParameterValue& number : numbers) {
    std::string key = number.key;
    std::ranges::replace(key, '_', ' ');
    text += fmt::format("{} {} {}", &number == &numbers.back() ? " and" : ",", key,
                        brief_quantity(number.value, number.unit, units));
  }
  return text;
}

std::string profile_in_si(const Profile& profile) {
  const bool by_radius = profile.of == Profile::Of::radius;
  std::string points;
  for (const Profile::Point& point : profile.points)
    points += fmt::format("{}{} {} at {} m", points.empty() ? "" : ", ", point.size, by_radius ? "m" : "m2",
                          point.depth);
  return fmt::format("  impactor.{} = {}\n", by_radius ? "radii" : "areas", points);
}

/// `vn600 (foam law)`
std::string foam_text(const Material& material) {
  return fmt::format("{} ({} law)", one_line(material.name), name_of(material.law));
}

/// `vn600 (foam law), 45 mm thick`, or all layers from the struck face on.
std::string pad_text(const Pad& pad, const UnitSystem& units) {
  const std::string thickness = brief_quantity(pad.thickness, "m", units);
  if (pad.layers.empty()) return fmt::format("{}, {} thick", foam_text(pad.material), thickness);
  std::string text = pad.layers.size() == 1 ? "1 layer" : fmt::format("{} layers", pad.layers.size());
  for (const PadLayer& layer : pad.layers)
    text += fmt::format("{} {} of {}", &layer == &pad.layers.front() ? "," : ", then",
                        brief_quantity(layer.thickness, "m", units), foam_text(layer.material));
  return fmt::format("{}, {} thick in all", text, thickness);
}

/// The condition of a pad: `, cut to 0.01 m2, under a sheet of 4 kg/m2`; empty without any.
std::string condition_text(const Pad& pad, const UnitSystem& units) {
  std::string text;
  if (pad.area) text += ", cut to an area of " + brief_quantity(*pad.area, "m2", units);
  if (pad.earlier_penetration > 0)
    text += ", already compressed to a depth of " + brief_quantity(pad.earlier_penetration, "m", units);
  if (pad.neighbours > 0)
    text += pad.floor == Floor::frictionless ? ", resting without friction"
                                             : fmt::format(", {}", name_of(pad.floor));
  if (pad.sheet > 0) text += ", under a sheet of " + brief_quantity(pad.sheet, "kg/m2", units);
  return text;
}

std::string support_text(const Support& support, const UnitSystem& units) {
  if (support.is_rigid()) return "a rigid support";
  const Support::Point& last = support.points().back();
  if (support.points().size() == 1)
    return "a support with a stiffness of " + brief_quantity(last.force / last.deflection, "N/m", units);
  return fmt::format("a support with a force curve of {} points (up to {} at {})", support.points().size(),
                     brief_quantity(last.force, "N", units), brief_quantity(last.deflection, "m", units));
}

/// What happens to the pad between blows.
std::string rests_text(const PadLaw& law, const Blows& blows) {
  switch (blow_memory(law)) {
    case BlowMemory::none:
      return std::holds_alternative<Elastic>(law) ? "according to its law, the pad recovers fully"
                                                  : "according to its law, the pad recovers fully if the "
                                                    "pauses are long compared with its relaxation time";
    case BlowMemory::crater: return "the pad stays crushed";
    case BlowMemory::largest_strain: break;
  }
  if (blows.recovery == 1) return "between blows the pad recovers fully";
  if (blows.recovery == 0) return "between blows the pad does not recover";
  return fmt::format("between blows the pad recovers by {}", percentage(blows.recovery));
}

/// What follows `a rigid support` or `a support with ...`: `, a damping of 30 N s/m and a gap of 2 mm`.
std::string backing_text(const ImpactCase& impact, const UnitSystem& units) {
  std::string text, last;
  for (const Parameter<Backing>& parameter : Backing::parameters) {
    const double value = parameter.of(impact.backing);
    if (value == 0) continue;
    std::string key = parameter.key;
    if (key.ends_with("mass")) key.insert(0, key == "mass" ? "panel " : "free ");
    if (key == "damping") key += " coefficient";
    std::ranges::replace(key, '_', ' ');
    if (!last.empty()) text += (text.empty() && impact.support.is_rigid() ? " with " : ", ") + last;
    last = with_article(key) + " of " + brief_quantity(value, parameter.unit, units);
  }
  if (last.empty()) return text;
  return text + (text.empty() && impact.support.is_rigid() ? " with " : " and ") + last;
}

std::string support_in_si(const Support& support) {
  if (support.is_rigid()) return "rigid\n";
  if (support.points().size() == 1) {
    const Support::Point& point = support.points().front();
    return fmt::format("linear, {} N/m\n", point.force / point.deflection);
  }
  std::string points;
  for (const Support::Point& point : support.points())
    points += fmt::format("{}{} N at {} m", points.empty() ? "" : ", ", point.force, point.deflection);
  return points + "\n";
}

}  // namespace

CaseWords case_words(const ImpactCase& impact, const UnitSystem& units) {
  const Impactor& impactor = impact.impactor;
  return {.impactor =
              fmt::format("{} of {}", with_article(words_of(impactor.nose)), impactor_text(impactor, units)),
          .speed = brief_quantity(impactor.speed, "m/s", units),
          .pad = pad_text(impact.pad, units) + condition_text(impact.pad, units),
          .support = support_text(impact.support, units) + backing_text(impact, units),
          .blows = impact.blows ? fmt::format("{} times; {}", impact.blows->count,
                                              rests_text(impact.pad.material.law, *impact.blows))
                                : ""};
}

std::string case_text(const ImpactCase& impact, const UnitSystem& units) {
  const CaseWords words = case_words(impact, units);
  std::string text = impact.title.empty() ? "" : one_line(impact.title) + "\n";
  text += fmt::format("{} strikes, at {},\na pad of {}, on {}.\n", capitalised(words.impactor), words.speed,
                      words.pad, words.support);
  if (impact.blows) text += fmt::format("It strikes {}.\n", words.blows);
  return text;
}

std::string case_in_si(const ImpactCase& impact, const Options& options) {
  std::string text;
  const auto line = [&](const std::string& key, double value, const std::string& unit) {
    text += fmt::format("  {} = {}{}{}\n", key, value, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
  };
  const auto lines = [&]<class Owner>(const std::string& prefix, const Owner& owner) {
    for (const Parameter<Owner>& parameter : Owner::parameters)
      if (!parameter.goes_without_saying(owner))
        line(prefix + parameter.key, parameter.of(owner), parameter.unit);
  };
  lines("impactor.", impact.impactor);
  text += fmt::format("  impactor.nose = {}\n", name_of(impact.impactor.nose));
  for (const ParameterValue& number : parameter_values(impact.impactor.nose))
    line("impactor." + number.key, number.value, number.unit);
  if (const auto* profile = std::get_if<Profile>(&impact.impactor.nose)) text += profile_in_si(*profile);
  lines("pad.", impact.pad);
  text += fmt::format("  pad.floor = {}\n", name_of(impact.pad.floor));
  const auto material_lines = [&](const std::string& prefix, const PadCondition& condition,
                                  const Material& material) {
    lines(prefix, condition);
    text += fmt::format("  {0}material = {1}\n  {0}law = {2}\n", prefix, one_line(material.name),
                        name_of(material.law));
    for (const ParameterValue& parameter : parameter_values(material.law))
      line(prefix + "parameters." + parameter.key, parameter.value, parameter.unit);
  };
  if (impact.pad.layers.empty()) material_lines("pad.", impact.pad.condition, impact.pad.material);
  for (std::size_t i = 0; i < impact.pad.layers.size(); ++i) {
    const PadLayer& layer = impact.pad.layers[i];
    const std::string prefix = fmt::format("pad.layers[{}].", i + 1);
    lines(prefix, layer);
    material_lines(prefix, layer.condition, layer.material);
  }
  text += "  support = " + support_in_si(impact.support);
  lines("support.", impact.backing);
  if (impact.blows) lines("blows.", *impact.blows);
  lines("solver.", options);
  return text;
}

std::string checked_case(const std::string& name, const ImpactCase& impact, const Options& options,
                         const UnitSystem& units) {
  std::string text = name + ": OK\n\n";
  std::istringstream lines(case_text(impact, units));
  for (std::string line; std::getline(lines, line);) text += wrapped(line, 2) + "\n";
  return text + "\nIn SI:\n" + case_in_si(impact, options);
}

}  // namespace dashpad::output
