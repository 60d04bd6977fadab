#pragma once
/// What is not known of an impact, and the interval that it gives each figure (theory.md, section 6, "How
/// sure a figure is"). Plain data; uncertainty/intervals.hpp makes it. SI.

#include <string>
#include <string_view>
#include <vector>

namespace dashpad {

/// What a figure hangs on beside its case.
enum class Source {
  continuation,  ///< how the foam goes on beyond its tested strain
  rate,          ///< and beyond its tested rates
  way_back,      ///< what the foam gives back
  scatter,       ///< from sample to sample
  posterior,     ///< what the data of a fit leave open of its unknowns
  misfit,        ///< by what measured impacts differ from the fitted law
  neighbours,    ///< columns that do not help each other
};
/// "continuation", "rate", "way back", "scatter", "posterior", "misfit", "neighbours".
std::string to_string(Source source);

/// A figure with one source alone: its hull where that is a range, 95 % where it is statistical.
struct Contribution {
  Source source = Source::continuation;
  double low = 0;   ///< <= nominal
  double high = 0;  ///< >= nominal; infinite where the pad may bottom out
};

struct FigureInterval {
  std::string key;   ///< of result_quantities()
  double level = 0;  ///< m/s2, of a dwell time
  double nominal = 0, low = 0, high = 0;
  std::vector<Contribution> sources;  ///< that move it, largest first

  /// Half of what a source leaves open, over the nominal; 0 for one that does not move the figure.
  [[nodiscard]] double share_of(Source source) const;
};

/// One thing that is not known.
struct OpenSource {
  Source source = Source::continuation;
  std::string words;    ///< "how the foam goes on beyond a strain of 0.75"
  std::string why_not;  ///< why it gives no interval; empty where it gives one
};

struct Intervals {
  std::vector<FigureInterval> figures;
  std::vector<OpenSource> sources;
  int impacts = 0;  ///< that were solved for them
  std::string
      warning;  ///< of the model for this case, with the size of its error, behind SMALL NOSE; may be empty

  [[nodiscard]] const FigureInterval* find(std::string_view key, double level = 0) const;
  /// Of a source that gives an interval.
  [[nodiscard]] const OpenSource* find(Source source) const;
};

}  // namespace dashpad
