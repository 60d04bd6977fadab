#pragma once
/// Critical fall heights, measured and computed, as people and programs read them.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/fall_height/fall_height.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The drops, the case, or both, at least one of them, by one standard.
struct FallHeightReport {
  std::optional<fall_height::Answer> measured = {};
  std::string table_file = {};
  /// The answer about the key impactor.drop_height.
  std::optional<margin::Answer> computed = {};
  std::string case_file = {};
  std::vector<std::string> about = {};  ///< "Operator: M. Muster", as given
};

/// The lowest height at which the computed figures no longer keep all limits; absent if the range has none.
const margin::Turn* critical_turn(const margin::Answer& computed);

/// "Critical fall height 1.97 m (95 % interval 1.93 to 2.01 m), where HIC reaches 1000; computed 2.01 m".
std::string fall_height_answer(const FallHeightReport& report, const UnitSystem& units);

/// The answer, the height of each limit and place, the drops, and what they rest on.
Document fall_height_document(const FallHeightReport& report, const UnitSystem& units,
                              Pictures pictures = Pictures::left_out);

/// Each limited figure over the height: drops, curves with their intervals, the computed figure, the limit.
Plot fall_height_plot(const FallHeightReport& report, const UnitSystem& units);

/// Everything, in SI and g; what is absent or not finite is null.
std::string fall_height_json(const FallHeightReport& report, const UnitSystem& units);

/// A row for each drop: remarks, height, number, figures, file of the pulse. Needs measured drops.
std::string fall_height_csv(const FallHeightReport& report);

}  // namespace dashpad::output
