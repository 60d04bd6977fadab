#pragma once
/// A way in which a case may be otherwise: one number that goes from 0, the case as it is, to its ends.

#include <functional>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::uncertainty {

/// Standard deviations of a normal distribution, to both sides, that hold 95 %.
inline constexpr double two_sided_95 = 1.959964;

/// Whether the ends of a line are standard deviations of a normal distribution.
constexpr bool is_statistical(Source source) {
  return source == Source::scatter || source == Source::posterior || source == Source::misfit ||
         source == Source::neighbours;
}

struct Line {
  Source source = Source::continuation;
  std::vector<double> ends = {};              ///< one or two, none of them 0
  std::function<ImpactCase(double)> at = {};  ///< the case there
  double deviations = two_sided_95;           ///< of a statistical source, at which the ends lie
};

/// The share of a figure, one standard deviation, that a source leaves open without a further impact.
struct Shares {
  Source source = Source::misfit;
  double acceleration = 0;  ///< of peaks, forces and clips
  double hic = 0;           ///< of every window, and of the severity index
  double rebound = 0;
  double penetration = 0;
  /// Metres by which a penetration may be less, and more, at 95 %: columns alone go too deep.
  double shallower = 0, deeper = 0;
};

/// All that is open.
struct Open {
  std::vector<Line> lines;
  std::vector<Shares> shares;
  std::vector<OpenSource> sources;
};

/// What the pad is made of: one entry, or one a layer, with how far the impact went there.
struct Part {
  const Material* material = nullptr;
  double strain = 0;  ///< largest
  double rate = 0;    ///< 1/s, largest
};
std::vector<Part> parts_of(const Pad& pad, const Summary& summary);

/// The case with `change(material, condition, index)` done to its pad or to each of its layers.
template <class Change>
ImpactCase with_parts(ImpactCase impact, const Change& change) {
  if (impact.pad.layers.empty()) {
    change(impact.pad.material, impact.pad.condition, 0);
    return impact;
  }
  for (std::size_t i = 0; i < impact.pad.layers.size(); ++i)
    change(impact.pad.layers[i].material, impact.pad.layers[i].condition, i);
  return impact;
}

// A file each:
void add_continuation(const ImpactCase& impact, const Summary& summary, Open& open);
void add_rate(const ImpactCase& impact, const Summary& summary, Open& open);
void add_way_back(const ImpactCase& impact, const Summary& summary, Open& open);
void add_statistics(const ImpactCase& impact, const Summary& summary, Open& open);
void add_neighbours(const ImpactCase& impact, const Summary& summary, Open& open);

/// "SMALL NOSE: ...", with the size of the error; empty where the nose is not small against the pad.
std::string warning_of_model(const ImpactCase& impact);

/// Of Student's t, the quantile for both sides: P(|t| < it) = 0.95. Infinite without a degree of freedom;
/// their number may be broken.
[[nodiscard]] double student_95(double degrees_of_freedom);

}  // namespace dashpad::uncertainty
