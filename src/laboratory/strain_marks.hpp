#pragma once
/// Places within a strain history where a value is wanted.

#include <vector>

#include "dashpad/laboratory/strain_history.hpp"

namespace dashpad::laboratory {

/// s
double duration_of(const StrainHistory& history);

/// When the strain first stops to grow, s; 0 if it never grows.
double end_of_first_loading(const StrainHistory& history);

/// At a time from 0 to the end.
double strain_at(const StrainHistory& history, double time);

/// The same history in more pieces: one ends at each of `times` (increasing, s), so that it becomes a place
/// of output.
StrainHistory split_at(const StrainHistory& history, const std::vector<double>& times);

}  // namespace dashpad::laboratory
