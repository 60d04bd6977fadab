#pragma once
/// Subroutine PAD alone, driven by prescribed strains: the report's preliminary analyses (section 2.3,
/// Figures 2-9 and 2-10). The stresses are those of the explicit update of 1984 (report, Eq. 16).

#include <array>
#include <vector>

#include "dashpad/spit1984/deck.hpp"
#include "dashpad/spit1984/run.hpp"

namespace dashpad::spit1984 {

/// The stress of one station at the end of each step, psi, positive in compression (the program's own sign is
/// negative). `strains` are positive in compression and begin with 0, that of first contact; one stress each,
/// the first 0. `step` in s, > 0. Law 5 takes its time at the end of a step, as in the program.
///
/// The stress may be tensile, below zero: it is SPIT, not PAD, that looks for tension. On the way back to
/// strain zero laws 4 and 5 divide by the strain; the last stresses there mean nothing.
///
/// Throws std::invalid_argument for parameters that violations(Deck) refuses, fewer than two strains, a first
/// one that is not 0, or strains outside [0, 1).
std::vector<double> column_stresses(PadKey pad, const std::array<double, 21>& parameters,
                                    const std::vector<double>& strains, double step,
                                    Arithmetic arithmetic = Arithmetic::pdp10);

/// The same of a material of one of the five laws, in Pa. Throws std::invalid_argument for a material that no
/// deck of the program can hold.
std::vector<double> stresses_of_update(const Material& material, const std::vector<double>& strains,
                                       double step);

}  // namespace dashpad::spit1984
