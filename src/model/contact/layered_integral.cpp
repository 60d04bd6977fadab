/// The integrals of LayeredContact over its columns (theory.md, Eqs. 55 and 55a).

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dashpad/quantities/constants.hpp"
#include "model/contact/layered_contact.hpp"

namespace dashpad {
namespace {

/// Smallest of neighbouring g over the largest below which less than their whole bend counts, so that it is
/// continuous where a column is freed of its stress.
constexpr double min_ratio_with_bend = 0.25;
/// Width of the next cell over that of a cell below which less than its whole bend counts: a column that has
/// just been touched is close to the edge, and its ratio of small stresses must not bend the cell before.
constexpr double min_width_with_bend = 0.5;

/// Mean of max(g, 0) over a cell in which g is linear, and its derivatives by g at both ends.
struct PositiveMean {
  double value = 0;
  double by_inner = 0;
  double by_outer = 0;
};
PositiveMean positive_mean_of(double inner, double outer) {
  if (inner >= 0 && outer >= 0) return {(inner + outer) / 2, 0.5, 0.5};
  if (inner <= 0 && outer <= 0) return {};
  const double top = std::max(inner, outer);
  const double share = top / std::abs(inner - outer);  // pressing share of the cell
  const double by_top = share - share * share / 2;
  const double by_other = share * share / 2;
  return {top * share / 2, inner > 0 ? by_top : by_other, inner > 0 ? by_other : by_top};
}

}  // namespace

/// Sets A and w of the columns under the nose.
void LayeredContact::weigh_columns() {
  const FoamCurve& slow = series_.slow_curve();
  for (std::size_t j = 0; j < trial_live_; ++j) {
    const FoamCurve::Point point = slow.at(pad_strain(shortening(j, trial_penetration_)));
    places_[j].shape = point.stress;
    places_[j].measure = point.work;
  }
}

double LayeredContact::integrate() const {
  if (trial_live_ == 0) return 0;
  double sum = 0;
  for_each_cell([&](const Cell& cell) {
    const auto [inner, outer] = g(cell);
    sum += cell.width * (positive_mean_of(inner, outer).value +
                         bend(cell, [&](std::size_t j) { return next_[j].stress; }));
  });
  return nose_.tip * std::max(next_[0].stress, 0.0) + 2 * std::numbers::pi * series_.thickness() * sum;
}

/// Calls visit(Cell) from the axis to the edge of the contact.
template <class Visit>
void LayeredContact::for_each_cell(Visit&& visit) const {
  for (std::size_t j = 0; j + 1 < trial_live_; ++j)
    visit(Cell{j, j + 1, places_[j].weights, places_[j].measure - places_[j + 1].measure});
  // From the last column to the edge, stress over A is constant.
  const std::size_t last = trial_live_ - 1;
  visit(Cell{last, last, nose_.weights(places_[last].depth, std::min(trial_penetration_, nose_.depth)),
             places_[last].measure - edge_of_contact().work});
}

LayeredContact::Ends LayeredContact::g(const Cell& cell) const {
  double inner = next_[cell.inner].stress, outer = next_[cell.outer].stress;
  // Beyond the pressing columns the distance from the nose is smooth; the flexibility of a column is not.
  const auto with_flexibility_of = [&](std::size_t j, std::size_t free) {
    return next_[free].flexibility / std::max(next_[j].flexibility, std::numeric_limits<double>::min());
  };
  if (inner > 0 && outer < 0) outer *= with_flexibility_of(cell.inner, cell.outer);
  if (outer > 0 && inner < 0) inner *= with_flexibility_of(cell.outer, cell.inner);
  return {inner / places_[cell.inner].shape * cell.weights.inner,
          outer / places_[cell.outer].shape * cell.weights.outer};
}

/// Mean of g over a cell less that of a line, by Hermite's cubic with the slopes of parabolas through three
/// columns; at the axis of one parabola, at the last column of the chord. `value(j)` stands for the stress of
/// a column, and the result is linear in it. 0 where one of these columns is free of stress.
template <class Value>
double LayeredContact::bend(const Cell& cell, Value&& value) const {
  if (cell.inner == cell.outer) return 0;
  const auto over_shape = [&](std::size_t j) {
    return (nose_.shape ? cell.weights.inner : nose_.rate(places_[j].depth)) / places_[j].shape;
  };
  const bool has_before = cell.inner > 0, has_beyond = cell.outer + 1 < trial_live_;
  double min_g = infinite, max_g = 0;
  for (std::size_t j = cell.inner - has_before; j <= cell.outer + has_beyond; ++j) {
    const double g = next_[j].stress * over_shape(j);
    min_g = std::min(min_g, g);
    max_g = std::max(max_g, g);
  }
  if (!(min_g > 0)) return 0;
  const auto width = [&](std::size_t j) { return places_[j].measure - places_[j + 1].measure; };
  const auto chord = [&](std::size_t j) {
    return (value(j) * over_shape(j) - value(j + 1) * over_shape(j + 1)) / width(j);
  };
  const double middle = chord(cell.inner);
  double change = 0;  // of the slope, from the axis outwards
  if (has_beyond) {
    const double beyond = width(cell.outer);
    const double share = std::min(beyond / (min_width_with_bend * cell.width), 1.0);
    change += share * (chord(cell.outer) - middle) / (cell.width + beyond);
  }
  if (has_before)
    change += (middle - chord(cell.inner - 1)) / (cell.width + width(cell.inner - 1));
  else
    change *= 2;
  return std::min(min_g / (min_ratio_with_bend * max_g), 1.0) * cell.width * cell.width * change / 12;
}

FoamCurve::Point LayeredContact::edge_of_contact() const {
  if (trial_penetration_ <= nose_.depth) return {};
  return series_.slow_curve().at(pad_strain(
      {trial_penetration_ - nose_.depth, (series_.thickness() - trial_penetration_) + nose_.depth}));
}

Strain LayeredContact::pad_strain(const Shortening& shortening) const {
  return {shortening.y / series_.thickness(), shortening.gap / series_.thickness()};
}

double LayeredContact::force_rate_when_held(const PadTrial& trial) {
  recall(trial);
  if (trial_live_ == 0) return 0;
  complete_states();
  for (std::size_t j = 0; j < trial_live_; ++j) {
    const State& next = next_[j];
    places_[j].rate = next.stress > 0 ? series_.stress_rate_when_held(next.layers) : 0.0;
  }
  double sum = 0;
  for_each_cell([&](const Cell& cell) {
    const Place &at_inner = places_[cell.inner], &at_outer = places_[cell.outer];
    const auto [inner, outer] = g(cell);
    const PositiveMean mean = positive_mean_of(inner, outer);
    sum += cell.width * (mean.by_inner * cell.weights.inner * at_inner.rate / at_inner.shape +
                         mean.by_outer * cell.weights.outer * at_outer.rate / at_outer.shape +
                         bend(cell, [&](std::size_t j) { return places_[j].rate; }));
  });
  return nose_.tip * places_[0].rate + 2 * std::numbers::pi * series_.thickness() * sum;
}

double LayeredContact::lasting_stiffness(const PadTrial& trial) {
  recall(trial);
  if (trial_live_ == 0) return 0;
  double sum = 0;
  for (std::size_t j = 0; j < trial_live_; ++j) {
    const bool is_last = j + 1 == trial_live_;
    const double end = is_last ? std::min(trial_penetration_, nose_.depth) : places_[j + 1].depth;
    const double outer = is_last ? edge_of_contact().stress : places_[j + 1].shape;
    const Sections::Weights weights = nose_.weights(places_[j].depth, end);
    sum += (weights.inner + weights.outer) / 2 * (places_[j].shape - outer);
  }
  double stiffness = 2 * std::numbers::pi * sum;
  if (nose_.tip > 0) {
    const Strain axis = pad_strain(shortening(0, trial_penetration_));
    const double change = 1e-3 * std::min(axis.value, axis.complement);
    const Strain beyond{axis.value + change, axis.complement - change};
    stiffness += nose_.tip * (series_.slow_curve().at(beyond).stress - places_[0].shape) /
                 (change * series_.thickness());
  }
  const double ratio = next_[0].stress / places_[0].shape;
  // Layers that close at a finite stress limit the stiffness; the slow curve continues beyond that stress.
  const double most = nose_.area(trial_penetration_) / next_[0].flexibility;
  return std::max(std::min(stiffness * ratio, most), last_.force / series_.thickness());
}

}  // namespace dashpad
