#include "model/contact/layered_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "model/contact/station_layout.hpp"
#include "model/pad/scalar.hpp"

namespace dashpad {
namespace {

/// Gap for which stations are laid while none is known, as a share of the thickness.
constexpr double first_gap = 0.02;

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

LayeredContact::LayeredContact(const Parts& parts, const Sections& nose)
    : parts_(parts), series_(parts), nose_(nose), columns_(parts.size()) {}

void LayeredContact::set(const Parts& parts, const Sections& nose) {
  nose_ = nose;
  if (parts == parts_) return;
  if (parts.size() != columns_.layers()) columns_ = LayerColumns(parts.size());
  parts_ = parts;
  series_ = LayerSeries(parts);
}

void LayeredContact::start(double resolution, double expected) {
  const double thickness = series_.thickness();
  columns_.clear();
  const double gap = expected < thickness ? thickness - expected : first_gap * thickness;
  lay_stations(nose_, {resolution, expected, thickness, gap},
               [this](double depth) { columns_.append(depth); });
  for (std::size_t j = 0; j + 1 < columns_.size(); ++j) {
    const Sections::Weights weights = nose_.weights(columns_.depth()[j], columns_.depth()[j + 1]);
    columns_.set_weights(j, weights.inner, weights.outer);
  }
  penetration_ = largest_ = last_step_ = 0;
  touched_ = 0;
  updates_ = nested_updates_ = 0;
  last_ = {};
}

Shortening LayeredContact::shortening(std::size_t j, double penetration) const {
  const double depth = columns_.depth()[j];
  return {penetration - depth, (series_.thickness() - penetration) + depth};
}

/// States before a step. A column that the nose has not reached takes over the slip of the column inside it,
/// and starts as far below strain zero as the nose is away: all columns of a pad of one foam then have one
/// slip, as that foam alone has.
LayerStates LayeredContact::states_before(std::size_t j) const {
  LayerStates states;
  const LayerColumns::Moment& now = columns_.now;
  if (j < touched_) {
    for (std::size_t i = 0; i < series_.size(); ++i)
      states[i] = {now.strain[i][j], now.largest[i][j], now.rate[i][j], now.memory[i][j]};
    return states;
  }
  const double y = penetration_ - columns_.depth()[j];
  double speed = 0;
  bool all_yield = touched_ > 0;
  for (std::size_t i = 0; all_yield && i < series_.size(); ++i) {
    speed += series_.thickness(i) * now.rate[i][touched_ - 1];
    all_yield = now.rate[i][touched_ - 1] > 0;
  }
  for (std::size_t i = 0; i < series_.size(); ++i) {
    states[i].strain = y / series_.thickness();
    states[i].memory = series_.memory_at_rest(i);
    if (touched_ == 0) continue;
    states[i].rate = now.rate[i][touched_ - 1];
    states[i].memory = series_.memory_off_contact(i, now.memory[i][touched_ - 1]);
    if (all_yield) states[i].strain = y * states[i].rate / speed;
  }
  return states;
}

ColumnGuess LayeredContact::guess(std::size_t j, const LayerStates& now, double y) const {
  ColumnGuess guess;
  const LayerColumns::Moment& next = columns_.next_moment;
  if (has_trial_ && j < trial_touched_ && next.flexibility[j] > 0) {
    // From the last trial of this state.
    const double change = y - next.y[j];
    guess.total_flexibility = next.flexibility[j];
    guess.stress = next.stress[j] + change / guess.total_flexibility;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      guess.flexibility[i] = next.layer_flexibility[i][j];
      guess.strain[i] = next.strain[i][j] + change * guess.flexibility[i] / guess.total_flexibility;
    }
    return guess;
  }
  double speed = 0;
  double fastest = 0;
  for (std::size_t i = 0; i < series_.size(); ++i) {
    speed += series_.thickness(i) * now[i].rate;
    fastest = std::max(fastest, std::abs(now[i].rate));
  }
  // The rates of layers that move against each other predict little of the next step.
  const bool is_shared = std::abs(speed) > 0.2 * series_.thickness() * fastest;
  const double before = penetration_ - columns_.depth()[j];
  for (std::size_t i = 0; i < series_.size(); ++i) {
    const double share = is_shared ? now[i].rate / speed : 1 / series_.thickness();
    guess.strain[i] = now[i].strain + share * (y - before);
    if (j < touched_) guess.flexibility[i] = columns_.now.layer_flexibility[i][j];
  }
  if (j < touched_) {
    guess.stress = columns_.now.stress[j] + columns_.chord[j] * (y - before);
    guess.total_flexibility = columns_.now.flexibility[j];
  } else {
    guess.stress = series_.slow_curve().at(strain_of(std::min(y / series_.thickness(), 0.9))).stress;
  }
  return guess;
}

void LayeredContact::solve_column(std::size_t j) {
  const Shortening end = shortening(j, trial_penetration_);
  const LayerStep step{last_.step, last_step_};
  const LayerStates now = states_before(j);
  const LayerSeries::Solution found = series_.solve(end, now, step, guess(j, now, end.y));
  LayerColumns::Moment& next = columns_.next_moment;
  next.stress[j] = found.stress;
  next.y[j] = end.y;
  next.flexibility[j] = found.flexibility;
  for (std::size_t i = 0; i < series_.size(); ++i) {
    const LayerState after = series_.after(i, found.strain[i], now[i], step);
    next.strain[i][j] = after.strain;
    next.largest[i][j] = after.largest;
    next.rate[i][j] = after.rate;
    next.memory[i][j] = end.y > 0 ? after.memory : series_.memory_off_contact(i, after.memory);
    next.layer_flexibility[i][j] = found.layer_flexibility[i];
  }
  updates_ += found.looks;
  nested_updates_ += found.nested_looks;
}

PadTrial LayeredContact::trial(double advance, double from, double step) {
  const PadTrial wanted{advance, from, step, 0};
  // Results of a step of another length belong to another rate.
  has_trial_ = wanted.shares_time_with(last_);
  last_ = wanted;
  trial_penetration_ = penetration_ + advance;
  const double* depth = columns_.depth();
  trial_live_ =
      static_cast<std::size_t>(std::lower_bound(depth, depth + columns_.size(), trial_penetration_) - depth);
  const std::size_t touched = std::max(touched_, trial_live_);
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
    columns_.shape[j] = point.stress;
    columns_.measure[j] = point.work;
  }
}

double LayeredContact::integrate() const {
  if (trial_live_ == 0) return 0;
  double sum = 0;
  for_each_cell([&](const Cell& cell) {
    const auto [inner, outer] = g(cell);
    sum += cell.width * positive_mean_of(inner, outer).value;
  });
  return nose_.tip * std::max(columns_.next_moment.stress[0], 0.0) +
         2 * std::numbers::pi * series_.thickness() * sum;
}

/// Calls visit(Cell) from the axis to the edge of the contact.
template <class Visit>
void LayeredContact::for_each_cell(Visit&& visit) const {
  for (std::size_t j = 0; j + 1 < trial_live_; ++j)
    visit(Cell{j,
               j + 1,
               {columns_.inner_weight()[j], columns_.outer_weight()[j]},
               columns_.measure[j] - columns_.measure[j + 1]});
  // From the last column to the edge, stress over A is constant.
  const std::size_t last = trial_live_ - 1;
  visit(Cell{last, last, nose_.weights(columns_.depth()[last], std::min(trial_penetration_, nose_.depth)),
             columns_.measure[last] - edge_of_contact().work});
}

LayeredContact::Ends LayeredContact::g(const Cell& cell) const {
  const LayerColumns::Moment& next = columns_.next_moment;
  double inner = next.stress[cell.inner], outer = next.stress[cell.outer];
  // The distance of a column from the nose continues smoothly beyond the pressing columns; its own
  // flexibility does not.
  const auto with_flexibility_of = [&](std::size_t j, std::size_t free) {
    return next.flexibility[free] / std::max(next.flexibility[j], std::numeric_limits<double>::min());
  };
  if (inner > 0 && outer < 0) outer *= with_flexibility_of(cell.inner, cell.outer);
  if (outer > 0 && inner < 0) inner *= with_flexibility_of(cell.outer, cell.inner);
  return {inner / columns_.shape[cell.inner] * cell.weights.inner,
          outer / columns_.shape[cell.outer] * cell.weights.outer};
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
  const LayerColumns::Moment& next = columns_.next_moment;
  const auto rate_of = [&](std::size_t j) {
    if (!(next.stress[j] > 0)) return 0.0;
    LayerStates states;
    std::array<Strain, max_layers> strain;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      states[i] = {next.strain[i][j], next.largest[i][j], next.rate[i][j], next.memory[i][j]};
      strain[i] = strain_of(next.strain[i][j]);
    }
    return series_.stress_rate_when_held(strain, states);
  };
  const double axis = rate_of(0);
  double sum = 0;
  double inner_rate = axis;
  for_each_cell([&](const Cell& cell) {
    const double outer_rate = cell.outer == cell.inner ? inner_rate : rate_of(cell.outer);
    const auto [inner, outer] = g(cell);
    const PositiveMean mean = positive_mean_of(inner, outer);
    sum += cell.width * (mean.by_inner * cell.weights.inner * inner_rate / columns_.shape[cell.inner] +
                         mean.by_outer * cell.weights.outer * outer_rate / columns_.shape[cell.outer]);
    inner_rate = outer_rate;
  });
  return (next.stress[0] > 0 ? nose_.tip * axis : 0) + 2 * std::numbers::pi * series_.thickness() * sum;
}

double LayeredContact::lasting_stiffness(const PadTrial& trial) {
  recall(trial);
  if (trial_live_ == 0) return 0;
  double sum = 0;
  for (std::size_t j = 0; j < trial_live_; ++j) {
    const bool is_last = j + 1 == trial_live_;
    const double end = is_last ? std::min(trial_penetration_, nose_.depth) : columns_.depth()[j + 1];
    const double outer = is_last ? edge_of_contact().stress : columns_.shape[j + 1];
    const Sections::Weights weights = nose_.weights(columns_.depth()[j], end);
    sum += (weights.inner + weights.outer) / 2 * (columns_.shape[j] - outer);
  }
  double stiffness = 2 * std::numbers::pi * sum;
  if (nose_.tip > 0) {
    const Strain axis = pad_strain(shortening(0, trial_penetration_));
    const double change = 1e-3 * std::min(axis.value, axis.complement);
    const Strain beyond{axis.value + change, axis.complement - change};
    stiffness += nose_.tip * (series_.slow_curve().at(beyond).stress - columns_.shape[0]) /
                 (change * series_.thickness());
  }
  const LayerColumns::Moment& next = columns_.next_moment;
  const double ratio = next.stress[0] / columns_.shape[0];
  // Layers that close at a finite stress limit the stiffness; the slow curve continues beyond that stress.
  const double most = nose_.area(trial_penetration_) / next.flexibility[0];
  return std::max(std::min(stiffness * ratio, most), last_.force / series_.thickness());
}

double LayeredContact::largest_stress(const PadTrial& trial) {
  recall(trial);
  if (trial_live_ == 0) return not_pressed;
  const double* stress = columns_.next_moment.stress;
  return *std::max_element(stress, stress + trial_live_);
}

void LayeredContact::accept(const PadTrial& trial) {
  recall(trial);
  const LayerColumns::Moment& next = columns_.next_moment;
  for (std::size_t j = 0; j < trial_touched_; ++j) {
    const double stress = j < touched_ ? columns_.now.stress[j] : 0;
    const double y = j < touched_ ? columns_.now.y[j] : 0;
    columns_.chord[j] = next.y[j] != y ? std::max((next.stress[j] - stress) / (next.y[j] - y), 0.0) : 0;
  }
  std::swap(columns_.now, columns_.next_moment);
  penetration_ = trial_penetration_;
  largest_ = std::max(largest_, penetration_);
  touched_ = trial_touched_;
  last_step_ = trial.step;
  last_ = {};
}

LayeredContact::Column LayeredContact::column(std::size_t j) const {
  return {columns_.depth()[j], columns_.now.y[j] / series_.thickness(), columns_.now.stress[j]};
}

double LayeredContact::axis_strain(std::size_t layer) const {
  return touched_ > 0 ? columns_.now.strain[layer][0] : 0;
}

double LayeredContact::contact_radius() const {
  const double* stress = columns_.now.stress;
  std::size_t j = touched_;
  while (j > 0 && (columns_.now.y[j - 1] <= 0 || stress[j - 1] <= 0)) --j;
  if (j == 0) return 0;
  const double inner = columns_.depth()[j - 1];
  if (j == touched_ || columns_.now.y[j] <= 0) return nose_.radius(std::min(penetration_, nose_.depth));
  return nose_.radius(inner + (columns_.depth()[j] - inner) * stress[j - 1] / (stress[j - 1] - stress[j]));
}

}  // namespace dashpad
