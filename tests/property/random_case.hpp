#pragma once
/// Random valid impact cases: every law, every kind of support, extreme ratios. One seed, one case: a case
/// that fails is repeated from its seed alone.

#include <cstdint>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::test {

ImpactCase random_case(std::uint64_t seed);

}  // namespace dashpad::test
