#include "model/contact/sweep.hpp"

#include "model/pad/column_law.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/contact/sweep.cpp"
#include <hwy/foreach_target.h>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dashpad::HWY_NAMESPACE {
namespace {

#include "model/pad/lanes.hpp"
//
#include "model/pad/formulas.hpp"
//
#include "model/contact/sweep_columns.hpp"

void fill_with_lanes(Sweeps* sweeps) { fill<Lanes>(sweeps->of_laws, *sweeps); }

}  // namespace
}  // namespace dashpad::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "model/contact/instruction_set.hpp"

namespace dashpad {
namespace scalar {
namespace {

#include "model/contact/sweep_columns.hpp"  // NOLINT(readability-duplicate-include): for other types

}  // namespace
}  // namespace scalar

const Sweeps& sweeps(ColumnMath math) {
  static const Sweeps with_lanes = [] {
    Sweeps result;
    constexpr decltype(&HWY_STATIC_DISPATCH(fill_with_lanes)) versions[] =
        DASHPAD_VERSIONS_OF(fill_with_lanes);
    for_this_processor(versions)(&result);
    return result;
  }();
  static const Sweeps one_by_one = [] {
    Sweeps result;
    scalar::fill<double>(result.of_laws, result);
    return result;
  }();
  return math == ColumnMath::vector ? with_lanes : one_by_one;
}

}  // namespace dashpad
#endif
