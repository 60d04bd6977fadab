#pragma once
/// What is uncertain of a foam as numbers that can be drawn: factors of a study (docs/studies.md).
///
/// Each number is 0 for the case as it is. A range ("foam.continuation", "foam.rate", "foam.way_back",
/// "foam.lag_strain") has its ends at -1 and 1, or at 1 alone; a statistical source ("foam.scatter",
/// "foam.posterior_1", "foam.misfit", "foam.neighbours") is counted in standard deviations.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::uncertainty {

struct FoamFactor {
  std::string key;
  bool is_statistical = false;
  double lowest = -1, highest = 1;  ///< ends of a range; of a statistical source, as far as it may be given
};

/// All that an impact with this foam may leave uncertain, whatever strains and rates it reaches.
std::vector<FoamFactor> foam_factors(const ImpactCase& impact);

/// Whether a key is one of a FoamFactor, of this foam or another.
inline bool is_foam_factor(std::string_view key) { return key.starts_with("foam."); }

/// A draw of what is uncertain of the foam of one impact.
class FoamDraw {
 public:
  /// Keys and values of all numbers drawn.
  using Numbers = std::vector<std::pair<std::string, double>>;

  /// Moves the case along the lines that its impact, solved before with this summary, has.
  FoamDraw(const Numbers& numbers, const Summary& nominal, ImpactCase& impact);
  /// Whether the case differs from what it was.
  [[nodiscard]] bool has_moved() const { return has_moved_; }
  /// A figure of the impact of the moved case with the errors of the law and of the columns, SI.
  [[nodiscard]] double figure(const ResultQuantity& quantity, double value, const Summary& summary) const;

 private:
  struct Error {
    Shares shares;
    double deviations = 0;
  };
  std::vector<Error> errors_;
  bool has_moved_ = false;
};

}  // namespace dashpad::uncertainty
