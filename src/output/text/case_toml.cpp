#include "output/text/case_toml.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "dashpad/output/card_toml.hpp"
#include "model/parameter_values.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Comments may hold anything but control characters; a text that is not UTF-8 is mended by toml_string().
std::string comment_line(const std::string& key, const std::string& text) {
  return text.empty() ? "" : fmt::format("# {}: {}\n", key, toml_string(text));
}

std::string support_toml(const Support& support) {
  std::string text = "\n[support]\n";
  if (support.is_rigid()) return text + "type = \"rigid\"\n";
  if (support.points().size() == 1) {
    const Support::Point& point = support.points().front();
    return text + "type = \"linear\"\n" + toml_line("stiffness", point.force / point.deflection, "N/m");
  }
  text += "type = \"curve\"\npoints = [\n";
  for (const Support::Point& point : support.points())
    text += fmt::format("  [{}, {}],\n", toml_value(point.deflection, "m"), toml_value(point.force, "N"));
  return text + "]\n";
}

/// The numbers of an owner, but for those that go without saying.
template <class Owner>
std::string given_toml(const Owner& owner) {
  std::string text;
  for (const Parameter<Owner>& parameter : Owner::parameters)
    if (!parameter.goes_without_saying(owner))
      text += toml_line(parameter.key, parameter.of(owner), parameter.unit);
  return text;
}

std::string profile_toml(const Profile& profile) {
  const bool by_radius = profile.of == Profile::Of::radius;
  std::string text = by_radius ? "radii = [\n" : "areas = [\n";
  for (const Profile::Point& point : profile.points)
    text += fmt::format("  [{}, {}],\n", toml_value(point.depth, "m"),
                        toml_value(point.size, by_radius ? "m" : "m2"));
  return text + "]\n";
}

/// `prefix`: of the tables of the law.
std::string material_toml(const Material& material, const PadCondition& condition,
                          const std::string& prefix) {
  // A case file has no card with a density or temperature: its stresses are written as used.
  Material as_used = material;
  as_used.law = scaled(material.law, stress_factor(condition, material));
  return comment_line("material", material.name) + comment_line("title", material.title) +
         comment_line("source", material.source) + law_toml(as_used, prefix);
}

std::string pad_toml(const Pad& pad) {
  std::string text = "\n[pad]\n";
  for (const Parameter<Pad>& parameter : Pad::parameters)
    if (!parameter.goes_without_saying(pad) && (pad.layers.empty() || parameter.member != &Pad::thickness))
      text += toml_line(parameter.key, parameter.of(pad), parameter.unit);
  if (pad.floor != Floor::bonded) text += toml_line("floor", name_of(pad.floor));
  if (pad.layers.empty()) text += material_toml(pad.material, pad.condition, "pad.");
  for (const PadLayer& layer : pad.layers)
    text += "\n[[pad.layers]]\n" + given_toml(layer) +
            material_toml(layer.material, layer.condition, "pad.layers.");
  return text;
}

}  // namespace

std::string toml_string(const std::string& text) {
  // JSON strings are valid TOML strings, except for characters that one_line() removes.
  return nlohmann::json(one_line(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string toml_value(double number, const std::string& unit) {
  return unit == "1" ? fmt::format("{}", number) : fmt::format("\"{} {}\"", number, unit);
}

std::string toml_line(const std::string& key, double number, const std::string& unit) {
  return fmt::format("{} = {}\n", key, toml_value(number, unit));
}

std::string toml_line(const std::string& key, const std::string& text) {
  return fmt::format("{} = {}\n", key, toml_string(text));
}

std::string toml_line(const std::string& key, const std::vector<double>& numbers) {
  constexpr std::size_t widest = 110;
  std::string text;
  std::string line = key + " = [";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string number = fmt::format("{}{}", numbers[i], i + 1 < numbers.size() ? "," : "]");
    const bool begins = line.ends_with('[');
    if (!begins && line.size() + 1 + number.size() > widest) {
      text += line + "\n";
      line = "  " + number;
    } else {
      line += (begins ? "" : " ") + number;
    }
  }
  return text + line + (numbers.empty() ? "]\n" : "\n");
}

std::string case_toml(const ImpactCase& impact, const Options& options) {
  std::string text;
  if (!impact.title.empty()) text += toml_line("title", impact.title);
  const Impactor& impactor = impact.impactor;
  text += "\n[impactor]\n" + given_toml(impactor);
  text += fmt::format("nose = \"{}\"\n", name_of(impactor.nose));
  for (const ParameterValue& number : parameter_values(impactor.nose))
    text += toml_line(number.key, number.value, number.unit);
  if (const auto* profile = std::get_if<Profile>(&impactor.nose)) text += profile_toml(*profile);
  text += pad_toml(impact.pad) + support_toml(impact.support) + given_toml(impact.backing);
  if (impact.blows) text += "\n[blows]\n" + given_toml(*impact.blows);
  text += "\n[solver]\n" + given_toml(options);
  return text.starts_with('\n') ? text.substr(1) : text;
}

}  // namespace dashpad::output
