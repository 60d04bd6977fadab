#include "oracle/layer_pad.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/foam_formulas.hpp"

namespace dashpad::oracle {
namespace {

constexpr double most_stress = 1e15;  ///< Pa, where there is none: a step that was tried too long

/// Where an increasing function of a number is zero, from a guess on; no farther than `low` and `high`.
template <class F>
double increasing_root(double guess, double stride, double low, double high, const F& f) {
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

class Layer {
 public:
  virtual ~Layer() = default;
  /// The largest strain of a stress, with what is remembered, near a guess.
  [[nodiscard]] virtual double strain(double stress, double slipped, double largest, double guess) const = 0;
  [[nodiscard]] virtual double rate(double strain, double slipped) const = 0;
  [[nodiscard]] virtual double little() const { return 1e-6; }
};

/// Laws 1 and 2.
class SpringLayer final : public Layer {
 public:
  SpringLayer(double sudden, double lasting, double time) : sudden_(sudden), lasting_(lasting), time_(time) {}
  [[nodiscard]] double strain(double stress, double slipped, double, double) const override {
    return (stress + (sudden_ - lasting_) * slipped) / sudden_;
  }
  [[nodiscard]] double rate(double strain, double slipped) const override {
    return (strain - slipped) / time_;
  }

 private:
  double sudden_, lasting_, time_;
};

class FoamLayer final : public Layer {
 public:
  template <class Law>
  explicit FoamLayer(const Law& law) : foam_(law) {}
  [[nodiscard]] double strain(double stress, double slipped, double largest, double guess) const override {
    const double reach = 40 * foam_.lag();
    return increasing_root(guess, 1e-2 * foam_.lag(), std::fmax(slipped - reach, 0),
                           std::fmin(slipped + reach, 1 - 1e-12), [&](double e) {
                             const double u = foam_.slip_rate(e - slipped);
                             return foam_.stress(e, 1 - e, std::fmax(largest - e, 0), u) - stress;
                           });
  }
  [[nodiscard]] double rate(double strain, double slipped) const override {
    const double reach = 60 * foam_.lag();
    return foam_.slip_rate(std::clamp(strain - slipped, -reach, reach));
  }
  [[nodiscard]] double little() const override { return 1e-3 * foam_.lag(); }

 private:
  FoamFormulas foam_;
};

std::unique_ptr<Layer> layer_of(const PadLaw& law) {
  if (const auto* of = std::get_if<Elastic>(&law))
    return std::make_unique<SpringLayer>(of->modulus, of->modulus, 1);
  if (const auto* of = std::get_if<LinearViscoelastic>(&law))
    return std::make_unique<SpringLayer>(of->initial_modulus, of->asymptotic_modulus, of->relaxation_time);
  if (const auto* of = std::get_if<Foam>(&law)) return std::make_unique<FoamLayer>(*of);
  return std::make_unique<FoamLayer>(std::get<CrushableFoam>(law));
}

class LayerPad final : public PadModel {
 public:
  LayerPad(const Pad& pad, Outline nose, int fineness) : PadModel(std::move(nose), pad.thickness, fineness) {
    if (this->nose().end > 0) throw std::invalid_argument("oracle: layers below a flat face only");
    for (const PadLayer& layer : pad.layers) {
      thickness_.push_back(layer.thickness);
      layers_.push_back(layer_of(scaled(layer.material.law, stress_factor(layer.condition, layer.material))));
    }
    largest_.assign(layers_.size(), 0);
    strain_ = largest_;
  }
  [[nodiscard]] std::size_t unknowns() const override { return layers_.size(); }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool) const override {
    const double stress = solve(y, memory);
    return stress > 0 ? Pressed{nose().tip * stress, nose().tip, stress} : Pressed{0, 0, stress};
  }
  void rates(double y, double, double, const double* memory, double* slope) const override {
    solve(y, memory);
    for (std::size_t i = 0; i < layers_.size(); ++i) slope[i] = layers_[i]->rate(strain_[i], memory[i]);
  }
  void allowances(double relative, double* allowance) const override {
    for (std::size_t i = 0; i < layers_.size(); ++i) allowance[i] = relative * 1e3 * layers_[i]->little();
  }
  [[nodiscard]] double little() const override {
    double least = 1;
    for (const auto& layer : layers_) least = std::fmin(least, layer->little());
    return least * thickness();
  }

 protected:
  void remember(double y, const double* memory) override {
    solve(y, memory);
    for (std::size_t i = 0; i < layers_.size(); ++i) largest_[i] = std::fmax(largest_[i], strain_[i]);
  }

 private:
  /// The stress, Pa, and the strains; where nothing presses, by how much of the thickness the pad is left,
  /// below zero.
  double solve(double y, const double* memory) const {
    const std::vector<double> before = strain_;  // the root next to it is taken
    const auto excess = [&](double stress) {
      double sum = -y;
      for (std::size_t i = 0; i < layers_.size(); ++i) {
        strain_[i] = layers_[i]->strain(stress, memory[i], largest_[i], before[i]);
        sum += thickness_[i] * strain_[i];
      }
      return sum;
    };
    const double over = excess(0);
    if (over < 0) {
      last_ = increasing_root(last_, 1e-4 * last_, 0, most_stress, excess);
      excess(last_);
      return last_ = std::fmax(last_, 1e-3);
    }
    const double free = over + y;
    for (double& strain : strain_) strain = y > 0 && free > 0 ? strain * y / free : y / thickness();
    return std::fmin(-over / thickness(), -1e-300);
  }

  std::vector<double> thickness_;
  std::vector<std::unique_ptr<Layer>> layers_;
  std::vector<double> largest_;
  mutable std::vector<double> strain_;
  mutable double last_ = 1;
};

}  // namespace

std::unique_ptr<PadModel> layer_pad(const Pad& pad, Outline nose, int fineness) {
  return std::make_unique<LayerPad>(pad, std::move(nose), fineness);
}

}  // namespace dashpad::oracle
