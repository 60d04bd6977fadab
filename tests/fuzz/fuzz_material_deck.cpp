// Foams in the decks of LS-DYNA and Radioss.

#include <cstdint>
#include <optional>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/material_deck.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/material_deck.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

/// Whether a deck of this format says all numbers of the law that its reader has found.
bool says_all(const Material& material, const std::string& format) {
  const auto* const foam = std::get_if<Foam>(&material.law);
  if (std::holds_alternative<ViscoelasticFoam>(material.law)) return format == "radioss-62";
  if (foam == nullptr) return format == "ls-dyna-163";
  return format == (foam->unloading_curve ? "radioss-70" : "ls-dyna-083");
}

void require_same_law(const Material& material, const Material& again, const char* rule) {
  require(material.law.index() == again.law.index(), rule);
  if (const auto* const foam = std::get_if<Foam>(&material.law)) {
    require(*foam == std::get<Foam>(again.law), rule);
  } else if (const auto* const slow = std::get_if<ViscoelasticFoam>(&material.law)) {
    require(*slow == std::get<ViscoelasticFoam>(again.law), rule);
  } else {
    require(std::get<CrushableFoam>(material.law) == std::get<CrushableFoam>(again.law), rule);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto found = read_or_refuse(
      [&] { return input::read_material_deck(write("deck.k", text_of(bytes, size)), plain_si()).value(); });
  (void)read_or_refuse([&] {
    return input::read_material_deck(folder() / "deck.k", plain_si(), input::Includes::allowed).value();
  });
  (void)read_or_refuse([&] { return input::read_material_deck(folder() / "deck.k", std::nullopt).value(); });
  if (!found) return 0;
  require(!found->empty(), "a deck that is read holds a foam");
  for (const input::DeckMaterial& each : *found) {
    const Material& material = each.material;
    require(violations(material).empty(), "what a deck gives keeps the rules of its law");
    require(each.line > 0 && !each.card.empty(), "a foam knows where it comes from");
    for (const std::string& remark : material.reservations)
      require_plain_text(remark, "a remark is plain text");
    // A card has bounds of its own, such as that of the density.
    const auto card = read_or_refuse(
        [&] { return input::read_material(write("card.toml", output::card_toml(material))).value(); });
    if (card) require_same_law(material, *card, "a card is read as the same law");
    for (const output::MaterialDeckFormat& format : output::material_deck_formats()) {
      const output::MaterialDeckOptions options{format.name, plain_si()};
      if (!output::why_no_material_deck(material, options).empty() || !says_all(material, format.name))
        continue;
      const std::string deck = output::material_deck(material, options);
      if (deck.find("Numbers rounded to fit") != std::string::npos) continue;
      const auto again = input::read_material_deck(write("again.k", deck), plain_si()).value();
      require(again.size() == 1, "a deck that was written holds one foam");
    }
  }
  return 0;
}
