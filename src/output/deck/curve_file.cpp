#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/text/case.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

std::string why_missing(const Curve& curve, const Summary& summary) {
  const bool ran = summary.status != Status::not_run;
  if (ran && !summary.release)
    return "not there: the impactor did not leave the pad (" + to_string(summary.status) + ")";
  return "not there: the " + curve.name + " has no two points";
}

/// A fraction as a percentage of two digits, rounded up: a bound must not look smaller than it is.
std::string bound(double fraction) {
  if (!(fraction > 0)) return "0 %";
  const double unit = std::pow(10, std::floor(std::log10(100 * fraction)) - 1);
  return fmt::format("{:.2g} %", std::ceil(100 * fraction / unit) * unit);
}

FileCurve file_curve(const std::string& name, const Solution& solution,
                     std::optional<std::size_t> most_points) {
  FileCurve of{curve(name, solution), ""};
  const std::size_t all = of.curve.size();
  if (!of.curve.exists()) {
    of.remark = why_missing(of.curve, solution.summary);
  } else if (most_points && all > *most_points) {
    ThinnedCurve few = thinned(of.curve, *most_points);
    double largest = 0;
    for (const double y : of.curve.y) largest = std::max(largest, std::abs(y));
    of.curve = std::move(few.curve);
    of.remark = fmt::format("{} of {} points, off by at most {} of the largest value", of.curve.size(), all,
                            bound(few.error / largest));
  } else {
    of.remark = fmt::format("{} points", all);
  }
  if (of.curve.exists() && of.curve.abscissa.meaning != "time")
    of.remark += "; of this impact: another nose or speed gives another curve";
  return of;
}

/// What a flag means for the curves.
std::string consequence(const Flag& flag, const Summary& summary) {
  if (flag.name == "TOLERANCE NOT MET")
    return std::string("; do not rely on these curves") +
           (summary.release ? "" : ", which end before the impact does");
  if (flag.name == "TIME LIMIT" || (flag.name == "BOTTOMED" && bottomed_on_rigid_support(summary)))
    return "; the curves end there";
  if (flag.name == "BOTTOMED")
    return "; what the force does meanwhile belongs to the support and is not in the curves over penetration";
  return "";
}

}  // namespace

std::vector<std::string> flags_of(const Summary& summary) {
  std::vector<std::string> lines;
  for (const Flag& flag : flags(summary)) lines.push_back(flag.text + consequence(flag, summary));
  return lines;
}

CurveFile curve_file(const ImpactCase& impact, const Solution& solution,
                     const std::vector<std::string>& names, std::optional<std::size_t> most_points) {
  ImpactCase untitled = impact;
  untitled.title.clear();
  CurveFile file;
  file.title = impact.title;
  file.origin = lines_of(case_text(untitled, unit_system("si")));
  file.flags = flags_of(solution.summary);
  for (const std::string& name : names) file.curves.push_back(file_curve(name, solution, most_points));
  return file;
}

}  // namespace dashpad::output
