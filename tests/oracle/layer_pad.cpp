#include "oracle/layer_pad.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "oracle/gauss.hpp"
#include "oracle/layer_column.hpp"

namespace dashpad::oracle {
namespace {

struct Powers {
  double one = 0, first = 0, second = 0, third = 0;
  [[nodiscard]] double at(double x) const { return one + x * (first + x * (second + x * third)); }
  [[nodiscard]] double dot(const Powers& b) const {
    return one * b.one + first * b.first + second * b.second + third * b.third;
  }
  friend Powers operator+(const Powers& a, const Powers& b) {
    return {a.one + b.one, a.first + b.first, a.second + b.second, a.third + b.third};
  }
  friend Powers operator*(double factor, const Powers& a) {
    return {factor * a.one, factor * a.first, factor * a.second, factor * a.third};
  }
};

/// Columns at fixed depths. What they press is their stress over that of a column pressed slowly as deep as
/// the nose has been, a cubic of the depth between them.
class LayerPad final : public PadModel {
 public:
  LayerPad(const Pad& pad, Outline nose, int fineness, double deepest)
      : PadModel(std::move(nose), pad.thickness, fineness), layers_(pad), slow_(layers_, pad.thickness) {
    const double last = std::fmin(this->nose().end, deepest);
    const int cells = last == 0 ? 0 : deepest < pad.thickness ? 56 * fineness : 20;
    for (int i = 0; i <= cells; ++i) {
      const double share = cells > 0 ? (1 - std::cos(std::numbers::pi * i / cells)) / 2 : 0;
      depth_.push_back(last * share);
      columns_.emplace_back(layers_, pad.thickness);
    }
    ratio_.resize(depth_.size());
    moments_.resize(depth_.size());
  }
  [[nodiscard]] std::size_t unknowns() const override { return depth_.size() * layers_.count(); }
  [[nodiscard]] bool needs_speed() const override { return depth_.size() > 1; }
  [[nodiscard]] Pressed pressed(double y, const double* memory, bool with_area) const override {
    look(y, memory);
    Pressed all;
    const double on_axis = columns_[0].stress();
    all.most = y > 0 ? on_axis : std::min(y / thickness(), -1e-300);
    if (nose().tip > 0 && on_axis > 0) all.force = nose().tip * on_axis, all.area = nose().tip;
    for (std::size_t j = 0; j + 1 < depth_.size() && depth_[j] < y; ++j) {
      all.most = std::fmax(all.most, columns_[j].stress());
      add_cell(j, std::fmin(depth_[j + 1], y), with_area, all);
    }
    return all;
  }
  void rates(double y, double speed, double, const double* memory, double* slope) const override {
    look(y, memory);
    for (std::size_t j = 0; j < depth_.size(); ++j)
      columns_[j].rates(speed, memory + j * layers_.count(), slope + j * layers_.count());
  }
  void allowances(double relative, const double*, double* allowance) const override {
    const std::size_t count = layers_.count();
    for (std::size_t i = 0; i < unknowns(); ++i)
      allowance[i] = relative * 1e4 * layers_.of(i % count).little();
  }
  [[nodiscard]] double little() const override {
    double least = 1;
    for (std::size_t i = 0; i < layers_.count(); ++i) least = std::fmin(least, layers_.of(i).little());
    return least * thickness();
  }

 protected:
  void remember(double y, const double* memory) override {
    look(y, memory);
    for (LayerColumn& column : columns_) column.remember();
  }

 private:
  void look(double y, const double* memory) const {
    const double deep = std::fmax(y, largest());
    std::size_t waiting = depth_.size();
    for (std::size_t j = 0; j < depth_.size(); ++j) {
      const double* slipped = memory + j * layers_.count();
      LayerColumn& column = columns_[j];
      const double reached = deep - depth_[j];
      if (reached > slow_.first()) {
        column.press(y - depth_[j], slipped);
        ratio_[j] = column.stress() / slow_.stress(reached);
      } else if (waiting < j && same_slip(memory, waiting, j)) {
        column.wait_like(columns_[waiting]);
        ratio_[j] = ratio_[waiting];
      } else {
        ratio_[j] = column.wait(y - depth_[j], slipped, slow_.stress(slow_.first()), slow_);
        waiting = j;
      }
    }
    deep_ = deep;
  }
  [[nodiscard]] bool same_slip(const double* memory, std::size_t a, std::size_t b) const {
    const std::size_t count = layers_.count();
    return std::equal(memory + a * count, memory + (a + 1) * count, memory + b * count);
  }

  /// Of a cell from a to b: the integrals of the slow stress and its products with powers of the number of a
  /// column, counted from the cell's first.
  struct Moments {
    double deep = -1, a = 0, b = 0;
    Powers of{};
  };

  /// The cubic of the ratio in the cell j, with slopes from the columns about it.
  [[nodiscard]] Powers cubic(std::size_t j) const {
    const auto slope_at = [&](std::size_t k) {  // per number of a column
      if (k == 0) return ratio_[1] - ratio_[0];
      if (k + 1 == ratio_.size()) return ratio_[k] - ratio_[k - 1];
      return (ratio_[k + 1] - ratio_[k - 1]) / 2;
    };
    const double here = ratio_[j], rise = ratio_[j + 1] - here, first = slope_at(j), last = slope_at(j + 1);
    return {here, first, 3 * rise - 2 * first - last, first + last - 2 * rise};
  }
  /// The numbers of columns grow like an angle, over which the ratio is even at both ends.
  [[nodiscard]] double number(double depth) const {
    return std::acos(std::clamp(1 - 2 * depth / depth_.back(), -1.0, 1.0)) / std::numbers::pi *
           double(depth_.size() - 1);
  }
  void add_cell(std::size_t j, double to, bool with_area, Pressed& all) const {
    if (!(ratio_[j] > 0) && !(ratio_[j + 1] > 0)) return;
    const Powers ratio = cubic(j);
    double a = depth_[j], b = to;
    if ((ratio_[j] > 0) != (ratio_[j + 1] > 0)) {
      double positive = ratio_[j] > 0 ? 0 : 1, other = 1 - positive;
      for (int k = 0; k < 50; ++k) {
        const double middle = (positive + other) / 2;
        (ratio.at(middle) > 0 ? positive : other) = middle;
      }
      const double angle = std::numbers::pi * (double(j) + positive) / double(depth_.size() - 1);
      const double end = depth_.back() * (1 - std::cos(angle)) / 2;
      if (ratio_[j] > 0)
        b = std::fmin(to, end);
      else
        a = end;
      if (!(b > a)) return;
    }
    if (with_area) all.area += nose().area(b) - nose().area(a);
    Moments& moments = moments_[j];
    if (moments.deep != deep_ || moments.a != a || moments.b != b)
      moments = {deep_, a, b, integrals(j, a, b)};
    all.force += ratio.dot(moments.of);
  }
  [[nodiscard]] Powers integrals(std::size_t j, double a, double b) const {
    std::vector<double> ends{a, b};
    for (const double corner : nose().corners)
      if (a < corner && corner < b) ends.push_back(corner);
    // Towards the edge the stress begins steeply.
    for (double left = (deep_ - a) / 3; left > 1e-3 * deep_ && deep_ - left < b; left /= 3)
      ends.push_back(deep_ - left);
    std::ranges::sort(ends);
    Powers sum;
    for (std::size_t i = 1; i < ends.size();
         ++i)  // in the root of the depth: a' may have no bound at the tip
      sum = sum + gauss(std::sqrt(ends[i - 1]), std::sqrt(ends[i]), 1, [&](double root) {
              const double depth = root * root, share = number(depth) - double(j);
              const double weight = slow_.stress(deep_ - depth) * nose().widening(depth) * 2 * root;
              return Powers{weight, weight * share, weight * share * share, weight * share * share * share};
            });
    return sum;
  }

  LayersOfPad layers_;
  SlowColumn slow_;
  std::vector<double> depth_;
  mutable std::vector<LayerColumn> columns_;
  mutable std::vector<double> ratio_;
  mutable std::vector<Moments> moments_;
  mutable double deep_ = 0;
};

}  // namespace

std::unique_ptr<PadModel> layer_pad(const Pad& pad, Outline nose, int fineness, double deepest) {
  return std::make_unique<LayerPad>(pad, std::move(nose), fineness, deepest);
}

}  // namespace dashpad::oracle
