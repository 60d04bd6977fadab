#include "output/text/foam_words.hpp"

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

}  // namespace dashpad::output
