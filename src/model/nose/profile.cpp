#include "dashpad/model/nose/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace dashpad {
namespace {

using std::numbers::pi;

/// The part between two points: a(s) = area + 2 pi (width u - taper u^2 / 2) with u = s - from, m.
struct Stretch {
  double from = 0;
  double to = 0;
  double area = 0;
  double width = 0;
  double taper = 0;
  double volume = 0;           ///< volume from the tip to `from`, m3
  double volume_integral = 0;  ///< its integral over the depth, m4

  [[nodiscard]] double area_at(double s) const {
    const double u = s - from;
    return area + 2 * pi * u * (width - taper * u / 2);
  }
  [[nodiscard]] double volume_at(double s) const {
    const double u = s - from;
    return volume + area * u + 2 * pi * u * u * (width / 2 - taper * u / 6);
  }
  [[nodiscard]] double volume_integral_at(double s) const {
    const double u = s - from;
    return volume_integral + volume * u + area * u * u / 2 +
           2 * pi * u * u * u * (width / 6 - taper * u / 24);
  }
  [[nodiscard]] double rate_at(double s) const { return std::max(width - taper * (s - from), 0.0); }
};

class ProfileSections final : public SectionShape {
 public:
  explicit ProfileSections(std::vector<Stretch> stretches) : stretches_(std::move(stretches)) {
    /// Jump of a' over the larger value from which on a column is placed there.
    constexpr double much = 0.2;
    for (std::size_t i = 1; i < stretches_.size(); ++i) {
      const Stretch& before = stretches_[i - 1];
      const double inner = before.rate_at(before.to);
      const double outer = stretches_[i].width;
      if (std::abs(outer - inner) > much * std::max(inner, outer)) knots_.push_back(before.to);
    }
  }

  [[nodiscard]] double area(double s) const override { return stretch_of(s).area_at(s); }
  [[nodiscard]] double volume(double s) const override { return stretch_of(s).volume_at(s); }
  [[nodiscard]] double volume_integral(double s) const override {
    return stretch_of(s).volume_integral_at(s);
  }
  [[nodiscard]] double rate(double s) const override { return stretch_of(s).rate_at(s); }
  [[nodiscard]] double depth_at(double area) const override {
    const auto reaches = [area](const Stretch& stretch) { return stretch.area_at(stretch.to) < area; };
    const auto at = std::min(std::ranges::partition_point(stretches_, reaches), stretches_.end() - 1);
    const double ring = (area - at->area) * std::numbers::inv_pi;
    if (ring <= 0) return at->from;
    const double root = at->width + std::sqrt(std::max(at->width * at->width - at->taper * ring, 0.0));
    return root > 0 ? std::min(at->from + ring / root, at->to) : at->to;
  }
  [[nodiscard]] const std::vector<double>& knots() const override { return knots_; }
  [[nodiscard]] std::vector<SectionPiece> pieces(double) const override {
    std::vector<SectionPiece> pieces;
    pieces.reserve(stretches_.size());
    for (const Stretch& stretch : stretches_)
      pieces.push_back({.from = stretch.from,
                        .to = stretch.to,
                        .width = stretch.width + stretch.taper * stretch.from,
                        .taper = stretch.taper});
    return pieces;
  }

 private:
  /// The part at a depth; at a knot the one that ends there.
  [[nodiscard]] const Stretch& stretch_of(double s) const {
    const auto ends_before = [s](const Stretch& stretch) { return stretch.to < s; };
    return *std::min(std::ranges::partition_point(stretches_, ends_before), stretches_.end() - 1);
  }

  std::vector<Stretch> stretches_;
  std::vector<double> knots_;
};

}  // namespace

Sections Profile::sections() const {
  const auto area_of = [this](const Point& point) {
    const double size = scaled_size(point);
    return of == Of::radius ? pi * size * size : size;
  };
  // Points behind the widest section meet nothing.
  auto end = points.end();
  while (end - points.begin() > 1 && (end - 2)->size >= points.back().size) --end;
  std::vector<Stretch> stretches;
  stretches.reserve(points.size());
  for (auto point = points.begin(); point + 1 < end; ++point) {
    const auto next = point + 1;
    Stretch stretch{.from = scale * point->depth, .to = scale * next->depth, .area = area_of(*point)};
    const double slope = (scaled_size(*next) - scaled_size(*point)) / (stretch.to - stretch.from);
    if (of == Of::radius) {
      stretch.width = scaled_size(*point) * slope;
      stretch.taper = -slope * slope;
    } else {
      stretch.width = slope / (2 * pi);
    }
    if (!stretches.empty()) {
      const Stretch& before = stretches.back();
      stretch.volume = before.volume_at(before.to);
      stretch.volume_integral = before.volume_integral_at(before.to);
    }
    stretches.push_back(stretch);
  }
  const double tip = points.empty() ? 0 : area_of(points.front());
  if (stretches.empty()) return {.tip = tip, .width = 0, .taper = 0, .depth = 0};
  const double depth = stretches.back().to;
  return {.tip = tip,
          .width = 0,
          .taper = 0,
          .depth = depth,
          .shape = std::make_shared<ProfileSections>(std::move(stretches))};
}

std::vector<Profile::Fault> Profile::faults() const {
  constexpr double min_advance = 1e-9;
  if (points.size() < 2) return {{0, "has fewer than two points"}};
  if (points.size() > max_points) return {{max_points, fmt::format("has more than {} points", max_points)}};
  const char* const what = of == Of::radius ? "radius" : "area";
  std::vector<Fault> broken;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& now = points[i];
    const Point* before = i > 0 ? &points[i - 1] : nullptr;
    if (!std::isfinite(now.depth) || !std::isfinite(now.size))
      broken.push_back({i, "must be finite"});
    else if (!before && now.depth != 0)
      broken.push_back({i, "the first depth must be 0: depths are measured from the tip"});
    else if (before && now.depth < before->depth + min_advance)
      broken.push_back({i, "the depth must exceed the previous depth by at least 1e-9 m"});
    else if (now.size < 0)
      broken.push_back({i, fmt::format("the {} must not be negative", what)});
    else if (before && now.size == 0)
      broken.push_back({i, fmt::format("the {} must be more than 0 beyond the tip", what)});
    else if (before && now.size < before->size)
      broken.push_back({i, fmt::format("the {} must not decrease with distance from the tip", what)});
  }
  return broken;
}

}  // namespace dashpad
