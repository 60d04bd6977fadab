#pragma once
/// The uncertainty of an impact and the intervals of its figures (theory.md, section 6.2), as plain data.

#include <string>
#include <string_view>
#include <vector>

namespace dashpad {

/// Source of uncertainty of a figure.
enum class Source {
  continuation,  ///< stress of the foam beyond its tested strain
  rate,          ///< stress of the foam beyond its tested rates
  way_back,      ///< energy that the foam gives back
  scatter,       ///< differences among samples
  posterior,     ///< unknowns of a fit, as its data determine them
  misfit,        ///< deviation of measured impacts from the fitted law
  neighbours,    ///< help of neighbouring columns
};
/// "continuation", "rate", "way back", "scatter", "posterior", "misfit", "neighbours".
std::string to_string(Source source);

/// Interval of a figure by one source alone: the hull over a range, 95 % for a statistical source.
struct Contribution {
  Source source = Source::continuation;
  double low = 0;   ///< <= nominal
  double high = 0;  ///< >= nominal; infinite where the pad may bottom out
};

struct FigureInterval {
  std::string key;   ///< key in result_quantities()
  double level = 0;  ///< level of a dwell time, m/s2
  double nominal = 0, low = 0, high = 0;
  std::vector<Contribution> sources = {};  ///< sources that move the figure, largest first

  /// Half the width by one source, over the nominal figure; 0 if the source does not move the figure.
  [[nodiscard]] double share_of(Source source) const;
};

/// A source of uncertainty that this impact has.
struct OpenSource {
  Source source = Source::continuation;
  std::string words;    ///< "how the foam goes on beyond a strain of 0.75"
  std::string why_not;  ///< why it gives no interval; empty if it gives one
};

struct Intervals {
  std::vector<FigureInterval> figures = {};
  std::vector<OpenSource> sources;
  int impacts = 0;      ///< number of impacts solved for the intervals
  std::string warning;  ///< text of SMALL NOSE with the size of the error; may be empty

  [[nodiscard]] const FigureInterval* find(std::string_view key, double level = 0) const;
  /// The source if it gives an interval, or null.
  [[nodiscard]] const OpenSource* find(Source source) const;
};

}  // namespace dashpad
