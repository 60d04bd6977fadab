#pragma once
/// The curves of a foam in TOML: [curve], [rate] and [unloading], beside the law's parameters.

#include "dashpad/model/pad/law.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// False after a fault that leaves no curve to check. Numbers at fault are NaN.
bool read_foam_tables(TableReader& table, Foam& into);
bool read_foam_tables(TableReader& table, CrushableFoam& into);

}  // namespace dashpad::input
