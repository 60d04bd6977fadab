#include <algorithm>
#include <array>
#include <functional>
#include <istream>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/spit1984/deck.hpp"
#include "spit1984/fortran_format.hpp"

namespace dashpad::spit1984 {

namespace {

// The scan shows capitals and small letters at random in these texts, as in the statements around them.
// FORTRAN on the DECSystem-10 was written in capitals.

constexpr std::array<double, 9> nine_parameters{7.96,  0.675,   1.09,   8.81e-03, 5.45,
                                                0.166, 9.76e-6, 0.0987, 22.127};  // PAR9, Ensolite AAC

constexpr std::array<double, 21> twenty_one_parameters{
    7.96,  0.675, 1.09,    0.13,    0.156,  3.08, 4.153, 0.19,  3.17, 0.58, 2.57,
    0.296, 2.23,  1.64e-3, 9.76e-6, 0.0987, 66.0, 10.12, 0.279, 1.94, 0.029};  // PAR21, Ensolite AAC

struct EndOfInput {};

/// Unit 5. The texts in small letters are not ENSOL's: after an unreadable line the run-time system asked
/// again, in words of its own; the program itself checked nothing.
class Terminal {
 public:
  Terminal(std::istream& input, std::ostream& output) : input_(input), output_(output) {}

  void say(std::string_view text) {
    if (!(output_ << text << std::flush)) throw std::runtime_error("the terminal cannot be written to");
  }

  /// Calls `fields` with each line until it returns its values; complains about the others.
  template <typename Fields>
  auto read(Fields fields, const std::string& complaint) {
    for (;;) {
      std::string line;
      if (!std::getline(input_, line)) throw EndOfInput{};
      TypedRecord record{line};
      if (const auto fields_read = std::invoke(fields, record)) return *fields_read;
      say(complaint);
    }
  }

  int whole_number() {  // FORMAT(I)
    return read(&TypedRecord::i, "That is not a whole number. Please try again: ");
  }

  int choice(int largest) {  // FORMAT(I)
    for (;;) {
      const int chosen = whole_number();
      if (chosen >= 1 && chosen <= largest) return chosen;
      say("Please type a whole number from 1 to " + std::to_string(largest) + ": ");
    }
  }

  double number() {  // FORMAT(E10.0)
    return read([](TypedRecord& record) { return record.e(10); }, "That is not a number. Please try again: ");
  }

  std::pair<double, double> pair_of_numbers() {  // FORMAT(2F)
    const auto two = [](TypedRecord& record) -> std::optional<std::pair<double, double>> {
      const std::optional<double> first = record.f();
      const std::optional<double> second = record.f();
      if (!first || !second) return std::nullopt;
      return std::pair{*first, *second};
    };
    return read(two, "Those are not two numbers. Please try again: ");
  }

 private:
  std::istream& input_;
  std::ostream& output_;
};

// Texts of the FORMATs, with their numbers.

constexpr std::string_view greeting = "SPHERE/PAD IMPACT TRACKER VERSION 2-DEC 1984\n";  // 500

constexpr std::string_view model_prompt =  // 510
    "PLEASE CHOOSE MODEL: 1 = ELASTIC\n"
    "                     2 = LINEAR V.E.\n"
    "                     3 = RIGID-FOAM\n"
    "                     4 = 9-PARAMETER\n"
    "                     5 = 21-PARAMETER: ";

constexpr std::string_view support_prompt =  // 520
    "\n"
    "PLEASE ENTER: 1 = LINEAR ELASTIC SUPPORT\n"
    "              2 = PIECEWISE LINEAR SUPPORT (2 SLOPES)\n"
    "              3 = PIECEWISE LINEAR SUPPORT (3 SLOPES)\n"
    "              4 = PIECEWISE LINEAR SUPPORT (4 SLOPES): ";

double ask(Terminal& terminal, const std::string& text) {
  terminal.say(text);
  return terminal.number();
}

void ask_for_support(Terminal& terminal, Deck& deck) {
  if (deck.support == 1) {
    deck.support_parameters[8] = ask(terminal, "ENTER SUPPORT STIFFNESS (LB/IN): ");  // 601
    return;
  }
  terminal.say("ENTER BREAK POINTS FOR PIECEWISE LINEAR SUPPORT: \n");  // 651
  for (int point = 1; point <= deck.support; ++point) {
    terminal.say(fmt::format("DEFLECTION-LOAD PAIR {:2}:", point));  // 652
    const auto [deflection, load] = terminal.pair_of_numbers();
    deck.support_parameters[static_cast<std::size_t>(2 * point - 2)] = deflection;
    deck.support_parameters[static_cast<std::size_t>(2 * point - 1)] = load;
  }
}

void take_ensolite(Deck& deck) {
  if (deck.pad == PadKey::nine_parameter) std::ranges::copy(nine_parameters, deck.pad_parameters.begin());
  if (deck.pad == PadKey::twenty_one_parameter) deck.pad_parameters = twenty_one_parameters;
}

Deck asked_deck(Terminal& terminal) {
  Deck deck;
  terminal.say(greeting);
  terminal.say(model_prompt);
  deck.pad = static_cast<PadKey>(terminal.choice(5));
  terminal.say(support_prompt);
  deck.support = terminal.choice(4);
  deck.radius_in = ask(terminal, "\nENTER SPHERE RADIUS (IN.): ");       // 530
  deck.speed_mph = ask(terminal, "ENTER INITIAL SPEED (MPH): ");         // 999
  deck.weight_lb = ask(terminal, "ENTER WEIGHT (LBS): ");                // 531
  deck.thickness_in = ask(terminal, "ENTER FOAM THICKNESS (IN.): ");     // 535
  deck.time_step_ms = ask(terminal, "INITIAL TIME STEP SIZE (MSEC): ");  // 998
  terminal.say("ENTER PRINT INTERVAL, NDEL: ");                          // 996
  deck.print_interval = terminal.whole_number();
  ask_for_support(terminal, deck);
  take_ensolite(deck);
  return deck;
}

}  // namespace

std::optional<Deck> ensol(std::istream& input, std::ostream& terminal) {
  Terminal both{input, terminal};
  try {
    return asked_deck(both);
  } catch (const EndOfInput&) {
    return std::nullopt;
  }
}

}  // namespace dashpad::spit1984
