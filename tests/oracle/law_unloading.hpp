#pragma once
/// Columns of laws 4 and 5 once the pad has turned, in the general oracle: at fixed depths, each with its
/// stress, of which only the positive part presses.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "oracle/contact_grid.hpp"
#include "oracle/gauss.hpp"
#include "oracle/law_formulas.hpp"
#include "oracle/outline.hpp"
#include "oracle/pressed.hpp"

namespace dashpad::oracle {

template <class Formulas>
class LawUnloading {
 public:
  using Rate = typename Formulas::Rate;
  /// `turned`: penetration where the pad turned; `deepest`: one that it does not exceed, m.
  LawUnloading(const Formulas& law, const Outline& nose, double thickness, int fineness, double turned,
               double deepest)
      : law_(law), nose_(nose), thickness_(thickness), turned_(turned) {
    const double first = std::fmin(nose.end, turned), last = std::fmin(nose.end, deepest);
    const int cells = first > 0 ? 320 * fineness : 0,
              more = last > first ? static_cast<int>(300 * fineness * (1 - first / last)) + 8 : 0;
    const Grading grading{std::clamp((thickness - turned) / turned, 1e-6, 0.02), 3};
    for (int i = 0; i <= cells + more; ++i)
      depth_.push_back(i == 0       ? 0
                       : i <= cells ? first * grid_point(double(i) / cells, grading).share
                                    : first + (last - first) * (i - cells) / more);
    for (std::size_t j = 0; j + 1 < depth_.size(); ++j) add_cell(j);
    columns_.resize(depth_.size());
  }
  [[nodiscard]] const std::vector<double>& depths() const { return depth_; }

  void prepare(double y, double largest, double time) {
    if (y == y_ && time == time_ && largest == largest_) return;
    y_ = y, time_ = time, largest_ = largest;
    for (std::size_t j = 0; j < depth_.size(); ++j) {
      Column& column = columns_[j];
      column.pressed = y > depth_[j];
      if (!column.pressed) continue;
      const double strain = std::fmax((y - depth_[j]) / thickness_, 1e-12);
      column.point = strain_point(strain, (thickness_ - y + depth_[j]) / thickness_, law_.m(), law_.n());
      column.terms = law_.at_strain(column.point);
      column.relaxation = law_.relaxation(time, strain);
      column.before = (std::fmax(largest, y) - depth_[j]) / thickness_;
    }
  }
  /// The end of a step. A column lets go with a stress without bound, and what it has when the nose meets it
  /// again is open.
  void note(double y) {
    left_.resize(depth_.size());
    for (std::size_t j = 0; j < depth_.size(); ++j) {
      if (left_[j] && y > depth_[j])
        throw std::invalid_argument("oracle: laws 4 and 5 that are met again where the nose had left them");
      left_[j] = y <= depth_[j] && depth_[j] < turned_;
    }
  }
  /// As it was prepared last.
  [[nodiscard]] double rate(std::size_t j, const Rate& rate, const double* stress) const {
    const Column& column = columns_[j];
    if (!column.pressed) return 0;
    const Envelope envelope = law_.envelope(column.point, column.terms, rate, column.before);
    // A column that has let go does not press again of itself (Eq. 7); how it is pulled shows in nothing.
    if (stress[j] <= 0 && envelope.value < 0) return 0;
    return law_.envelope_rate(envelope, rate) + column.relaxation * (envelope.value - stress[j]);
  }
  [[nodiscard]] Pressed pressed(double y, const double* stress) const {
    Pressed all;
    all.most = stress[0];
    if (nose_.tip > 0 && stress[0] > 0) all.force = nose_.tip * stress[0], all.area = nose_.tip;
    for (std::size_t j = 0; j < cells_.size() && depth_[j] < y; ++j) {
      if (is_inside(j, y, stress)) {
        for (std::size_t k = 0; k < 4; ++k) all.force += cells_[j].weight[k] * stress[cells_[j].first + k];
        all.area += cells_[j].area;
      } else {
        const End end = end_of(j, y, stress);
        all.force += end.met * end.part() * end.positive / 2 + end.met * end.other_positive() / 2;
        all.area += end.met * end.part();
      }
      if (depth_[j + 1] < y) all.most = std::fmax(all.most, stress[j + 1]);
    }
    return all;
  }
  /// dF/dt, N/s, as it was prepared last.
  [[nodiscard]] double force_rate(const Rate& rate, const double* stress) const {
    std::vector<double>& slope = slope_;
    slope.resize(depth_.size());
    for (std::size_t j = 0; j < depth_.size(); ++j) slope[j] = this->rate(j, rate, stress);
    double sum = nose_.tip > 0 && stress[0] > 0 ? nose_.tip * slope[0] : 0;
    for (std::size_t j = 0; j < cells_.size() && depth_[j] < y_; ++j) {
      if (is_inside(j, y_, stress)) {
        for (std::size_t k = 0; k < 4; ++k) sum += cells_[j].weight[k] * slope[cells_[j].first + k];
        continue;
      }
      const End end = end_of(j, y_, stress);
      if (end.is_edge && stress[j] > 0)  // it moves with the penetration
        sum += rate.rate * thickness_ * cells_[j].area / (depth_[j + 1] - depth_[j]) * stress[j] / 2;
      const double p = end.positive, n = end.negative;
      if (p <= 0) continue;
      const double here = slope[j], next = end.is_edge ? 0 : slope[j + 1];
      if (n <= 0 && !end.is_edge) {
        sum += end.met * (here + next) / 2;
        continue;
      }
      const double of_p = stress[j] > 0 ? here : next, of_n = stress[j] > 0 ? -next : -here;
      sum += end.met * ((p * p + 2 * p * n) * of_p - p * p * of_n) / (2 * (p + n) * (p + n));
    }
    return sum;
  }

 private:
  struct Column {
    bool pressed = false;
    StrainPoint point;
    typename Formulas::Column terms;
    double relaxation = 0, before = 0;
  };
  /// Between two columns: the integral of a stress that is a cubic in their numbers through those of four.
  struct Cell {
    std::size_t first = 0;
    std::array<double, 4> weight{};
    double area = 0;
  };
  /// A cell in which the pressure ends, where the stress is a line.
  struct End {
    double met = 0;  ///< m2
    double positive = 0, negative = 0, other = 0;
    bool is_edge = false;
    [[nodiscard]] double part() const { return positive > 0 ? positive / (positive + negative) : 0; }
    [[nodiscard]] double other_positive() const { return other; }
  };

  void add_cell(std::size_t j) {
    Cell cell;
    const std::size_t count = depth_.size();
    cell.area = nose_.area(depth_[j + 1]) - nose_.area(depth_[j]);
    cell.first = std::min(j > 0 ? j - 1 : 0, count > 3 ? count - 4 : 0);
    std::vector<double> ends{depth_[j], depth_[j + 1]};
    for (const double corner : nose_.corners)
      if (depth_[j] < corner && corner < depth_[j + 1]) ends.push_back(corner);
    std::ranges::sort(ends);
    for (std::size_t k = 0; k < 4 && count > 3; ++k)
      for (std::size_t i = 1; i < ends.size(); ++i) {
        // In the root of the depth: also where the widening has no bound at the tip.
        cell.weight[k] += gauss(std::sqrt(ends[i - 1]), std::sqrt(ends[i]), 1, [&](double root) {
          const double depth = root * root;
          return basis(cell.first, k, number(j, depth)) * nose_.widening(depth) * 2 * root;
        });
      }
    cells_.push_back(cell);
  }
  /// The number of a depth in the cell j, by the quadratic or cubic through depths of the columns about it.
  [[nodiscard]] double number(std::size_t j, double depth) const {
    double low = double(j), high = double(j + 1);
    const std::size_t first = std::min(j > 0 ? j - 1 : 0, depth_.size() - 4);
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      double at = 0;
      for (std::size_t k = 0; k < 4; ++k) at += basis(first, k, middle) * depth_[first + k];
      (at < depth ? low : high) = middle;
    }
    return (low + high) / 2;
  }
  [[nodiscard]] static double basis(std::size_t first, std::size_t k, double number) {
    double product = 1;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != k) product *= (number - double(first + i)) / (double(k) - double(i));
    return product;
  }
  [[nodiscard]] bool is_inside(std::size_t j, double y, const double* stress) const {
    const std::size_t first = cells_[j].first;
    if (first + 3 >= depth_.size() || depth_[first + 3] > y) return false;
    return stress[first] > 0 && stress[first + 1] > 0 && stress[first + 2] > 0 && stress[first + 3] > 0;
  }
  [[nodiscard]] End end_of(std::size_t j, double y, const double* stress) const {
    End end;
    const double share = std::fmin((y - depth_[j]) / (depth_[j + 1] - depth_[j]), 1);
    end.is_edge = share < 1;
    end.met = share * cells_[j].area;
    const double here = stress[j], next = end.is_edge ? 0 : stress[j + 1];
    end.positive = std::fmax(here, next);
    end.negative = std::fmax(-std::fmin(here, next), 0);
    if (here > 0 && next > 0) end.other = std::fmin(here, next);
    return end;
  }

  Formulas law_;
  const Outline& nose_;
  double thickness_;
  double turned_;  ///< penetration, m
  std::vector<double> depth_;
  std::vector<Cell> cells_;
  std::vector<Column> columns_;
  std::vector<char> left_;
  mutable std::vector<double> slope_;
  double y_ = -1, time_ = -1, largest_ = -1;
};

}  // namespace dashpad::oracle
