#pragma once
/// One column of layers in the general oracle: springs, dashpots and foams in series, written anew from
/// theory.md, Eqs. 51 to 53.
///
///   sum L_i e_i = y,  stress_i(e_i) = stress
///
/// by secants from the last strains on: on the way back there may be several. What is remembered is the
/// strain of each layer that has slipped.

#include <cstddef>
#include <memory>
#include <vector>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::oracle {

class Layer {
 public:
  virtual ~Layer() = default;
  /// Pa; `largest`: strain so far.
  [[nodiscard]] virtual double stress(double strain, double slipped, double largest) const = 0;
  /// The largest strain of a stress, near a guess.
  [[nodiscard]] virtual double strain(double stress, double slipped, double largest, double guess) const = 0;
  /// The strain of a stress as the nose meets it, at an elastic strain.
  [[nodiscard]] virtual double first_strain(double stress, double elastic) const = 0;
  /// The strain of a stress that is reached slowly.
  [[nodiscard]] virtual double slow_strain(double stress, double guess) const = 0;
  /// Of the slipped strain, 1/s.
  [[nodiscard]] virtual double rate(double strain, double slipped) const = 0;
  /// Whether it slips before the nose meets it.
  [[nodiscard]] virtual bool lags() const = 0;
  /// A strain that is small against what the stress depends on.
  [[nodiscard]] virtual double little() const = 0;
};

class LayersOfPad {
 public:
  explicit LayersOfPad(const Pad& pad);
  [[nodiscard]] std::size_t count() const { return layers_.size(); }
  [[nodiscard]] const Layer& of(std::size_t i) const { return *layers_[i]; }
  [[nodiscard]] double thickness(std::size_t i) const { return thickness_[i]; }

 private:
  std::vector<std::unique_ptr<Layer>> layers_;
  std::vector<double> thickness_;
};

/// The stress of a column that is pressed slowly.
class SlowColumn {
 public:
  SlowColumn(const LayersOfPad& layers, double thickness);
  /// Pa, of a shortening above 0, m.
  [[nodiscard]] double stress(double shortening) const;
  /// A shortening below which it is taken as a square, m.
  [[nodiscard]] double first() const { return last_ / cells / cells; }

 private:
  static constexpr double cells = 1000;
  double last_;
  std::vector<double>
      curve_;  ///< stress over the square of 1, 2, .., even steps of the root of the shortening
};

class LayerColumn {
 public:
  LayerColumn(const LayersOfPad& layers, double thickness);
  /// Under the nose, or left by it.
  void press(double shortening, const double* slipped);
  /// Before the nose has met it; returns what its stress then is over the slow one.
  double wait(double shortening, const double* slipped, double little_stress, const SlowColumn& slow);
  void wait_like(const LayerColumn& other);
  /// Pa; of a column that is left, below 0 as if a spring pulled.
  [[nodiscard]] double stress() const { return stress_; }
  [[nodiscard]] bool is_left() const { return pulls_; }
  /// Of what is remembered, at a speed of the nose, m/s.
  void rates(double speed, const double* slipped, double* slope) const;
  void remember();

 private:
  bool is_same(double shortening, const double* slipped, bool waits);
  bool quickly(double shortening, const double* slipped);
  void slowly(double shortening, const double* slipped);

  const LayersOfPad* layers_;
  double thickness_;
  std::vector<double> strain_, largest_, stiffness_, slipped_, share_;
  double shortening_ = -1e300, stress_ = 0, last_ = 1, ratio_ = 1;
  bool waits_ = true, pulls_ = false;
};

}  // namespace dashpad::oracle
