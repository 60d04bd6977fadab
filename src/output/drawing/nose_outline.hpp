#pragma once
/// A nose as it is seen from the side.

#include "dashpad/model/nose/nose.hpp"

namespace dashpad::output {

/// Sections of the round nose that has this one's outline: their radius is half its width at a depth, m. An
/// ellipsoid is seen across its half length, a platen across its length, a cylinder along its axis.
Sections outline_of(const Nose& nose);

/// Whether it is narrower again behind its widest section, rather than going on along the motion.
bool is_ball(const Nose& nose);

/// Half the width, in the same view, of a pad with this face, m2: its outline is that of the nose's sections,
/// which is how the model takes it (theory.md, section 1).
double half_width_of_face(const Nose& nose, double area);

}  // namespace dashpad::output
