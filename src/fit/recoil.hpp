#pragma once
/// How much of the stress that the rate adds resists the way back, recoil of a foam: 1 where nobody says so,
/// which loses nearly all energy of a fast impact. So it is sought where the data show it.

#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/input/input_file.hpp"
#include "input/toml_tree.hpp"

namespace dashpad::fit {

/// Whether the file, the case that it names or the card of its pad gives the number, and no card calls it
/// uncertain. `files` are those that the pad was read from.
bool states_recoil(const input::TomlNode& fit_file, const std::vector<input::InputFile>& files);

/// Whether the foam rests on a recoil that nobody stated and that is no unknown.
bool assumes_recoil(const Fit& fit);

/// Makes it an unknown from 0 to 1 where it is assumed and the fitted data show it: by pulses, rebound
/// speeds, contact times or velocity changes of impacts, or by a test that unloads at a higher rate than that
/// of the base curve; and where there are as many data as unknowns then.
void seek_recoil(Fit& fit);

}  // namespace dashpad::fit
