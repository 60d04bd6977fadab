#include "oracle/layer_pad.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/foam_formulas.hpp"

namespace dashpad::oracle {
namespace {

constexpr double most_stress = 1e15;  ///< Pa, where there is none: a step that was tried too long

/// Where an increasing function of a number is zero.
template <class F>
double halved(double low, double high, const F& f) {
  for (int i = 0; i < 60 && high - low > 1e-13 * std::fabs(high); ++i) {
    const double middle = low + (high - low) / 2;
    (f(middle) > 0 ? high : low) = middle;
  }
  return low + (high - low) / 2;
}

class Layer {
 public:
  virtual ~Layer() = default;
  /// The largest strain of a stress, with what is remembered.
  [[nodiscard]] virtual double strain(double stress, double slipped) const = 0;
  [[nodiscard]] virtual double rate(double strain, double slipped) const = 0;
  [[nodiscard]] virtual double little() const { return 1e-6; }
  virtual void remember(double) {}
};

/// Laws 1 and 2.
class SpringLayer final : public Layer {
 public:
  SpringLayer(double sudden, double lasting, double time) : sudden_(sudden), lasting_(lasting), time_(time) {}
  [[nodiscard]] double strain(double stress, double slipped) const override {
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
  [[nodiscard]] double strain(double stress, double slipped) const override {
    const double reach = 40 * foam_.lag();
    return halved(std::fmax(slipped - reach, 0), slipped + reach, [&](double e) {
      const double u = foam_.slip_rate(e - slipped);
      return foam_.stress(e, 1 - e, std::fmax(largest_ - e, 0), u) - stress;
    });
  }
  [[nodiscard]] double rate(double strain, double slipped) const override {
    return foam_.slip_rate(strain - slipped);
  }
  [[nodiscard]] double little() const override { return 1e-3 * foam_.lag(); }
  void remember(double strain) override { largest_ = std::fmax(largest_, strain); }

 private:
  FoamFormulas foam_;
  double largest_ = 0;
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
  }
  [[nodiscard]] std::size_t unknowns() const override { return layers_.size(); }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool) const override {
    const double free = shortening(0, memory);
    if (y <= free) return {0, 0, std::fmin((y - free) / thickness(), -1e-300)};
    const double stress = stress_of(y, memory);
    return {nose().tip * stress, nose().tip, stress};
  }
  void rates(double y, double, double, const double* memory, double* slope) const override {
    const std::vector<double> strain = strains(y, memory);
    for (std::size_t i = 0; i < layers_.size(); ++i) slope[i] = layers_[i]->rate(strain[i], memory[i]);
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
    const std::vector<double> strain = strains(y, memory);
    for (std::size_t i = 0; i < layers_.size(); ++i) layers_[i]->remember(strain[i]);
  }

 private:
  [[nodiscard]] double shortening(double stress, const double* memory) const {
    double sum = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i)
      sum += thickness_[i] * layers_[i]->strain(stress, memory[i]);
    return sum;
  }
  [[nodiscard]] double stress_of(double y, const double* memory) const {
    const auto excess = [&](double stress) { return shortening(stress, memory) - y; };
    double high = std::fmax(last_ * 1.001, 1.0), low = last_ * 0.999;
    if (excess(high) < 0)
      while (high < most_stress && excess(high) < 0) low = high, high *= 1.5;
    else if (excess(low) > 0)
      while (low > 1e-9 && excess(low) > 0) high = low, low /= 1.5;
    return last_ = halved(low, high, excess);
  }
  [[nodiscard]] std::vector<double> strains(double y, const double* memory) const {
    const double free = shortening(0, memory);
    const double stress = y > free ? stress_of(y, memory) : 0;
    std::vector<double> all;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const double strain = layers_[i]->strain(stress, memory[i]);
      all.push_back(y > free ? strain : y > 0 && free > 0 ? strain * y / free : y / thickness());
    }
    return all;
  }
  std::vector<double> thickness_;
  std::vector<std::unique_ptr<Layer>> layers_;
  mutable double last_ = 1;
};

}  // namespace

std::unique_ptr<PadModel> layer_pad(const Pad& pad, Outline nose, int fineness) {
  return std::make_unique<LayerPad>(pad, std::move(nose), fineness);
}

}  // namespace dashpad::oracle
