#pragma once
/// The forms that the base curve of a foam can have: the stress of its slowest test over the strain.

#include <variant>

#include "dashpad/model/pad/foam/avalle_curve.hpp"
#include "dashpad/model/pad/foam/gibson_ashby_curve.hpp"
#include "dashpad/model/pad/foam/hyperfoam_curve.hpp"
#include "dashpad/model/pad/foam/power_curve.hpp"
#include "dashpad/model/pad/foam/table_curve.hpp"

namespace dashpad {

using BaseCurve = std::variant<TableCurve, AvalleCurve, PowerCurve, GibsonAshbyCurve, HyperfoamCurve>;

}  // namespace dashpad
