#pragma once
/// Columns of laws 4 and 5 while the pad is pressed for the first time, in the general oracle: at fixed
/// shares s/Y of the growing contact (Chebyshev points), where stress/A is smooth in place and time. Below a
/// flat face there is one.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "oracle/contact_grid.hpp"
#include "oracle/contact_points.hpp"
#include "oracle/law_formulas.hpp"
#include "oracle/outline.hpp"

namespace dashpad::oracle {

template <class Formulas>
class LawLoading {
 public:
  using Rate = typename Formulas::Rate;
  /// `gap`: about the least that is left of the pad, in thicknesses.
  LawLoading(const Formulas& law, const Outline& nose, double thickness, int fineness, double gap)
      : law_(law),
        nose_(nose),
        thickness_(thickness),
        fineness_(fineness),
        grid_(40 + 8 * fineness, {std::clamp(4 * gap, 1e-5, 0.02), 5}),
        inner_(nose.end > 0 ? grid_.points.size() - 1 : 1) {
    for (std::size_t i = 0; i < inner_; ++i) {
      log_rest_.push_back(std::log(grid_.points[i].rest));
      // Of the polynomial through the columns inside the edge.
      barycentric_.push_back(grid_.barycentric[i] * (1 - grid_.z[i]));
    }
  }
  [[nodiscard]] std::size_t unknowns() const { return inner_; }

  /// `time`: where rates are asked for.
  void prepare(double y, const double* ratios, std::optional<double> time) {
    places_.clear();
    singular_ = 0;
    for (const ContactPoint& place : contact_points(nose_, y, thickness_ - y, fineness_)) {
      const StrainPoint strain_point = at(y, place);
      places_.push_back(
          {strain_point, {}, place.area * strain_point.shape, ratio_at(place.above / y, ratios), 0});
      if (!time) continue;
      places_.back().terms = law_.at_strain(strain_point);
      places_.back().relaxation = law_.relaxation(*time, strain_point.strain);
      singular_ += place.area * strain_point.shape * strain_point.log_slope / thickness_;
    }
  }
  /// At what was prepared last, N and N/s.
  [[nodiscard]] double force() const {
    double sum = 0;
    for (const Place& place : places_) sum += place.weight * place.ratio;
    return sum;
  }
  [[nodiscard]] double force_rate(const Rate& rate, double speed) const {
    double sum = law_.edge(rate) * singular_ * speed;
    for (const Place& place : places_)
      sum += place.weight * law_.regular(place.point, place.terms, rate, place.ratio, place.relaxation);
    return sum;
  }
  void rates(double y, double time, const Rate& rate, const double* ratios, double* slope) const {
    const double edge = law_.edge(rate), growth = rate.rate * thickness_ / y;
    const double log_scale = std::log(y / thickness_);
    for (std::size_t i = 0; i < inner_; ++i) {
      const GridPoint& place = grid_.points[i];
      const double strain = y * place.rest / thickness_;
      const StrainPoint of = strain_point(strain, (thickness_ - y + y * place.share) / thickness_,
                                          log_scale + log_rest_[i], law_.m(), law_.n());
      double gradient = 0;
      if (inner_ > 1) {
        const double* row = &grid_.differentiate[i * (inner_ + 1)];
        for (std::size_t j = 0; j < inner_; ++j) gradient += row[j] * (ratios[j] - edge);  // less rounding
      }
      slope[i] = (edge - ratios[i]) * of.log_slope * rate.rate +
                 law_.regular(of, law_.at_strain(of), rate, ratios[i], law_.relaxation(time, strain)) +
                 gradient * place.share * growth;
    }
  }
  /// Of the column at a depth, Pa.
  [[nodiscard]] double stress(double y, double depth, const double* ratios) const {
    return depth < y ? at(y, {depth, y - depth, 0}).shape * ratio_at((y - depth) / y, ratios) : 0;
  }

 private:
  struct Place {
    StrainPoint point;
    typename Formulas::Column terms;
    double weight = 0, ratio = 0, relaxation = 0;
  };
  [[nodiscard]] StrainPoint at(double y, const ContactPoint& place) const {
    return strain_point(place.above / thickness_, (thickness_ - y + place.depth) / thickness_, law_.m(),
                        law_.n());
  }
  /// `rest`: 1 - s/Y.
  [[nodiscard]] double ratio_at(double rest, const double* ratios) const {
    if (inner_ == 1) return ratios[0];
    const double z = grid_coordinate(rest, grid_.grading);
    double numerator = 0, denominator = 0;
    for (std::size_t i = 0; i < inner_; ++i) {
      const double distance = z - grid_.z[i];
      if (distance == 0) return ratios[i];
      const double weight = barycentric_[i] / distance;
      numerator += weight * ratios[i], denominator += weight;
    }
    return numerator / denominator;
  }

  Formulas law_;
  const Outline& nose_;
  double thickness_;
  int fineness_;
  ChebyshevGrid grid_;
  std::size_t inner_;  ///< columns inside the edge
  std::vector<double> log_rest_, barycentric_;
  std::vector<Place> places_;
  double singular_ = 0;
};

}  // namespace dashpad::oracle
