#pragma once
/// The reservation about a pass that rests on clips alone: a spike of a crushed pad may be too short for
/// them.

#include <optional>
#include <span>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

/// An upper limit on a figure.
struct UpperLimit {
  const ResultQuantity* quantity = nullptr;
  double level = 0;  ///< m/s2; of a dwell time only
  double value = 0;  ///< SI
};

inline constexpr const char* short_spike_name = "SHORT SPIKE";

/// SHORT SPIKE: the pad is crushed through, or strained beyond the tests of its foam, the peak is or may be
/// a quarter above the level of a clip or a dwell time, and no limit is on a figure that sees a short spike,
/// such as the peak or HIC. Nothing otherwise. With the peak in g, whatever the verdict.
std::optional<Flag> short_spike(const Summary& summary, std::span<const UpperLimit> limits);

/// The text of a flag without its name: what follows ", but " in an answer.
std::string words_of(const Flag& flag);

}  // namespace dashpad::injury
