#pragma once
/// A nose on a foam with one slip for all columns (theory.md, Eqs. 32 to 38).
///
///   F = a0 max(stress(0), 0) + int max(stress(s), 0) a'(s) ds, over s in [0, min(Y, d)]   (theory.md, Eq. 6)
///
/// The stress of a column follows from its strain, its largest strain, larger by the same amount in all
/// columns, and their common slip rate. So no column has a state, and each trial takes the integral anew,
/// over the work of the base curve (model/contact/work_nodes.hpp). On unloading columns lose their stress,
/// usually from the edge inwards, so the integral is taken between the strains at which it vanishes.
///
/// From earlier blows the pad keeps the largest penetration Ym (theory.md, Eqs. 46 to 48): columns start with
/// the largest strain e* of that blow, and crushed foam is met in its crater.

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/quantities/constants.hpp"
#include "model/contact/contact.hpp"
#include "model/contact/foam_nodes.hpp"
#include "model/contact/sweep.hpp"
#include "model/contact/work_nodes.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {

class FoamContact {
 public:
  using Law = std::variant<Foam, CrushableFoam>;

  /// `factor` multiplies every stress; `earlier` is the largest penetration of earlier blows, m.
  FoamContact(const Law& law, double thickness, const Sections& nose, double factor = 1,
              ColumnMath math = ColumnMath::vector, double earlier = 0)
      : law_(law), stress_(made_of(law)) {
    set(law, thickness, nose, factor, math, earlier);
  }
  void set(const Law& law, double thickness, const Sections& nose, double factor, ColumnMath math,
           double earlier) {
    if (!(law == law_)) {
      law_ = law;
      stress_ = made_of(law);
    }
    thickness_ = thickness;
    nose_ = nose;
    factor_ = factor;
    math_ = math;
    remember(earlier);
  }

  [[nodiscard]] bool is_of(const PadLaw& law) const {
    return std::visit(
        [&]<class Of>(const Of& owner) {
          const Of* same = std::get_if<Of>(&law);
          return same != nullptr && *same == owner;
        },
        law_);
  }

  [[nodiscard]] bool recovers() const { return true; }
  [[nodiscard]] double first_force() const { return 0; }
  [[nodiscard]] double lock_penetration() const { return closed() - crater_; }
  [[nodiscard]] double crater() const { return crater_; }
  [[nodiscard]] double joint() const { return earlier_ - crater_; }
  [[nodiscard]] std::size_t stations() const { return stations_; }
  [[nodiscard]] std::size_t updates() const { return updates_; }

  void start(double resolution, double) {
    cut_nose(resolution);
    panels_ = (stress_.has_points() ? panels_by_points : panels_at_one) / std::sqrt(resolution);
    edge_precision_ = precision_of_edge * resolution;
    edge_ = 0;
    penetration_ = crater_;
    largest_ = earlier_;
    left_ = 0;
    pressing_ = -1;
    slip_ = {};
    rate_ = rate_step_ = 0;
    stations_ = updates_ = 0;
    last_ = {};
  }

  PadTrial trial(double advance, double from, double step) {
    last_ = {advance, from, step, 0};
    follow(advance, step);
    last_.force = factor_ * integrate();
    updates_ += points_;
    return last_;
  }

  [[nodiscard]] double force_rate_when_held(const PadTrial& trial) {
    recall(trial);
    return factor_ * relaxing_;
  }
  /// dF/dY of the base curve's stress alone, N/m; what a change of the rate adds does not act like a spring.
  [[nodiscard]] double lasting_stiffness(const PadTrial& trial) {
    recall(trial);
    const double Y = trial_penetration_;
    if (Y <= 0) return 0;
    const double top = Y / thickness_;
    const FoamStress::Place inner = stress_.at(leading(top, top));
    double stiffness = nose_.shape ? stiffness_below_shape(inner) : stiffness_of_piece(inner);
    if (nose_.tip > 0) {
      const double change = 1e-3 * std::min(inner.strain.value, inner.strain.complement);
      const Strain beyond{inner.strain.value + change, inner.strain.complement - change};
      stiffness += nose_.tip * (stress_.at(beyond).base.stress - inner.base.stress) / (change * thickness_);
    }
    return std::max(factor_ * stiffness * ratio(inner).stress, last_.force / thickness_);
  }
  /// The highest tested rate below the present slip rate, 1/s, at which the force has a corner; 0: none.
  [[nodiscard]] double rate_corner() const {
    return stress_.overstress().corner_below(stress_.slip().slip_rate(slip_));
  }
  [[nodiscard]] double slip_rate(const PadTrial& trial) {
    recall(trial);
    return stress_.slip().slip_rate(trial_slip_);
  }
  [[nodiscard]] double largest_stress(const PadTrial& trial) {
    recall(trial);
    return trial_penetration_ > 0 ? max_pressed_ : not_pressed;
  }

  void accept(const PadTrial& trial) {
    recall(trial);
    if (trial.further != 0) follow(trial.whole_advance(), trial.step);
    penetration_ = trial_penetration_;
    largest_ = trial_largest_;
    slip_ = trial_slip_;
    rate_ = trial_rate_;
    rate_step_ = trial.step;
    pressing_ = trial_pressing_;
    last_ = {};
  }

  /// The nose meets the pad again after leaving it: the pad is then as after an earlier blow.
  void meet_again() { left_ = largest_; }

  /// Outer radius of the stressed area, m.
  [[nodiscard]] double contact_radius() const { return pressing_ >= 0 ? nose_.radius(pressing_) : 0; }

  /// A column in the accepted state, given by the depth at which the nose's surface meets it, m.
  struct Column {
    double strain = 0;
    double stress = 0;  ///< Pa, tension negative
  };
  [[nodiscard]] Column column(double depth) const {
    const double strain = (penetration_ - depth) / thickness_;
    const Strain at{strain, ((thickness_ - penetration_) + depth) / thickness_};
    return {strain, factor_ * stress_.stress(at, (largest_ - penetration_) / thickness_,
                                             stress_.slip().strain_of(slip_), is_in_crater(largest_))};
  }

 private:
  void remember(double earlier) {
    earlier_ = std::min(earlier, closed());
    crater_ = 0;
    if (earlier_ == 0) return;
    const double edge = (earlier_ - std::min(earlier_, nose_.depth)) / thickness_;
    crater_ = thickness_ * stress_.strain_of_crater(earlier_ / thickness_, edge);
  }
  /// Penetration at which the pad counts as closed, m below the surface of the new pad.
  [[nodiscard]] double closed() const { return thickness_ * (1 - 1e-9); }
  /// Whether some columns below the nose may be untouched, as it has gone no deeper than before.
  [[nodiscard]] bool is_in_crater(double largest) const {
    const double before = std::max(earlier_, left_);
    return before > 0 && largest <= before && stress_.stays_crushed();
  }
  /// dF/dY by the base curve's stress for a nose of one quadratic piece.
  [[nodiscard]] double stiffness_of_piece(const FoamStress::Place& inner) const {
    const double Y = trial_penetration_;
    const double outer_strain = (Y - std::min(Y, nose_.depth)) / thickness_;
    const FoamStress::Place outer = stress_.at(leading(outer_strain, Y / thickness_));
    const auto by_work = [&](const FoamStress::Place& at) {
      return rate_at(at) * at.base.stress - nose_.taper * thickness_ * at.base.work;
    };
    return 2 * std::numbers::pi * (by_work(inner) - by_work(outer));
  }
  /// The same for a shape, as accurately as step lengths need: over depths in the ratio of 1 to 4.
  [[nodiscard]] double stiffness_below_shape(const FoamStress::Place& inner) const {
    const double top = trial_penetration_ / thickness_;
    double depth = std::min(trial_penetration_, nose_.depth);
    double stress = stress_.at(leading((trial_penetration_ - depth) / thickness_, top)).base.stress;
    double sum = 0;
    for (int i = 0; i < 16; ++i) {
      const double next = i < 15 ? depth / 4 : 0;
      const double further =
          next > 0 ? stress_.at(leading((trial_penetration_ - next) / thickness_, top)).base.stress
                   : inner.base.stress;
      sum += nose_.weights(next, depth).inner * (further - stress);
      depth = next;
      stress = further;
    }
    return 2 * std::numbers::pi * sum;
  }

  /// Number of panels times the root of the resolution: the rule is of fourth order, twice that of the step.
  static constexpr double panels_at_one = 1.75;
  /// The same where the ratio of stresses follows the points of tested curves: it waves between these, and
  /// with wide panels runs agree by chance. (With the usual panels 48 of 26,700 figures of random foams were
  /// off by more than 1e-4; with these, and the slip of slip.hpp, 3: theory.md, section 5.1.)
  static constexpr double panels_by_points = 5.25;
  /// Share of the panels for a factor of e in the complement of the strain, beyond the tested strains.
  static constexpr double panels_beyond = 0.35;
  /// Precision of the contact's edge over the resolution, as a share of the search range.
  static constexpr double precision_of_edge = 5e-3;
  /// Grading of a shape's pieces over the root of the resolution, since they are of fourth order.
  static constexpr double grading = 1.3;
  /// Depth of the tip over which the stress is taken as linear, in rho times penetration or gap.
  static constexpr double thin = 0.1;
  static constexpr std::size_t looks = 12;  ///< places searched for pressing rings
  static constexpr int ring_bits = 12;      ///< precision of the place of the last pressing ring, bits

  static FoamStress made_of(const Law& law) {
    return std::visit([](const auto& given) { return FoamStress(given); }, law);
  }
  /// Sets the pieces over which the nose is integrated.
  void cut_nose(double resolution) {
    piece_ = {.from = 0, .to = nose_.depth, .width = nose_.width, .taper = nose_.taper};
    pieces_.clear();
    if (nose_.shape) pieces_ = nose_.shape->pieces(grading * std::sqrt(resolution));
    thin_ = thin * resolution;
  }
  /// Sets the state of the pad at the end of a trial.
  void follow(double advance, double step) {
    trial_penetration_ = penetration_ + advance;
    trial_largest_ = std::max(largest_, trial_penetration_);
    trial_rate_ = advance / (thickness_ * step);
    trial_slip_ = stress_.slip().after_step(slip_, trial_rate_, step, rate_, rate_step_);
  }
  void recall(const PadTrial& wanted) {
    if (!last_.is_same_step_as(wanted)) trial(wanted.advance, wanted.from, wanted.step);
  }

  /// The force at the end of the trial before `factor`, N; also sets the trial's other results.
  double integrate() {
    relaxing_ = 0;
    max_pressed_ = -infinite;
    trial_pressing_ = -1;
    points_ = 0;
    const double Y = trial_penetration_;
    if (Y <= 0) return 0;
    slip_rate_ = stress_.slip().slip_rate(trial_slip_);
    at_rate_ = stress_.overstress().at(slip_rate_);
    ahead_ = (trial_largest_ - Y) / thickness_;
    in_crater_ = is_in_crater(trial_largest_);
    lead_ = stress_.lead(ahead_);
    gap_ = (thickness_ - Y) / thickness_;
    const double top = Y / thickness_;
    double force = 0;
    if (nose_.tip > 0) force = pressure(top) * nose_.tip;
    const double end = std::min(Y, nose_.depth);
    if (end <= 0) return force;
    const double edge = (Y - end) / thickness_;
    // Where the slip goes on as before, the rate adds stress to every column (Eq. 33), and none is free.
    if (slip_rate_ >= 0 && (ahead_ <= 0 || !stress_.stays_crushed()))
      return force + integral(edge, edge, top, top);
    if (stress_.stays_crushed() && ahead_ > 0) return force + integral_of_crushed(edge, top);

    const auto at = [&](double root) { return sign_at(root * root, top); };
    const double low = std::sqrt(edge);
    const double high = std::sqrt(top);
    const double first = low + 1e-6 * (high - low);
    const double f_first = at(first);
    const double f_high = at(high);
    if (f_high > 0 && stress_.lets_go_from_one_side(at_rate_)) {
      if (f_first >= 0) return force + integral(edge, edge, top, top);
      const double root = crossing(at, first, f_first, high, f_high);
      return force + integral(edge, root * root, top, top);
    }
    // One or more rings may still press where the axis no longer does, or beside the axis with a gap between.
    const double width = (high - low) / looks;
    // cppcheck loses the + 1 in std::array<double, looks + 1>.
    constexpr std::size_t ends = looks + 1;
    std::array<double, ends> places{first};
    std::array<double, ends> found{f_first};
    std::size_t most = 0;
    for (std::size_t i = 1; i <= looks; ++i) {
      places[i] = low + width * double(i);
      found[i] = i < looks ? at(places[i]) : f_high;
      if (found[i] > found[most]) most = i;
    }
    if (found[most] <= 0) {
      // The last ring is narrow and may lie between two places: without it contact would end too early.
      const std::size_t below = most > 0 ? most - 1 : 0;
      const std::size_t above = std::min(most + 1, looks);
      const auto [place, less] = boost::math::tools::brent_find_minima(
          [&](double x) { return -at(x); }, places[below], places[above], ring_bits);
      if (less >= 0) return force;
      const double from = crossing(at, places[below], found[below], place, -less);
      const double to = crossing(at, place, -less, places[above], found[above]);
      return force + integral(edge, from * from, to * to, top);
    }
    double from = low;
    for (std::size_t i = 1; i <= looks; ++i) {
      if (found[i] > 0 && found[i - 1] <= 0)
        from = crossing(at, places[i - 1], found[i - 1], places[i], found[i]);
      if (found[i] > 0 || found[i - 1] <= 0) continue;
      const double to = crossing(at, places[i - 1], found[i - 1], places[i], found[i]);
      force += integral(edge, from * from, to * to, top);
    }
    return f_high > 0 ? force + integral(edge, from * from, top, top) : force;
  }

  /// The same for crushed foam on the way back. Its line of unloading is integrated in closed form over the
  /// columns that still press by it; they are contiguous, as s(e*) - max(E, s'(e*)) ahead has one maximum.
  /// The stress added by the rate depends on each column's own strain (theory.md, Eq. 38).
  double integral_of_crushed(double edge, double top) {
    double force = 0;
    const auto at = [&](double root) {
      ++points_;
      const FoamStress::Place place = stress_.at(leading(root * root, top));
      return place.base.stress - stress_.slope_back(place.strain) * ahead_;
    };
    const double low = std::sqrt(edge);
    const double high = std::sqrt(top);
    const double middle = std::sqrt(std::clamp(stress_.longest_pressed(ahead_) - ahead_, edge, top));
    const double most = at(middle);
    max_pressed_ = std::max(max_pressed_, most);
    if (most > 0) {
      const double f_low = at(low);
      const double f_high = at(high);
      const double from = f_low < 0 ? crossing(at, low, f_low, middle, most) : low;
      const double to = f_high < 0 ? crossing(at, middle, most, high, f_high) : high;
      press_from(from * from);
      if (in_crater_ && slip_rate_ > 0) return integral(edge, from * from, to * to, top);
      force = crushed_force(from * from, to * to, top);
    }
    stations_ = std::max(stations_, points_);
    if (in_crater_ || slip_rate_ <= 0 || (at_rate_.even && at_rate_.at_all_strains.stress == 0)) return force;
    // As on the way in, without the base curve's own stress.
    const auto [ahead, lead] = std::pair(std::exchange(ahead_, 0), std::exchange(lead_, 0));
    left_out_ = 1;
    press_from(edge);
    force += integral(edge, edge, top, top);
    ahead_ = ahead, lead_ = lead, left_out_ = 0;
    return force;
  }
  /// Force of the line of unloading over columns that all press by it, N.
  double crushed_force(double from, double to, double top) {
    const auto of_piece = [&](double outer, double inner) {
      return crushed_force_of_piece(outer, inner, top);
    };
    if (!nose_.shape) return of_piece(from, to);
    const auto stress = [&](double depth) {
      const FoamStress::Place place = stress_.at(leading((trial_penetration_ - depth) / thickness_, top));
      return place.base.stress - stress_.slope_back(place.strain) * ahead_;
    };
    const auto of_thin = [&](const ThinStretch& thin_stretch) {
      return thin_stretch.inner_area * stress(thin_stretch.inner) +
             thin_stretch.outer_area * stress(thin_stretch.outer);
    };
    return over_pieces(from, to, of_thin, of_piece);
  }
  double crushed_force_of_piece(double from, double to, double top) const {
    const FoamStress::Place outer = stress_.at(leading(from, top));
    const FoamStress::Place inner = stress_.at(leading(to, top));
    const double at_zero = piece_.width - piece_.taper * depth_of(0);
    return 2 * std::numbers::pi * thickness_ *
           (base_force(outer, inner) -
            ahead_ * stress_.moment_of_slope_back(outer, inner, at_zero, piece_.taper * thickness_));
  }
  /// Notes that columns from this strain on press, unless some farther out do.
  void press_from(double strain) {
    const double depth = trial_penetration_ - strain * thickness_;
    trial_pressing_ = std::max(trial_pressing_, depth);
  }

  /// Pressure on the flat tip, Pa.
  double pressure(double top) {
    const FoamStress::Place place = stress_.at(leading(top, top));
    const FoamStress::Ratio of = ratio(place);
    press(place, of);
    if (of.stress <= 0) return 0;
    trial_pressing_ = 0;
    relaxing_ += nose_.tip * place.base.stress * of.relaxing;
    return place.base.stress * of.stress;
  }
  /// Force between two strains of the contact, which ends at the strains `edge` and `top`, N.
  double integral(double edge, double from, double to, double top) {
    if (to <= from) return 0;
    press_from(from);
    return nose_.shape ? integral_below_shape(edge, from, to, top)
                       : integral_below_piece(edge, from, to, top);
  }
  /// A range of depths over which the stress is linear, so that only its area and volume matter.
  struct ThinStretch {
    double inner = 0, outer = 0;            ///< depths, m
    double inner_area = 0, outer_area = 0;  ///< weights of the stresses there, m2
  };
  /// Sum over the pieces of a shape between two strains: first a thin range at the tip if a' has no bound
  /// there, then each piece from its outer strain to its inner one.
  template <class OfThin, class OfPiece>
  double over_pieces(double from, double to, OfThin&& of_thin, OfPiece&& of_piece) {
    const double Y = trial_penetration_;
    auto piece = pieces_.begin();
    double force = 0;
    double inner = std::max(Y - to * thickness_, 0.0);
    if (nose_.shape->is_steep_at_tip()) {
      const double end = thin_ * std::min(Y, thickness_ - Y);
      while (piece + 1 != pieces_.end() && (piece + 1)->to <= end) ++piece;
      const double outer = std::min(piece->to, Y - from * thickness_);
      if (outer > inner) {
        const double height = outer - inner;
        const double area = nose_.area(outer) - nose_.area(inner);
        // int (s - inner) a' ds / height
        const double outer_area = nose_.area(outer) - (nose_.volume(outer) - nose_.volume(inner)) / height;
        force += of_thin(ThinStretch{inner, outer, area - outer_area, outer_area});
        inner = outer;
        to = (Y - outer) / thickness_;
      }
      ++piece;
    }
    for (; piece != pieces_.end() && to > from; ++piece) {
      if (piece->to <= inner) continue;
      piece_ = *piece;
      const double end = std::max((Y - piece->to) / thickness_, from);
      force += of_piece(end, to);
      to = end;
    }
    return force;
  }
  double integral_below_shape(double edge, double from, double to, double top) {
    const auto of_thin = [&](const ThinStretch& thin_stretch) { return thin_force(thin_stretch, top); };
    const auto of_piece = [&](double outer, double inner) {
      return integral_below_piece(edge, outer, inner, top);
    };
    return over_pieces(from, to, of_thin, of_piece);
  }
  double thin_force(const ThinStretch& thin_stretch, double top) {
    double force = 0;
    for (const auto& [depth, area] : {std::pair{thin_stretch.inner, thin_stretch.inner_area},
                                      std::pair{thin_stretch.outer, thin_stretch.outer_area}}) {
      const FoamStress::Place place = stress_.at(leading((trial_penetration_ - depth) / thickness_, top));
      const FoamStress::Ratio ratio_here = ratio(place);
      press(place, ratio_here);
      force += area * place.base.stress * (ratio_here.stress - left_out_);
      relaxing_ += area * place.base.stress * ratio_here.relaxing;
    }
    return force;
  }
  double integral_below_piece(double edge, double from, double to, double top) {
    if (to <= from) return 0;
    if (const double corner = stress_.overstress().strain_of_corner(); from < corner && corner < to)
      return integral_below_piece(edge, from, corner, top) + integral_below_piece(edge, corner, to, top);
    const FoamStress::Place outer = stress_.at(leading(from, top));
    const FoamStress::Place inner = stress_.at(leading(to, top));
    // The part common to all columns has a closed form; the rest is smaller and often zero.
    const FoamStress::Ratio common = ratio(inner);
    const double thickness = 2 * std::numbers::pi * thickness_;
    const double base = thickness * base_force(outer, inner);
    double force = base * (common.stress - left_out_);
    relaxing_ += base * common.relaxing;
    press(inner, common);
    if (stress_.is_even(ahead_, at_rate_)) return force;

    const double last = stress_.curve().last_strain();
    const auto root = [&](double strain) { return std::sqrt(std::min(strain + lead_, last)); };
    const double share = (root(to) - root(from)) / (root(top) - root(edge));
    const WorkIntegral more =
        integral_beside(common, {outer, inner, from <= edge, panels_ * share, panels_ * panels_beyond});
    relaxing_ += thickness * more.relaxing;
    return force + thickness * more.stress;
  }
  /// Integral of the ratio less the part common to all columns.
  WorkIntegral integral_beside(const FoamStress::Ratio& common, const WorkStretch& over) {
    const double last = stress_.curve().last_strain();
    const auto put = [&](const FoamStress::Place& place, NodeValues& values, std::size_t i) {
      const FoamStress::Ratio of = stress_.ratio(place, ahead_, at_rate_, slip_rate_, in_crater_);
      const double rate = rate_at(place);
      values.work[i] = place.base.work;
      values.stress[i] = rate * (of.stress - common.stress);
      values.relaxing[i] = rate * (of.relaxing - common.relaxing);
    };
    WorkIntegral sum;
    if (math_ == ColumnMath::vector && stress_.is_of_one_place(ahead_)) {
      const FoamNodes nodes{stress_.rows(ahead_, at_rate_, slip_rate_), common,
                            piece_.width - piece_.taper * depth_of(0), piece_.taper * thickness_};
      const auto by = [&](FoamNodeMath::Fill fill) {
        return [&nodes, fill](const NodeRow& row, NodeValues& values) { fill(nodes, row, values); };
      };
      sum.take(over, last, values_, put, by(vectors_->within), by(vectors_->beyond));
    } else {
      sum.take(
          over, last, values_, put,
          [&](const NodeRow& row, NodeValues& values) {
            for (std::size_t i = 0; i < row.count; ++i)
              put(stress_.within(row.root(row.first + i)), values, 1 + i);
          },
          [&](const NodeRow& row, NodeValues& values) {
            for (std::size_t i = 0; i < row.count; ++i) {
              const double complement = row.complement(row.first + i);
              put(stress_.beyond({1 - complement, complement}), values, 1 + i);
            }
          });
    }
    points_ += sum.nodes;
    stations_ = std::max(stations_, points_);
    return sum;
  }
  /// int s a' / (2 pi) de between two places, Pa m.
  [[nodiscard]] double base_force(const FoamStress::Place& outer, const FoamStress::Place& inner) const {
    const FoamCurve& curve = stress_.curve();
    const double moment = curve.moment(inner.strain) - curve.moment(outer.strain);
    return (piece_.width - piece_.taper * depth_of(0)) * (inner.base.work - outer.base.work) +
           piece_.taper * thickness_ * moment;
  }
  /// Depth behind the tip at which the nose meets the column with this leading strain, m.
  [[nodiscard]] double depth_of(double leading) const {
    return trial_penetration_ + (lead_ - leading) * thickness_;
  }
  /// a' / (2 pi) where the nose meets that column, m; rounding must not bring forward its jump at the rim.
  [[nodiscard]] double rate_at(const FoamStress::Place& leading) const {
    return piece_.rate(std::min(depth_of(leading.strain.value), nose_.depth));
  }
  /// The leading strain of a column with this strain, without cancellation at the axis.
  [[nodiscard]] Strain leading(double strain, double top) const {
    return {strain + lead_, (gap_ - lead_) + (top - strain)};
  }
  FoamStress::Ratio ratio(const FoamStress::Place& leading) {
    ++points_;
    stations_ = std::max(stations_, points_);
    return stress_.ratio(leading, ahead_, at_rate_, slip_rate_, in_crater_);
  }
  /// Returns a value with the sign of the stress: the ratio, which is smooth up to the edge; for crushed foam
  /// the stress, which without its lower limit changes sign at the gap.
  double press(const FoamStress::Place& place, FoamStress::Ratio ratio) {
    const double value = stress_.stays_crushed() ? ratio.stress * place.base.stress : ratio.stress;
    max_pressed_ = std::max(max_pressed_, value);
    return value;
  }
  double sign_at(double strain, double top) {
    const FoamStress::Place place = stress_.at(leading(strain, top));
    return press(place, ratio(place));
  }
  /// Root of f between two places with values of different signs, by the Illinois rule from the last root on.
  /// As the stress vanishes there, an error of the root has an effect of second order.
  template <class F>
  double crossing(F&& f, double low, double f_low, double high, double f_high) {
    const double precision = edge_precision_ * (high - low);
    int side = 0;
    const auto look = [&](double place) {
      const double value = f(place);
      if ((value > 0) == (f_low > 0)) {
        low = place;
        f_low = value;
        if (side < 0) f_high /= 2;
        side = -1;
      } else {
        high = place;
        f_high = value;
        if (side > 0) f_low /= 2;
        side = 1;
      }
      return value;
    };
    if (low < edge_ && edge_ < high) {
      const double beyond = 1.1 * look(edge_) / edge_slope_;
      const double next = edge_ - beyond - std::copysign(precision / 2, beyond);
      side = 0;
      if (low < next && next < high) look(next);
      side = 0;
    }
    const auto root = [&] { return (low * f_high - high * f_low) / (f_high - f_low); };
    for (int i = 0; i < 60 && high - low > precision; ++i) {
      const double place = root();
      if (!(place > low && place < high)) break;
      look(place);
    }
    edge_slope_ = (f_high - f_low) / (high - low);
    // The values may vanish on a pad that was struck before and carries next to nothing.
    const double found = root();
    return edge_ = std::isfinite(found) ? found : (low + high) / 2;
  }

  Law law_;
  FoamStress stress_;
  double thickness_ = 0;
  Sections nose_;
  double factor_ = 1;
  ColumnMath math_ = ColumnMath::vector;  ///< computation of the integral's nodes
  const FoamNodeMath* vectors_ = &foam_node_math();
  NodeValues values_;
  std::vector<SectionPiece> pieces_;  ///< pieces of a shape
  SectionPiece piece_;                ///< piece being integrated; other noses have only this
  double thin_ = 0;
  double panels_ = 8;
  double earlier_ = 0;      ///< largest penetration of earlier blows, m
  double left_ = 0;         ///< the same of this blow when the nose left the pad, m
  double crater_ = 0;       ///< depth at which the nose meets the foam, m
  double penetration_ = 0;  ///< below the surface of the new pad, as the next ones, m
  double largest_ = 0;      ///< largest penetration so far, m
  SlipScale::State slip_;   ///< state of the slip (theory.md, Eq. 34)
  double rate_ = 0;         ///< strain rate of the last step, 1/s
  double rate_step_ = 0;    ///< length of the last step, s; 0: there was none
  double pressing_ = -1;    ///< depth up to which columns press, m; below 0: none do
  PadTrial last_;
  double trial_penetration_ = 0;
  double trial_largest_ = 0;
  SlipScale::State trial_slip_;
  double trial_rate_ = 0;
  double trial_pressing_ = -1;
  double ahead_ = 0;     ///< largest strain less strain, the same for all columns
  double left_out_ = 0;  ///< part of the ratio left out where only the rate's stress is wanted
  double lead_ = 0;      ///< leading strain less strain
  double gap_ = 0;       ///< gap on the axis over the thickness
  bool in_crater_ = false;
  double edge_ = 0;  ///< root of the strain where the last ring of columns began to press
  double edge_slope_ = 1;
  double edge_precision_ = 0;
  double slip_rate_ = 0;
  Overstress::AtRate at_rate_;
  double relaxing_ = 0;
  double max_pressed_ = 0;    ///< largest value of press() in this trial
  std::size_t points_ = 0;    ///< columns evaluated in this trial
  std::size_t stations_ = 0;  ///< largest points_ since the start
  std::size_t updates_ = 0;
};

static_assert(HasRateCorners<FoamContact> && FollowsRate<FoamContact> && RemembersBlows<FoamContact>);

}  // namespace dashpad
