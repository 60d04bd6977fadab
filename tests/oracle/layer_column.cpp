#include "oracle/layer_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/foam_formulas.hpp"

namespace dashpad::oracle {
namespace {

constexpr double max_stress = 1e15;  ///< Pa, where there is none: a step that was tried too long

/// Where an increasing function of a number is zero, from a guess on; no farther than `low` and `high`. A
/// step that was tried too long may have left no room between them: `high` then.
template <class F>
double increasing_root(double guess, double stride, double low, double high, const F& f) {
  low = std::fmin(low, high);
  double a = std::clamp(guess, low, high), fa = f(a), b = a, fb = fa;
  const double way = fa < 0 ? 1 : -1;
  for (; fa * fb > 0 && (way > 0 ? b < high : b > low); stride *= 4) {
    a = b, fa = fb;
    b = std::clamp(b + way * stride, low, high), fb = f(b);
  }
  if (fa * fb > 0) return b;
  double x = b;
  for (int i = 0, side = 0; i < 100 && std::fabs(b - a) > 1e-13 * std::fabs(b) && fb != 0; ++i) {  // Illinois
    x = fa == fb || i % 8 == 7 ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
    const double fx = f(x);
    if (fx == 0 || x == a || x == b) return x;
    const int now = fx * fa > 0 ? -1 : 1;
    (now < 0 ? a : b) = x, (now < 0 ? fa : fb) = fx;
    if (side == now) (now < 0 ? fb : fa) /= 2;
    side = now;
  }
  return x;
}

/// Laws 1 and 2.
class SpringLayer final : public Layer {
 public:
  SpringLayer(double sudden, double lasting, double time) : sudden_(sudden), lasting_(lasting), time_(time) {}
  [[nodiscard]] double stress(double strain, double slipped, double) const override {
    return sudden_ * strain - (sudden_ - lasting_) * slipped;
  }
  [[nodiscard]] double strain(double stress, double slipped, double, double) const override {
    return (stress + (sudden_ - lasting_) * slipped) / sudden_;
  }
  [[nodiscard]] double first_strain(double stress, double) const override { return stress / sudden_; }
  [[nodiscard]] double slow_strain(double stress, double) const override { return stress / sudden_; }
  [[nodiscard]] double rate(double strain, double slipped) const override {
    return (strain - slipped) / time_;
  }
  [[nodiscard]] bool lags() const override { return false; }
  [[nodiscard]] double little() const override { return 1e-6; }

 private:
  double sudden_, lasting_, time_;
};

class FoamLayer final : public Layer {
 public:
  template <class Law>
  explicit FoamLayer(const Law& law) : foam_(law) {}
  [[nodiscard]] double stress(double strain, double slipped, double largest) const override {
    return foam_.stress(strain, 1 - strain, std::fmax(largest - strain, 0), rate(strain, slipped));
  }
  [[nodiscard]] double strain(double stress, double slipped, double largest, double guess) const override {
    const double reach = 40 * foam_.lag();
    return increasing_root(guess, 1e-2 * foam_.lag(), std::fmax(slipped - reach, 0),
                           std::fmin(slipped + reach, most),
                           [&](double e) { return this->stress(e, slipped, largest) - stress; });
  }
  [[nodiscard]] double first_strain(double stress, double elastic) const override {
    const double u = rate(elastic, 0);
    return increasing_root(1e-6, 1e-6, 0, most,
                           [&](double e) { return foam_.stress(e, 1 - e, 0, u) - stress; });
  }
  [[nodiscard]] double slow_strain(double stress, double guess) const override {
    return increasing_root(guess, 1e-3 * guess + 1e-9, 0, most,
                           [&](double e) { return (e > 0 ? foam_.base(e, 1 - e) : 0) - stress; });
  }
  [[nodiscard]] double rate(double strain, double slipped) const override {
    const double reach = 60 * foam_.lag();
    return foam_.slip_rate(std::clamp(strain - slipped, -reach, reach));
  }
  [[nodiscard]] bool lags() const override { return true; }
  [[nodiscard]] double little() const override { return 1e-3 * foam_.lag(); }

 private:
  static constexpr double most = 1 - 1e-12;
  FoamFormulas foam_;
};

std::unique_ptr<Layer> layer_of(const PadLaw& law) {
  if (const auto* given = std::get_if<Elastic>(&law))
    return std::make_unique<SpringLayer>(given->modulus, given->modulus, 1);
  if (const auto* given = std::get_if<LinearViscoelastic>(&law))
    return std::make_unique<SpringLayer>(given->initial_modulus, given->asymptotic_modulus,
                                         given->relaxation_time);
  if (const auto* given = std::get_if<Foam>(&law)) return std::make_unique<FoamLayer>(*given);
  return std::make_unique<FoamLayer>(std::get<CrushableFoam>(law));
}

}  // namespace

LayersOfPad::LayersOfPad(const Pad& pad) {
  for (const PadLayer& layer : pad.layers) {
    thickness_.push_back(layer.thickness);
    layers_.push_back(layer_of(scaled(layer.material.law, stress_factor(layer.condition, layer.material))));
  }
}

SlowColumn::SlowColumn(const LayersOfPad& layers, double thickness) : last_(0.995 * thickness) {
  std::vector<double> strain(layers.count(), 0.0);
  double last = 1;
  for (int i = 1; i <= cells; ++i) {
    const double shortening = last_ * i * i / cells / cells;
    const auto excess = [&](double stress) {
      double sum = -shortening;
      for (std::size_t k = 0; k < layers.count(); ++k) {
        strain[k] = layers.of(k).slow_strain(stress, strain[k]);
        sum += layers.thickness(k) * strain[k];
      }
      return sum;
    };
    last = increasing_root(last, 1e-2 * last, 0, max_stress, excess);
    curve_.push_back(last / (double(i) * i));
  }
}

double SlowColumn::stress(double shortening) const {
  const double place = std::sqrt(std::fmax(shortening, 0) / last_) * cells;
  if (place <= 1) return curve_[0] * place * place;
  const auto i = std::min(static_cast<std::size_t>(place), curve_.size() - 1) - 1;
  return (curve_[i] + (place - double(i + 1)) * (curve_[i + 1] - curve_[i])) * place * place;
}

LayerColumn::LayerColumn(const LayersOfPad& layers, double thickness)
    : layers_(&layers),
      thickness_(thickness),
      strain_(layers.count(), 0.0),
      largest_(strain_),
      stiffness_(strain_),
      slipped_(strain_),
      share_(strain_) {}

bool LayerColumn::is_same(double shortening, const double* slipped, bool waits) {
  if (shortening == shortening_ && waits == waits_ && std::equal(slipped_.begin(), slipped_.end(), slipped))
    return true;
  shortening_ = shortening;
  std::copy_n(slipped, slipped_.size(), slipped_.begin());
  return false;
}

double LayerColumn::wait(double shortening, const double* slipped, double little_stress,
                         const SlowColumn& slow) {
  if (is_same(shortening, slipped, true)) return ratio_;
  waits_ = true;
  double sum = 0;
  for (std::size_t i = 0; i < share_.size(); ++i) {
    share_[i] = layers_->of(i).first_strain(little_stress, -slipped[i]);
    sum += layers_->thickness(i) * share_[i];
  }
  for (double& share : share_) share /= sum;
  ratio_ = little_stress / slow.stress(sum);
  stress_ = shortening > 0 ? ratio_ * slow.stress(shortening) : std::fmin(shortening / thickness_, -1e-300);
  return ratio_;
}

void LayerColumn::wait_like(const LayerColumn& other) {
  waits_ = true;
  share_ = other.share_, stress_ = other.stress_, ratio_ = other.ratio_;
  shortening_ = -1e300;
}

void LayerColumn::press(double shortening, const double* slipped) {
  const bool waited = waits_;
  if (is_same(shortening, slipped, false)) return;
  waits_ = pulls_ = false;
  if (waited)
    for (std::size_t i = 0; i < strain_.size(); ++i) strain_[i] = share_[i] * std::fmax(shortening, 0);
  const std::vector<double> before = strain_;
  if (quickly(shortening, slipped)) return;
  strain_ = before;
  slowly(shortening, slipped);
}

bool LayerColumn::quickly(double shortening, const double* slipped) {
  if (!(shortening > 0) || stress_ <= 0) return false;
  const std::size_t count = strain_.size();
  std::array<double, 8> at{}, move{};
  if (count > at.size()) return false;
  for (int k = 0; k < 20; ++k) {
    double flexibility = 0, sum = shortening;
    for (std::size_t i = 0; i < count; ++i) {
      const Layer& layer = layers_->of(i);
      const double now = layer.stress(strain_[i], slipped[i], largest_[i]);
      const double secant = k > 0 ? (now - at[i]) / move[i] : 0;
      if (std::fabs(move[i]) > 1e-11 && secant > 0) stiffness_[i] = secant;
      if (k == 0 && !(stiffness_[i] > 0)) {
        const double little = std::fmin(layer.little(), strain_[i] / 10);
        stiffness_[i] = (layer.stress(strain_[i] + little, slipped[i], largest_[i]) - now) / little;
      }
      if (!(stiffness_[i] > 0)) return false;
      at[i] = now;
      flexibility += layers_->thickness(i) / stiffness_[i];
      sum += layers_->thickness(i) * (now / stiffness_[i] - strain_[i]);
    }
    const double stress = sum / flexibility;
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double longest = 2e3 * layers_->of(i).little();
      move[i] = std::clamp((stress - at[i]) / stiffness_[i], -longest, longest);
      strain_[i] += move[i];
      if (!(strain_[i] > 0 && strain_[i] < 1)) return false;
      most = std::fmax(most, std::fabs(move[i]));
    }
    if (most > 1e-12) continue;
    if (!(stress > 0)) return false;
    stress_ = last_ = stress;
    return true;
  }
  return false;
}

void LayerColumn::slowly(double shortening, const double* slipped) {
  const std::vector<double> before = strain_;  // the root next to it is taken
  const auto excess = [&](double stress) {
    double sum = -shortening;
    for (std::size_t i = 0; i < strain_.size(); ++i) {
      strain_[i] = layers_->of(i).strain(stress, slipped[i], largest_[i], before[i]);
      sum += layers_->thickness(i) * strain_[i];
    }
    return sum;
  };
  const double over = excess(0);
  if (over < 0) {
    last_ = increasing_root(last_, 1e-4 * last_, 0, max_stress, excess);
    excess(last_);
    stress_ = last_ = std::fmax(last_, 1e-3);
    return;
  }
  double flexibility = 0;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const Layer& layer = layers_->of(i);
    const double little = layer.little() / 10;
    const double rise = layer.stress(strain_[i] + little, slipped[i], largest_[i]) -
                        layer.stress(strain_[i], slipped[i], largest_[i]);
    if (rise > 0) flexibility += layers_->thickness(i) * little / rise;
  }
  const double free = over + shortening;
  for (double& strain : strain_)
    strain = shortening > 0 && free > 0 ? strain * shortening / free : shortening / thickness_;
  pulls_ = true;
  stress_ = std::fmin(flexibility > 0 ? -over / flexibility : -over / thickness_, -1e-300);
}

void LayerColumn::rates(double speed, const double* slipped, double* slope) const {
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const Layer& layer = layers_->of(i);
    if (!waits_)
      slope[i] = layer.rate(strain_[i], slipped[i]);
    else
      slope[i] = layer.lags() ? layer.rate(0, slipped[i]) - share_[i] * speed : 0;
  }
}

void LayerColumn::remember() {
  if (waits_) return;
  for (std::size_t i = 0; i < strain_.size(); ++i) largest_[i] = std::fmax(largest_[i], strain_[i]);
}

}  // namespace dashpad::oracle
