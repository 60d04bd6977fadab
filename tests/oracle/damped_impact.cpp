#include "oracle/damped_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "oracle/law_formulas.hpp"

namespace dashpad::oracle {
namespace {

template <class Formulas>
class DampedRun {
 public:
  DampedRun(const ImpactCase& impact, const Formulas& law, const DampedOptions& options)
      : impact_(impact), law_(law), options_(options), velocity_(impact.impactor.speed), rate_(velocity_) {
    const auto count = static_cast<std::size_t>(options.columns);
    const double deepest = std::min(impact.pad.thickness, sphere_radius(impact.impactor.nose));
    depth_.resize(count);
    for (std::size_t j = 1; j < count; ++j)
      depth_[j] = deepest * std::pow(shallowest, 1 - static_cast<double>(j) / static_cast<double>(count - 1));
    stress_.assign(count, 0);
    trial_stress_ = stress_;
  }

  DampedImpact run() {
    while (time_ < options_.longest && !result_.released) step();
    if (largest_ > sphere_radius(impact_.impactor.nose))
      throw std::invalid_argument("damped oracle: the penetration exceeds the sphere's radius");
    return result_;
  }

 private:
  /// Least depth of a column beside the axis, in thicknesses.
  static constexpr double shallowest = 1e-7;

  [[nodiscard]] StrainPoint point(double penetration, double depth) const {
    const double thickness = impact_.pad.thickness;
    return strain_point((penetration - depth) / thickness, ((thickness - penetration) + depth) / thickness,
                        law_.m(), law_.n());
  }

  /// Pad force after a step at the rate v.
  double pad_force(double v) {
    const double thickness = impact_.pad.thickness;
    const double penetration = penetration_ + v * options_.step;
    const auto rate = law_.at_rate(v / thickness);
    double sum = 0;
    double outer = 0;
    std::fill(trial_stress_.begin(), trial_stress_.end(), 0.0);
    double previous = 0;
    for (std::size_t j = 0; j < depth_.size() && depth_[j] < penetration; ++j) {
      const StrainPoint after = point(penetration, depth_[j]);
      const double largest = (largest_ - depth_[j]) / thickness;
      double remainder = stress_[j];
      if (penetration_ > depth_[j]) {
        const StrainPoint before = point(penetration_, depth_[j]);
        remainder -= law_.envelope(before, law_.at_strain(before), rate, largest).value;
      }
      const double middle = std::max(after.strain - v * options_.step / thickness / 2, 0.0);
      const double decay = std::exp(-law_.relaxation(time_ + options_.step / 2, middle) * options_.step);
      trial_stress_[j] = law_.envelope(after, law_.at_strain(after), rate, largest).value + remainder * decay;
      const double pressing =
          std::max(trial_stress_[j], 0.0) * (sphere_radius(impact_.impactor.nose) - depth_[j]);
      if (j > 0) sum += (previous + pressing) / 2 * (depth_[j] - outer);
      outer = depth_[j], previous = pressing;
    }
    sum += previous / 2 * std::max(penetration - outer, 0.0);
    return 2 * std::numbers::pi * sum;
  }

  /// Pad force beyond that of support and dashpot.
  double surplus(double v) {
    trial_force_ = penetration_ + v * options_.step > 0 ? pad_force(v) : 0;
    const double mean = (force_ + trial_force_) / 2;
    const double travel = (velocity_ - mean * options_.step / impact_.impactor.mass / 2) * options_.step;
    const double deflection = motion_ + travel - penetration_ - v * options_.step;
    return trial_force_ - impact_.support.force(deflection) - options_.damping * (travel / options_.step - v);
  }

  /// The first rate in balance on the way on which the surplus drives the pad. The search is over the ninth
  /// root of the rate: of a pad that hardly moves, a rate of 1e-15 m/s the other way may be no balance yet.
  double find_rate() {
    const double scale = std::pow(impact_.impactor.speed, 1.0 / 9);
    const auto rate_of = [](double z) { return z * z * z * z * z * z * z * z * z; };
    double near = std::copysign(std::pow(std::abs(rate_), 1.0 / 9), rate_);
    double f_near = surplus(rate_of(near));
    const double way = f_near > 0 ? -1 : 1;
    double stride = std::max(1e-3 * std::abs(near), 1e-4 * scale);
    double far = near;
    for (double f_far = f_near; f_near * f_far > 0 && stride < 1e3 * scale; stride *= 1.2) {
      near = far, f_near = f_far;
      far = near + way * std::min(stride, 0.03 * scale);
      f_far = surplus(rate_of(far));
    }
    for (int i = 0; i < 100 && std::abs(far - near) > 1e-13 * scale; ++i) {
      const double middle = (near + far) / 2;
      (surplus(rate_of(middle)) * f_near > 0 ? near : far) = middle;
    }
    surplus(rate_of(far));
    return rate_of(far);
  }

  void step() {
    const double v = find_rate();
    if (v < 0 && rate_ >= 0) result_.turnings.push_back(time_);
    if (v > 0 && rate_ <= 0) result_.reloadings.push_back(time_);
    const double mean = (force_ + trial_force_) / 2;
    motion_ += (velocity_ - mean * options_.step / impact_.impactor.mass / 2) * options_.step;
    velocity_ -= mean * options_.step / impact_.impactor.mass;
    penetration_ += v * options_.step;
    largest_ = std::max(largest_, penetration_);
    time_ += options_.step;
    rate_ = v;
    force_ = trial_force_;
    std::swap(stress_, trial_stress_);
    result_.peak_force = std::max(result_.peak_force, force_);
    result_.peak_penetration = largest_;
    if (v < 0 && force_ <= 0) {
      result_.released = true;
      result_.release_time = time_;
      result_.rebound_speed = -velocity_;
    }
  }

  const ImpactCase& impact_;
  Formulas law_;
  DampedOptions options_;
  DampedImpact result_;
  std::vector<double> depth_, stress_, trial_stress_;
  double time_ = 0, motion_ = 0, velocity_, rate_, penetration_ = 0, largest_ = 0, force_ = 0;
  double trial_force_ = 0;
};

template <class Formulas>
DampedImpact run(const ImpactCase& impact, const Formulas& law, const DampedOptions& options) {
  return DampedRun<Formulas>(impact, law, options).run();
}

}  // namespace

DampedImpact solve_damped(const ImpactCase& impact, const DampedOptions& options) {
  if (impact.support.is_rigid()) throw std::invalid_argument("damped oracle: a yielding support only");
  return std::visit(
      [&](const auto& law) -> DampedImpact {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (std::is_same_v<Law, LinearViscoelastic>)
          return run(impact, LinearFormulas(law), options);
        if constexpr (std::is_same_v<Law, NineParameter>) return run(impact, NineFormulas(law), options);
        if constexpr (std::is_same_v<Law, TwentyOneParameter>)
          return run(impact, TwentyOneFormulas(law), options);
        throw std::invalid_argument("damped oracle: a law with memory only");
      },
      impact.pad.material.law);
}

}  // namespace dashpad::oracle
