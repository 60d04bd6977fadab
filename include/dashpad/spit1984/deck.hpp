#pragma once
/// The input of the 1984 program: the arguments of its subroutine SPIT, in its own units.
///
/// Inches, miles per hour, pounds (weight), lb/in, psi, seconds in the pad's parameters and milliseconds for
/// the time step (report, Appendix A.3). The program turns miles per hour into inches per second with 17.64,
/// where 17.6 is exact, and weight into mass with 386.4 in/s2.

#include <array>
#include <iosfwd>
#include <optional>
#include <vector>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::spit1984 {

/// KEYP.
enum class PadKey {
  elastic = 1,
  linear_viscoelastic = 2,
  rigid_foam = 3,
  nine_parameter = 4,
  twenty_one_parameter = 5,
};

struct Deck {
  double radius_in = 0;                         ///< RAD
  double speed_mph = 0;                         ///< VIN
  double weight_lb = 0;                         ///< WGT
  PadKey pad = PadKey::elastic;                 ///< KEYP
  std::array<double, 21> pad_parameters{};      ///< PPAR, stored as the report's Table A-1 tells
  double thickness_in = 0;                      ///< THK
  int support = 1;                              ///< KEYS: 1 linear; 2, 3 or 4: that many points
  std::array<double, 12> support_parameters{};  ///< SPAR: X1 F1 X2 F2 ... in in and lb; KS in the ninth
  double time_step_ms = 0.1;                    ///< DELT
  int print_interval = 10;                      ///< NDEL, in time steps
};

/// The deck that says what a case says; the time step and the print interval are the default ones. Each
/// number is rounded to nine significant digits, since a deck was typed: 8.9408 m/s become 20 mph, not
/// 19.999999999999996. What a deck cannot say (a rigid support, a curve of more than four points) is in
/// what_a_deck_cannot_say().
Deck deck_of(const ImpactCase& impact);

/// Every feature of a case that the 1984 program has no input for; empty where deck_of() says it all.
std::vector<Violation> what_a_deck_cannot_say(const ImpactCase& impact);

/// Every number of a deck that makes no sense: an unknown key, not finite, or not positive where it must be.
/// A deck made by deck_of() from a sound case has none. Keys are the program's names.
std::vector<Violation> violations(const Deck& deck);

/// The case as the 1984 program counts it: 17.64 in/s to the mile per hour (0.23 % faster than exact) and
/// 386.4 in/s2 (0.08 % lighter). For the accurate solver, to see what the scheme alone does.
ImpactCase with_the_constants_of_1984(ImpactCase impact);

/// The main program ENSOL of the report's Appendix C, a dialogue that fills a deck: asks on `terminal` what
/// ENSOL asked, in its words and order, and reads the answers as its FORMATs I, E10.0 and 2F did. Absent
/// where the input ends before the last answer.
///
/// Models 4 and 5 get the parameters of Ensolite AAC. ENSOL never asked for those of models 1 to 3: they stay
/// zero, as they did in 1984. Throws std::runtime_error where `terminal` can no longer be written to.
std::optional<Deck> ensol(std::istream& input, std::ostream& terminal);

}  // namespace dashpad::spit1984
