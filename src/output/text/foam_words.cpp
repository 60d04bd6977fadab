#include "output/text/foam_words.hpp"

#include <set>
#include <utility>

#include <fmt/format.h>

#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

const char* how_known(const Material& material) { return has_curves(material.law) ? "tested" : "fitted"; }

bool is_beyond(double strain, const FittedRange& range) { return strain > (1 + 1e-9) * range.highest_strain; }

std::string material_words(const Material& material) {
  const std::string name = one_line(material.name);
  return material.title.empty()
             ? fmt::format("{} ({} law)", name, name_of(material.law))
             : fmt::format("{} ({}, {} law)", one_line(material.title), name, name_of(material.law));
}

std::vector<std::string> foam_basis(const Material& material, const UnitSystem& units) {
  std::string foam = material_words(material);
  if (material.density) foam += ", " + brief_quantity(*material.density, "kg/m3", units);
  foam += material.source.empty() ? ". Source not stated." : ". Source: " + one_line(material.source) + ".";
  std::vector<std::string> basis{std::move(foam)};
  if (const auto range = range_of(material))
    basis.push_back(
        fmt::format("{} up to a strain of {}, at {}{} per second.", capitalised(how_known(material)),
                    brief(range->highest_strain, 3), brief(range->lowest_rate, 3),
                    range->highest_rate > range->lowest_rate ? " to " + brief(range->highest_rate, 3) : ""));
  for (const std::string& reservation : material.reservations) basis.push_back(one_line(reservation));
  return basis;
}

std::vector<std::string> foam_basis(const Pad& pad, const UnitSystem& units) {
  if (pad.layers.empty()) return foam_basis(pad.material, units);
  std::vector<std::string> all;
  std::set<std::string> names;
  for (const PadLayer& layer : pad.layers)
    if (names.insert(layer.material.name + layer.material.title).second)
      for (std::string& line : foam_basis(layer.material, units)) all.push_back(std::move(line));
  return all;
}

}  // namespace dashpad::output
