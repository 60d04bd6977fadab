#include "model/contact/layered_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/contact/station_layout.hpp"

namespace dashpad {
namespace {

/// Gap for which stations are laid while none is known, as a share of the thickness.
constexpr double first_gap = 0.02;
/// With the bend of g, columns near the axis may be as far apart as the first steps are long.
constexpr StationSpacing spacing{.first = 0.5, .of_depth = 12};
/// Precision of the layers' strains as a share of their change over a step, in rho^2, the order of the step.
constexpr double precision_of_change = 1e-2;

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
}

void LayeredContact::solve_column(std::size_t j) {
  const Shortening end = shortening(j, trial_penetration_);
  const LayerStep step{last_.step, last_step_};
  const LayerStates now = states_before(j);
  State& next = next_[j];
  const bool is_tried = has_trial_ && j < trial_touched_ && next.flexibility > 0;
  const ColumnGuess guess = is_tried ? guess_by_trial(j, end.y) : guess_by_step(j, now, end.y);
  const bool is_by_step = !is_tried && j < touched_;
  const LayerSeries::Solution found =
      series_.solve(end, now, step, is_by_step && miss_.is_known ? corrected(guess) : guess, precision_);
  miss_.is_known = is_by_step && found.stress > 0;
  if (miss_.is_known) learn_miss(guess, found);
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
