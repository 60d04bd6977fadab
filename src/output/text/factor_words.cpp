#include "output/text/factor_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "output/text/capitals.hpp"

namespace dashpad::output {

namespace {

using Words = std::pair<std::string_view, std::string_view>;

constexpr std::array<Words, 15> known{{{"impactor.mass", "mass of the impactor"},
                                       {"impactor.weight", "weight of the impactor"},
                                       {"impactor.speed", "impact speed"},
                                       {"impactor.gravity", "gravity"},
                                       {"pad.material", "material"},
                                       {"pad.thickness", "thickness of the pad"},
                                       {"pad.area", "area of the pad"},
                                       {"pad.sheet_mass_per_area", "mass per area of the sheet"},
                                       {"pad.earlier_penetration", "earlier penetration"},
                                       {"pad.scale", "scale of the foam's stress"},
                                       {"pad.density", "density of the foam"},
                                       {"pad.temperature", "temperature of the foam"},
                                       {"blows.recovery", "recovery between blows"},
                                       {"support.stiffness", "stiffness of the support"},
                                       {"support.scale", "scale of the support's force"}}};

/// What the numbers under a table of the case belong to.
constexpr std::array<Words, 5> owners{{{"pad.parameters.", " of the foam"},
                                       {"pad.curve.", " of the foam"},
                                       {"pad.rate.", " of the foam's rate effect"},
                                       {"impactor.", " of the nose"},
                                       {"support.", " of the support"}}};

std::string with_blanks(std::string_view key) {
  std::string words{key};
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// "density of the foam in layer 2" of pad.layers[2].density.
std::string words_of_layer(std::string_view key) {
  constexpr std::string_view begin = "pad.layers[";
  const std::size_t end = key.find("].");
  if (!key.starts_with(begin) || end == std::string_view::npos) return {};
  const std::string number{key.substr(begin.size(), end - begin.size())}, of{key.substr(end + 2)};
  return of == "thickness" ? "thickness of layer " + number
                           : factor_words("pad." + of) + " in layer " + number;
}

}  // namespace

std::string factor_words(const std::string& key) {
  for (const auto& [name, words] : known)
    if (key == name) return std::string{words};
  if (std::string words = words_of_layer(key); !words.empty()) return words;
  for (const auto& [begin, owner] : owners)
    if (key.starts_with(begin) && key.find('.', begin.size()) == std::string::npos)
      return with_blanks(std::string_view{key}.substr(begin.size())) + std::string{owner};
  return key;
}

std::string factor_title(const std::string& key) {
  const std::string words = factor_words(key);
  return words == key ? words : capitalised(words);
}

}  // namespace dashpad::output
