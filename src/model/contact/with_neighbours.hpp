#pragma once
/// A contact whose columns are helped by their neighbours: its force times g(Y), on the way in and, as an
/// assumption, on the way back (theory.md, Eq. 57).
///
/// The state is that of the columns; largest_stress() is theirs as well, since only its sign is used.

#include <algorithm>
#include <cstddef>

#include "dashpad/quantities/constants.hpp"
#include "model/contact/contact.hpp"

namespace dashpad {

/// Factor of the force of independent columns for the help of their neighbours (theory.md, Eq. 57).
///
///   g(Y) = first + slope Y + bend Y^2 up to the penetration `until`, constant beyond
///
/// Y is counted from the surface of the new pad, m; g is dimensionless, and positive up to the lock.
struct ColumnFactor {
  double first = 1;
  double slope = 0;         ///< 1/m
  double bend = 0;          ///< 1/m2
  double until = infinite;  ///< m

  [[nodiscard]] bool is_one() const { return first == 1 && slope == 0 && bend == 0; }
  [[nodiscard]] double operator()(double y) const {
    const double x = std::clamp(y, 0.0, until);
    return first + x * (slope + x * bend);
  }
  /// Work of the force g F from 0 to y, J, by parts; `integral(y, n)` is the n-fold integral In of F from 0.
  ///
  ///   W = g I1 - g' I2 + g'' I3
  template <class Integral>
  [[nodiscard]] double work(double y, const Integral& integral) const {
    const double x = std::min(y, until);
    const double within = (*this)(x)*integral(x, 1) - (slope + 2 * bend * std::max(x, 0.0)) * integral(x, 2) +
                          2 * bend * integral(x, 3);
    return y > until ? within + (*this)(until) * (integral(y, 1) - integral(until, 1)) : within;
  }

  bool operator==(const ColumnFactor&) const = default;
};

template <IsContact Contact>
class WithNeighbours : public Contact {
 public:
  /// `arguments` are those of the contact; likewise in set().
  template <class... Arguments>
  explicit WithNeighbours(const ColumnFactor& factor, const Arguments&... arguments)
      : Contact(arguments...), factor_(factor), is_one_(factor.is_one()) {}
  template <class... Arguments>
  void set(const ColumnFactor& factor, const Arguments&... arguments) {
    Contact::set(arguments...);
    factor_ = factor;
    is_one_ = factor.is_one();
  }

  void start(double resolution, double expected) {
    Contact::start(resolution, expected);
    penetration_ = depth_at_first();
    if constexpr (HasEnergy<Contact>) work_before_ = is_one_ ? 0 : work(penetration_);
  }
  PadTrial trial(double advance, double from, double step) {
    PadTrial trial = Contact::trial(advance, from, step);
    if (!is_one_) trial.force *= factor_(penetration_ + advance);
    return trial;
  }
  void accept(const PadTrial& trial) {
    Contact::accept(trial);
    penetration_ += trial.whole_advance();
  }
  double force_rate_when_held(const PadTrial& trial) {
    return Contact::force_rate_when_held(trial) * factor_at(trial);
  }
  double lasting_stiffness(const PadTrial& trial) requires FollowsRate<Contact> {
    return Contact::lasting_stiffness(trial) * factor_at(trial);
  }
  [[nodiscard]] double first_force() const { return Contact::first_force() * factor_(depth_at_first()); }
  /// Work at a penetration since first contact, J.
  [[nodiscard]] double energy(double y) const requires HasEnergy<Contact> {
    return is_one_ ? Contact::energy(y) : work(depth_at_first() + y) - work_before_;
  }

 private:
  [[nodiscard]] double depth_at_first() const {
    if constexpr (RemembersBlows<Contact>)
      return Contact::crater();
    else
      return 0;
  }
  [[nodiscard]] double factor_at(const PadTrial& trial) const {
    return is_one_ ? 1 : factor_(penetration_ + trial.advance);
  }
  [[nodiscard]] double work(double y) const requires HasEnergy<Contact> {
    return factor_.work(y, [&](double to, int n) { return Contact::integral(to, n); });
  }

  ColumnFactor factor_;
  bool is_one_;
  double penetration_ = 0;  ///< below the surface of the new pad, m
  double work_before_ = 0;  ///< work up to the crater of an earlier blow, J
};

}  // namespace dashpad
