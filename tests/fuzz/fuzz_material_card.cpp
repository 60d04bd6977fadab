// Material cards.

#include <cstdint>

#include "dashpad/input/case_file.hpp"
#include "dashpad/output/materials.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto card =
      read_or_refuse([&] { return input::read_material(write("foam.toml", text_of(bytes, size))).value(); });
  if (!card) return 0;
  require(violations(*card).empty(), "a card that was read breaks no rule");
  require(!card->title.empty() && !card->source.empty(), "a card has a title and a source");
  for (const UnitSystem& units : unit_systems())
    require_plain_text(
        output::to_terminal(output::material_document(*card, units), output::Detail::all) +
            output::to_terminal(output::materials_document({*card}, units), output::Detail::all),
        "a card is shown as plain text");
  return 0;
}
