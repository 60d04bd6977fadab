#include "model/contact/layered_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "dashpad/quantities/constants.hpp"
#include "model/contact/station_layout.hpp"
#include "model/pad/scalar.hpp"

namespace dashpad {
namespace {

/// Gap for which stations are laid while none is known, as a share of the thickness.
constexpr double first_gap = 0.02;
/// With the bend of g, columns near the axis may be as far apart as the first steps are long.
constexpr StationSpacing spacing{.first = 0.5, .of_depth = 12};
/// Smallest of neighbouring g over the largest below which less than their whole bend counts, so that it is
/// continuous where a column is freed of its stress.
constexpr double min_ratio_with_bend = 0.25;
/// Width of the next cell over that of a cell below which less than its whole bend counts: a column that has
/// just been touched is close to the edge, and its ratio of small stresses must not bend the cell before.
constexpr double min_width_with_bend = 0.5;
/// Precision of the layers' strains as a share of their change over a step, in rho^2, the order of the step.
constexpr double precision_of_change = 1e-2;

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

void LayeredContact::set(const Parts& parts, const Sections& nose) {
  nose_ = nose;
  if (parts == parts_) return;
  parts_ = parts;
  series_ = LayerSeries(parts);
}

void LayeredContact::start(double resolution, double expected) {
  precision_ = precision_of_change * resolution * resolution;
  const double thickness = series_.thickness();
  const double gap = expected < thickness ? thickness - expected : first_gap * thickness;
  places_.clear();
  lay_stations(nose_, {resolution, expected, thickness, gap, spacing},
               [this](double depth) { places_.push_back({.depth = depth}); });
  for (std::size_t j = 0; j + 1 < places_.size(); ++j)
    places_[j].weights = nose_.weights(places_[j].depth, places_[j + 1].depth);
  now_.resize(places_.size());
  next_.resize(places_.size());
  penetration_ = last_step_ = 0;
  touched_ = 0;
  updates_ = nested_updates_ = 0;
  last_ = {};
}

Shortening LayeredContact::shortening(std::size_t j, double penetration) const {
  const double depth = places_[j].depth;
  return {penetration - depth, (series_.thickness() - penetration) + depth};
}

/// States before a step. A column not reached yet takes over the slip of the column inside it and a strain as
/// far below zero as the nose is away: all columns of a pad of one foam then have one slip.
LayerStates LayeredContact::states_before(std::size_t j) const {
  if (j < touched_) return now_[j].layers;
  LayerStates states;
  const LayerStates inside = touched_ > 0 ? now_[touched_ - 1].layers : LayerStates{};
  const double y = penetration_ - places_[j].depth;
  double speed = 0;
  bool all_yield = touched_ > 0;
  for (std::size_t i = 0; all_yield && i < series_.size(); ++i) {
    speed += series_.thickness(i) * inside[i].rate;
    all_yield = inside[i].rate > 0;
  }
  for (std::size_t i = 0; i < series_.size(); ++i) {
    states[i].strain = y / series_.thickness();
    states[i].memory = series_.memory_at_rest(i);
    if (touched_ == 0) continue;
    states[i].rate = inside[i].rate;
    states[i].memory = series_.memory_off_contact(i, inside[i].memory);
    if (all_yield) states[i].strain = y * states[i].rate / speed;
  }
  return states;
}

ColumnGuess LayeredContact::guess_by_trial(std::size_t j, double y) const {
  const State& next = next_[j];
  const double change = y - next.y;
  ColumnGuess guess{.stress = next.stress + change / next.flexibility,
                    .flexibility = next.layer_flexibility,
                    .total_flexibility = next.flexibility};
  for (std::size_t i = 0; i < series_.size(); ++i)
    guess.strain[i] = next.layers[i].strain + change * guess.flexibility[i] / guess.total_flexibility;
  return guess;
}

ColumnGuess LayeredContact::guess_by_step(std::size_t j, const LayerStates& now, double y) const {
  ColumnGuess guess;
  double speed = 0;
  double fastest = 0;
  for (std::size_t i = 0; i < series_.size(); ++i) {
    speed += series_.thickness(i) * now[i].rate;
    fastest = std::max(fastest, std::abs(now[i].rate));
  }
  // The rates of layers that move against each other predict little of the next step.
  const bool is_shared = std::abs(speed) > 0.2 * series_.thickness() * fastest;
  const double before = penetration_ - places_[j].depth;
  for (std::size_t i = 0; i < series_.size(); ++i) {
    const double share = is_shared ? now[i].rate / speed : 1 / series_.thickness();
    guess.strain[i] = now[i].strain + share * (y - before);
    if (j < touched_) guess.flexibility[i] = now_[j].layer_flexibility[i];
  }
  if (j < touched_) {
    guess.stress = now_[j].stress + places_[j].chord * (y - before);
    guess.total_flexibility = now_[j].flexibility;
  } else {
    guess.stress = series_.slow_curve().at(strain_of(std::min(y / series_.thickness(), 0.9))).stress;
  }
  return guess;
}

/// The guess, corrected as that for the column before should have been.
ColumnGuess LayeredContact::corrected(ColumnGuess guess) const {
  for (std::size_t i = 0; i < series_.size(); ++i) {
    guess.strain[i] += miss_.strain[i];
    guess.flexibility[i] *= miss_.flexibility[i];
  }
  guess.total_flexibility *= miss_.total_flexibility;
  return guess;
}
void LayeredContact::learn_miss(const ColumnGuess& guess, const LayerSeries::Solution& found) {
  // A slope that is far too steep would make the search end before it has begun.
  const auto ratio = [](double value, double guessed) {
    return value > 0 && guessed > 0 ? std::clamp(value / guessed, 0.5, 2.0) : 1.0;
  };
  for (std::size_t i = 0; i < series_.size(); ++i) {
    miss_.strain[i] = found.strain[i].value - guess.strain[i];
    miss_.flexibility[i] = ratio(found.layer_flexibility[i], guess.flexibility[i]);
  }
  miss_.total_flexibility = ratio(found.flexibility, guess.total_flexibility);
  miss_.is_known = true;
}

void LayeredContact::solve_column(std::size_t j) {
  const Shortening end = shortening(j, trial_penetration_);
  const LayerStep step{last_.step, last_step_};
  const LayerStates now = states_before(j);
  State& next = next_[j];
  const bool is_tried = has_trial_ && j < trial_touched_ && next.flexibility > 0;
  const ColumnGuess guess = is_tried ? guess_by_trial(j, end.y) : guess_by_step(j, now, end.y);
  const bool is_corrected = !is_tried && miss_.is_known && j < touched_;
  const LayerSeries::Solution found =
      series_.solve(end, now, step, is_corrected ? corrected(guess) : guess, precision_);
  miss_.is_known = false;
  if (!is_tried && j < touched_ && found.stress > 0) learn_miss(guess, found);
  next = {found.stress, end.y, found.flexibility, {}, found.layer_flexibility};
  for (std::size_t i = 0; i < series_.size(); ++i) next.layers[i].strain = found.strain[i].value;
  updates_ += found.looks;
  nested_updates_ += found.nested_looks;
}

/// Sets the states of the layers at the end of the last trial, beyond their strains.
void LayeredContact::complete_states() {
  if (is_complete_) return;
  const LayerStep step{last_.step, last_step_};
  for (std::size_t j = 0; j < trial_touched_; ++j) {
    const LayerStates now = states_before(j);
    State& next = next_[j];
    for (std::size_t i = 0; i < series_.size(); ++i) {
      next.layers[i] = series_.after(i, next.layers[i].strain, now[i], step);
      if (!(next.y > 0)) next.layers[i].memory = series_.memory_off_contact(i, next.layers[i].memory);
    }
  }
  is_complete_ = true;
}

PadTrial LayeredContact::trial(double advance, double from, double step) {
  const PadTrial wanted{advance, from, step, 0};
  // Results of a step of another length belong to another rate.
  has_trial_ = wanted.shares_time_with(last_);
  last_ = wanted;
  trial_penetration_ = penetration_ + advance;
  const auto end = std::ranges::lower_bound(places_, trial_penetration_, {}, &Place::depth);
  trial_live_ = static_cast<std::size_t>(end - places_.begin());
  const std::size_t touched = std::max(touched_, trial_live_);
  miss_.is_known = is_complete_ = false;
  for (std::size_t j = 0; j < touched; ++j) solve_column(j);
  trial_touched_ = touched;
  weigh_columns();
  last_.force = integrate();
  return last_;
}

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

double LayeredContact::largest_stress(const PadTrial& trial) {
  recall(trial);
  if (trial_live_ == 0) return not_pressed;
  double largest = next_[0].stress;
  for (std::size_t j = 1; j < trial_live_; ++j) largest = std::max(largest, next_[j].stress);
  return largest;
}

/// Moves the nose a little beyond the last trial. Layers follow by their flexibilities; those of a column
/// free of stress share the change as they share its shortening (Eq. 53).
void LayeredContact::move_on(double further) {
  trial_penetration_ += further;
  is_complete_ = false;
  for (std::size_t j = 0; j < trial_touched_; ++j) {
    State& next = next_[j];
    const bool is_stressed = next.stress > 0 && next.flexibility > 0;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      const double share = is_stressed   ? next.layer_flexibility[i] / next.flexibility
                           : next.y != 0 ? next.layers[i].strain / next.y
                                         : 1 / series_.thickness();
      next.layers[i].strain += further * share;
    }
    if (next.flexibility > 0) next.stress += further / next.flexibility;
    next.y += further;
  }
}

void LayeredContact::accept(const PadTrial& trial) {
  recall(trial);
  if (trial.further != 0) move_on(trial.further);
  complete_states();
  for (std::size_t j = 0; j < trial_touched_; ++j) {
    const State& next = next_[j];
    const double stress = j < touched_ ? now_[j].stress : 0;
    const double y = j < touched_ ? now_[j].y : 0;
    places_[j].chord = next.y != y ? std::max((next.stress - stress) / (next.y - y), 0.0) : 0;
  }
  std::swap(now_, next_);
  penetration_ = trial_penetration_;
  touched_ = trial_touched_;
  last_step_ = trial.step;
  last_ = {};
}

LayeredContact::Column LayeredContact::column(std::size_t j) const {
  return {places_[j].depth, now_[j].y / series_.thickness(), now_[j].stress};
}

double LayeredContact::axis_strain(std::size_t layer) const {
  return touched_ > 0 ? now_[0].layers[layer].strain : 0;
}

double LayeredContact::contact_radius() const {
  std::size_t j = touched_;
  while (j > 0 && (now_[j - 1].y <= 0 || now_[j - 1].stress <= 0)) --j;
  if (j == 0) return 0;
  if (j == touched_ || now_[j].y <= 0) return nose_.radius(std::min(penetration_, nose_.depth));
  const double inner = places_[j - 1].depth;
  const double stress = now_[j - 1].stress;
  return nose_.radius(inner + (places_[j].depth - inner) * stress / (stress - now_[j].stress));
}

}  // namespace dashpad
