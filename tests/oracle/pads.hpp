#pragma once
/// The pads of the general oracle (any_impact.hpp), written anew from theory.md: only the parameters are the
/// library's. Each is a force over the penetration y, with numbers that it remembers and a rate for each.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "oracle/pressed.hpp"

namespace dashpad::oracle {

/// Where a depth lies among those of columns: behind which, and by which share of the way to the next.
struct Between {
  std::size_t column = 0;
  double share = 0;
};
inline Between between(const std::vector<double>& depths, double depth) {
  if (depths.size() == 1) return {};
  const auto above = std::ranges::upper_bound(depths, depth) - depths.begin();
  const auto j = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, std::ssize(depths) - 1)) - 1;
  return {j, std::fmax((depth - depths[j]) / (depths[j + 1] - depths[j]), 0)};
}

class PadModel {
 public:
  /// `fineness`: as many times the usual columns, panels and looks.
  PadModel(Outline nose, double thickness, int fineness)
      : nose_(std::move(nose)), thickness_(thickness), fineness_(fineness) {}
  PadModel(const PadModel&) = delete;
  PadModel& operator=(const PadModel&) = delete;
  virtual ~PadModel() = default;

  [[nodiscard]] virtual std::size_t unknowns() const { return 0; }
  [[nodiscard]] virtual Pressed pressed(double y, const double* memory, bool with_area) const = 0;
  /// `speed`: dY/dt, m/s, where needs_speed(); `time` since first contact, s.
  virtual void rates(double /*y*/, double /*speed*/, double /*time*/, const double* /*memory*/,
                     double* /*slope*/) const {}
  [[nodiscard]] virtual bool needs_speed() const { return false; }
  /// Whether it is laws 4 and 5, whose stress has a rate that depends on the speed.
  [[nodiscard]] virtual bool has_rates() const { return false; }
  /// dF/dt, N/s, of such a pad at a speed dY/dt: exp(log_speed) the way it goes, +1 or -1. Of many at one
  /// moment: after prepare().
  virtual void prepare(double /*y*/, double /*time*/, const double* /*memory*/) const {}
  [[nodiscard]] virtual double force_rate(double /*log_speed*/, int /*way*/) const { return 0; }
  /// Where the pad turns; what is remembered from there on, if that is another thing.
  [[nodiscard]] virtual std::vector<double> turned(double /*y*/, const double* /*memory*/) { return {}; }
  /// Error that each may have a step, at a relative one.
  virtual void allowances(double /*relative*/, const double* /*memory*/, double* /*allowance*/) const {}
  /// Where the nose meets it at a speed, m/s, and what is remembered then.
  [[nodiscard]] virtual double begin(double* /*memory*/, double /*speed*/) { return 0; }
  /// Whether it stays as deep as it was pressed, and gives nothing back.
  [[nodiscard]] virtual bool holds() const { return false; }
  /// A change of the penetration that is small against what the force depends on, m.
  [[nodiscard]] virtual double little() const { return 1e-7 * thickness_; }

  /// The end of a step, and where the pad turns.
  void reached(double y, const double* memory) {
    largest_ = std::max(largest_, y);
    remember(y, memory);
  }
  /// The nose has left it, and may come again.
  virtual void left() {}
  void set_loading(bool loading) { loading_ = loading; }
  [[nodiscard]] bool is_loading() const { return loading_; }
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] const Outline& nose() const { return nose_; }
  [[nodiscard]] double thickness() const { return thickness_; }
  [[nodiscard]] int fineness() const { return fineness_; }

 protected:
  /// By how much the largest penetration is above that of now, in thicknesses.
  [[nodiscard]] double ahead(double y) const {
    return loading_ ? 0 : std::fmax(largest_ - y, 0) / thickness_;
  }
  /// A pad that was struck before, as deep as that.
  void begin_struck(double earlier) {
    largest_ = earlier;
    loading_ = earlier == 0;
  }
  virtual void remember(double /*y*/, const double* /*memory*/) {}

 private:
  Outline nose_;
  double thickness_;
  int fineness_;
  bool loading_ = true;
  double largest_ = 0;
};

/// `deepest`: a penetration that is not exceeded, m, for pads of columns at fixed depths.
std::unique_ptr<PadModel> pad_model(const ImpactCase& impact, double deepest, int fineness);

}  // namespace dashpad::oracle
