#pragma once
/// The uncertainties of a case, as lines of cases and as shares of figures.

#include <functional>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::uncertainty {

/// Number of standard deviations of a normal distribution to both sides of its mean that contain 95 %.
inline constexpr double two_sided_95 = 1.959964;

/// Whether the ends of a line are standard deviations of a normal distribution.
constexpr bool is_statistical(Source source) {
  return source == Source::scatter || source == Source::posterior || source == Source::misfit ||
         source == Source::neighbours;
}

/// A line of cases along which one unknown varies; the case as it is lies at 0.
struct Line {
  Source source = Source::continuation;
  std::string key = {};                                ///< key in studies (dashpad/uncertainty/draw.hpp)
  std::vector<double> ends = {};                       ///< one or two places, none of them 0
  std::function<void(ImpactCase&, double)> move = {};  ///< moves the case to a place
  double deviations = two_sided_95;  ///< standard deviations at the ends, for a statistical source
};

/// Standard deviations of figures by a source that needs no further impact, as shares of the figures.
struct Shares {
  Source source = Source::misfit;
  std::string key = {};     ///< as Line::key
  double acceleration = 0;  ///< share of peaks, forces and clips
  double hic = 0;           ///< share of HIC of every window and of the severity index
  double rebound = 0;
  double penetration = 0;
  /// Amounts by which a penetration may be smaller and larger at 95 %, m; columns alone go too deep.
  double shallower = 0, deeper = 0;
};

/// All uncertainties of a case.
struct Open {
  std::vector<Line> lines;
  std::vector<Shares> shares;
  std::vector<OpenSource> sources;
};

/// The change of a figure, SI, by a number of standard deviations of a source given as shares; 0 for a dwell
/// time.
double change_of(const ResultQuantity& quantity, double value, const Summary& summary, const Shares& shares,
                 double deviations);

/// The pad or one of its layers, with the largest strain and strain rate of the impact in it.
struct Part {
  const Material* material = nullptr;
  double strain = 0;
  double rate = 0;  ///< 1/s
};
std::vector<Part> parts_of(const Pad& pad, const Summary& summary);

/// Calls `change(material, condition, index)` for the pad of the case or each of its layers.
template <class Change>
void change_parts(ImpactCase& impact, const Change& change) {
  if (impact.pad.layers.empty()) return change(impact.pad.material, impact.pad.condition, 0);
  for (std::size_t i = 0; i < impact.pad.layers.size(); ++i)
    change(impact.pad.layers[i].material, impact.pad.layers[i].condition, i);
}

// Each adds the uncertainty of one kind, from a file of its own.
void add_continuation(const ImpactCase& impact, const Summary& summary, Open& open);
void add_rate(const ImpactCase& impact, const Summary& summary, Open& open);
void add_way_back(const ImpactCase& impact, const Summary& summary, Open& open);
void add_statistics(const ImpactCase& impact, const Summary& summary, Open& open);
void add_neighbours(const ImpactCase& impact, const Summary& summary, Open& open);

/// The uncertainties of all kinds.
Open open_sources_of(const ImpactCase& impact, const Summary& summary);

/// The text "SMALL NOSE: ..." with the size of the error; empty unless the nose is small against the pad.
std::string warning_of_model(const ImpactCase& impact);

/// The two-sided 95 % quantile of Student's t, for any number of degrees of freedom; infinite if not above 0.
[[nodiscard]] double student_95(double degrees_of_freedom);

}  // namespace dashpad::uncertainty
