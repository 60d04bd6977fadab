#pragma once
/// Pad laws with the curves of foams, their fitted range and what is not known of them in TOML. Cards have
/// them at their top, cases in [pad].

#include <optional>

#include "dashpad/model/pad/law.hpp"
#include "dashpad/model/pad/material.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// `law` and the table [parameters]; nothing if the law cannot be known. Parameters at fault are NaN.
std::optional<PadLaw> read_law(TableReader& table);

/// The optional table [fitted].
std::optional<FittedRange> read_fitted(TableReader& table);

/// The optional table [uncertainty]. Keys of the posterior that the law does not have are at fault.
Uncertainty read_uncertainty(TableReader& table, const PadLaw& law);

}  // namespace dashpad::input
