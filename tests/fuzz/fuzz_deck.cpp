// Decks of the 1984 program, as they are typed at its terminal.

#include <cmath>
#include <cstdint>
#include <sstream>

#include "dashpad/spit1984/deck.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream typed{std::string(text_of(bytes, size))};
  std::ostringstream terminal;
  const std::optional<spit1984::Deck> deck = spit1984::ensol(typed, terminal);
  require_plain_text(terminal.str(), "the terminal shows plain text");
  if (!deck) return 0;
  require_finite({deck->radius_in, deck->speed_mph, deck->weight_lb, deck->thickness_in, deck->time_step_ms},
                 "the numbers of a deck are finite");
  for (const auto& parameters :
       {std::vector(deck->pad_parameters.begin(), deck->pad_parameters.end()),
        std::vector(deck->support_parameters.begin(), deck->support_parameters.end())})
    require_finite(parameters, "the parameters of a deck are finite");
  require(deck->support >= 1 && deck->support <= 4, "the support is one of four");
  for (const Violation& broken : spit1984::violations(*deck))
    require(!broken.key.empty() && !broken.rule.empty(), "what is wrong with a deck has a name and a rule");
  return 0;
}
