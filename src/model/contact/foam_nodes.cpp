#include "model/contact/foam_nodes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/contact/foam_nodes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dashpad::HWY_NAMESPACE {
namespace {

#include "model/pad/lanes.hpp"
//
#include "model/pad/foam/foam_formulas.hpp"
//
#include "model/contact/foam_node_lanes.hpp"

FoamNodeMath with_lanes() { return {fill_within, fill_beyond}; }

}  // namespace
}  // namespace dashpad::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "model/contact/instruction_set.hpp"

namespace dashpad {
const FoamNodeMath& foam_node_math() {
  constexpr decltype(&HWY_STATIC_DISPATCH(with_lanes)) versions[] = DASHPAD_VERSIONS_OF(with_lanes);
  static const FoamNodeMath result = for_this_processor(versions)();
  return result;
}

}  // namespace dashpad
#endif
