#pragma once
/// The interval of a figure as JSON, in the units of plain_si().

#include "dashpad/impact/interval.hpp"
#include "json/json_values.hpp"

namespace dashpad::output {

/// `high` is null where there is no bound.
Json interval_json(const FigureInterval& of);

}  // namespace dashpad::output
