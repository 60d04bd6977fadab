#include "dashpad/model/nose/cylinder.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {
namespace {

/// x - sin(x), accurate where the two are nearly equal, too.
double beyond_sine(double x) {
  if (x > 1) return x - portable::sin(x);
  double term = x * x * x / 6;
  double sum = 0;
  for (int n = 5; n < 24 && sum + term != sum; n += 2) {
    sum += term;
    term *= -x * x / (n * (n - 1));
  }
  return sum;
}

/// sin(x) - x cos(x) - sin(x)^3 / 3, accurate for small x, too; the series begins with 2/15 x^5.
double second_integral(double x) {
  if (x > 0.5) {
    const double sine = portable::sin(x);
    return sine - x * portable::cos(x) - sine * sine * sine / 3;
  }
  double power = x * x * x * x * x / 120;  // x^n / n!
  double nines = 81;                       // 3^(n - 1)
  double sum = 0;
  for (int n = 5; n < 31; n += 2) {
    sum += power * (0.75 - n + nines / 4);
    power *= -x * x / ((n + 1) * (n + 2));
    nines *= 9;
  }
  return sum;
}

/// Sections by the angle theta at the cylinder's axis: s = R (1 - cos theta), a = 2 l R sin theta.
class CylinderSections final : public SectionShape {
 public:
  CylinderSections(double radius, double length) : radius_(radius), length_(length) {}

  [[nodiscard]] double area(double s) const override { return 2 * length_ * half_width(s); }
  [[nodiscard]] double volume(double s) const override {
    return length_ * radius_ * radius_ * beyond_sine(2 * angle(s)) / 2;
  }
  [[nodiscard]] double volume_integral(double s) const override {
    return length_ * radius_ * radius_ * radius_ * second_integral(angle(s));
  }
  [[nodiscard]] double rate(double s) const override {
    return length_ * std::numbers::inv_pi * (radius_ - s) / half_width(s);
  }
  [[nodiscard]] double depth_at(double area) const override {
    const double half = area / (2 * length_);
    return half * (half / (radius_ + std::sqrt((radius_ - half) * (radius_ + half))));
  }
  [[nodiscard]] bool is_steep_at_tip() const override { return true; }

  [[nodiscard]] std::vector<SectionPiece> pieces(double grading) const override {
    // Share of the radius below which a contact has next to no force.
    constexpr double shallowest = 1e-9;
    const int count = static_cast<int>(std::ceil(-portable::log(shallowest) / grading));
    std::vector<SectionPiece> pieces;
    pieces.reserve(static_cast<std::size_t>(count) + 1);
    double from = 0;
    for (int i = count; i >= 0; --i) {
      const double to = i == 0 ? radius_ : radius_ * portable::exp(portable::log(shallowest) * i / count);
      pieces.push_back(piece(from, to));
      from = to;
    }
    return pieces;
  }

 private:
  [[nodiscard]] double half_width(double s) const { return std::sqrt(s * (2 * radius_ - s)); }
  [[nodiscard]] double angle(double s) const { return 2 * portable::asin(std::sqrt(s / (2 * radius_))); }
  [[nodiscard]] SectionPiece piece(double from, double to) const {
    const double height = to - from;
    const double rise = area(to) - area(from);
    const double mean_rise = (volume(to) - volume(from)) / height - area(from);
    // a(from) + slope u + bend u^2
    const double bend = 3 * (rise - 2 * mean_rise) / (height * height);
    const double slope = rise / height - bend * height;
    return {.from = from,
            .to = to,
            .width = (slope / 2 - bend * from) * std::numbers::inv_pi,
            .taper = -bend * std::numbers::inv_pi};
  }

  double radius_;
  double length_;
};

}  // namespace

Sections Cylinder::sections() const {
  return {.tip = 0,
          .width = 0,
          .taper = 0,
          .depth = radius,
          .shape = std::make_shared<CylinderSections>(radius, length)};
}

}  // namespace dashpad
