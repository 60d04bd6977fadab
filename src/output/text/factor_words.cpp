#include "output/text/factor_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "dashpad/case/case_quantity.hpp"
#include "output/text/capitals.hpp"

namespace dashpad::output {

namespace {

using Words = std::pair<std::string_view, std::string_view>;

constexpr std::array<Words, 3> known{{{"pad.material", "material"},
                                      {"support.stiffness", "stiffness of the support"},
                                      {"support.scale", "scale of the support's force"}}};

/// The meaning of a number in the table of its owner; "" for another key.
template <class Owner>
std::string_view meaning_in(std::string_view prefix, std::string_view key) {
  if (!key.starts_with(prefix)) return "";
  for (const Parameter<Owner>& parameter : Owner::parameters)
    if (key.substr(prefix.size()) == parameter.key) return parameter.meaning;
  return "";
}

std::string_view meaning_of(std::string_view key) {
  for (const OtherWay& way : other_ways())
    if (key == way.key) return way.meaning;
  for (const std::string_view meaning :
       {meaning_in<Impactor>("impactor.", key), meaning_in<Pad>("pad.", key),
        meaning_in<PadCondition>("pad.", key), meaning_in<Blows>("blows.", key)})
    if (!meaning.empty()) return meaning;
  return "";
}

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
  if (const std::string_view meaning = meaning_of(key); !meaning.empty()) return std::string{meaning};
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
