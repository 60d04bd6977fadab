#pragma once
/// The input of the 1984 program: the arguments of its subroutine SPIT, in its own units.
///
/// Lengths are in inches, speeds in miles per hour, weights in pounds, stiffnesses in lb/in, stresses in psi,
/// times in seconds in the pad's parameters and in milliseconds for the time step (report, Appendix A.3). The
/// program takes 17.64 in/s for a mile per hour, where 17.6 is exact, and 386.4 in/s2 for gravity.

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
  std::array<double, 21> pad_parameters{};      ///< PPAR, stored as in the report's Table A-1
  double thickness_in = 0;                      ///< THK
  int support = 1;                              ///< KEYS: 1 linear; 2, 3 or 4: that many points
  std::array<double, 12> support_parameters{};  ///< SPAR: X1 F1 X2 F2 ... in in and lb; KS in the ninth
  double time_step_ms = 0.1;                    ///< DELT
  int print_interval = 10;                      ///< NDEL, in time steps
};

/// The deck of a case, with the default time step and print interval. Each number is rounded to nine
/// significant digits, since a deck was typed: 8.9408 m/s becomes 20 mph, not 19.999999999999996. The case
/// must have no what_a_deck_cannot_say().
Deck deck_of(const ImpactCase& impact);

/// Lists all features of a case for which the 1984 program has no input, such as a rigid support or a curve
/// of more than four points.
std::vector<Violation> what_a_deck_cannot_say(const ImpactCase& impact);

/// Lists all invalid numbers of a deck: an unknown key, not finite, or not positive where it must be. The
/// deck of a valid case has none. Keys are the program's names.
std::vector<Violation> violations(const Deck& deck);

/// The case with the constants of 1984: 17.64 in/s to the mile per hour (0.23 % faster than exact) and 386.4
/// in/s2 (0.08 % lighter). With it, the accurate solver shows the error of the scheme alone.
ImpactCase with_the_constants_of_1984(ImpactCase impact);

/// The main program ENSOL of the report's Appendix C: asks for a deck on `terminal`, in ENSOL's words and
/// order, and reads the answers as its FORMATs I, E10.0 and 2F did. Absent if the input ends before the last
/// answer.
///
/// Models 4 and 5 get the parameters of Ensolite AAC; those of models 1 to 3 stay zero, as in 1984, since
/// ENSOL never asked for them. Throws std::runtime_error if `terminal` can no longer be written to.
std::optional<Deck> ensol(std::istream& input, std::ostream& terminal);

}  // namespace dashpad::spit1984
