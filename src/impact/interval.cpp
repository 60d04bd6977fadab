#include "dashpad/impact/interval.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad {

std::string to_string(Source source) {
  constexpr const char* names[]{"continuation", "rate",   "way back",  "scatter",
                                "posterior",    "misfit", "neighbours"};
  return names[static_cast<std::size_t>(source)];
}

double FigureInterval::share_of(Source source) const {
  const auto of = std::ranges::find(sources, source, &Contribution::source);
  return of == sources.end() || nominal == 0 ? 0 : (of->high - of->low) / 2 / std::abs(nominal);
}

const FigureInterval* Intervals::find(std::string_view key, double level) const {
  const auto of = std::ranges::find_if(
      figures, [&](const FigureInterval& each) { return each.key == key && each.level == level; });
  return of == figures.end() ? nullptr : &*of;
}

const OpenSource* Intervals::find(Source source) const {
  const auto of = std::ranges::find_if(
      sources, [&](const OpenSource& each) { return each.source == source && each.why_not.empty(); });
  return of == sources.end() ? nullptr : &*of;
}

}  // namespace dashpad
