#include "output/text/case_toml.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/parameter_values.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// A basic string of TOML: what JSON writes, but for what TOML forbids.
std::string quoted(const std::string& text) {
  return nlohmann::json(one_line(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Comments may hold anything but control characters; a text that is not UTF-8 is mended by quoted().
std::string comment_line(const std::string& key, const std::string& text) {
  return text.empty() ? "" : fmt::format("# {}: {}\n", key, quoted(text));
}

std::string value(double number, const std::string& unit) {
  return unit == "1" ? fmt::format("{}", number) : fmt::format("\"{} {}\"", number, unit);
}

std::string line(const std::string& key, double number, const std::string& unit) {
  return fmt::format("{} = {}\n", key, value(number, unit));
}

std::string support_toml(const Support& support) {
  std::string text = "\n[support]\n";
  if (support.is_rigid()) return text + "type = \"rigid\"\n";
  if (support.points().size() == 1) {
    const Support::Point& point = support.points().front();
    return text + "type = \"linear\"\n" + line("stiffness", point.force / point.deflection, "N/m");
  }
  text += "type = \"curve\"\npoints = [\n";
  for (const Support::Point& point : support.points())
    text += fmt::format("  [{}, {}],\n", value(point.deflection, "m"), value(point.force, "N"));
  return text + "]\n";
}

std::string pad_toml(const Pad& pad) {
  const Material& material = pad.material;
  std::string text = "\n[pad]\n" + line("thickness", pad.thickness, "m");
  text += comment_line("material", material.name) + comment_line("title", material.title) +
          comment_line("source", material.source);
  text += fmt::format("law = \"{}\"\n\n[pad.parameters]\n", name_of(material.law));
  for (const ParameterValue& parameter : parameter_values(material.law))
    text += line(parameter.key, parameter.value, parameter.unit);
  if (const auto& fitted = material.fitted)
    text += "\n[pad.fitted]\n" + line("highest_strain", fitted->highest_strain, "1") +
            line("lowest_rate", fitted->lowest_rate, "1/s") +
            line("highest_rate", fitted->highest_rate, "1/s");
  return text;
}

}  // namespace

std::string case_toml(const ImpactCase& impact, const Options& options) {
  std::string text;
  if (!impact.title.empty()) text += "title = " + quoted(impact.title) + "\n";
  const Impactor& impactor = impact.impactor;
  text += "\n[impactor]\n" + line("mass", impactor.mass, "kg");
  text += fmt::format("nose = \"{}\"\n", name_of(impactor.nose));
  for (const ParameterValue& number : parameter_values(impactor.nose))
    text += line(number.key, number.value, number.unit);
  text += line("speed", impactor.speed, "m/s");
  text += pad_toml(impact.pad) + support_toml(impact.support);
  text += "\n[solver]\n" + line("tolerance", options.tolerance, "1") +
          line("time_limit", options.time_limit, "s");
  return text.starts_with('\n') ? text.substr(1) : text;
}

}  // namespace dashpad::output
