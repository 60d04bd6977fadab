#pragma once
/// A contact whose columns are helped by their neighbours: its force times g(Y), on the way in and, as an
/// assumption, on the way back (theory.md, Eq. 57).
///
/// The state is that of the columns. All other requirements of contact.hpp are passed on.

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
class WithNeighbours {
 public:
  WithNeighbours(Contact& contact, const ColumnFactor& factor)
      : contact_(contact), factor_(factor), is_one_(factor.is_one()) {}

  void start(double resolution, double expected) {
    contact_.start(resolution, expected);
    penetration_ = depth_at_first();
    if constexpr (HasEnergy<Contact>) work_before_ = is_one_ ? 0 : work(penetration_);
  }
  PadTrial trial(double advance, double from, double step) {
    PadTrial trial = contact_.trial(advance, from, step);
    if (!is_one_) trial.force *= factor_(penetration_ + advance);
    return trial;
  }
  void accept(const PadTrial& trial) {
    contact_.accept(of_columns(trial));
    penetration_ += trial.advance;
  }
  double force_rate_when_held(const PadTrial& trial) {
    return contact_.force_rate_when_held(of_columns(trial)) * factor_at(trial);
  }
  /// Largest stress of the columns alone; only its sign is used.
  double largest_stress(const PadTrial& trial) { return contact_.largest_stress(of_columns(trial)); }
  [[nodiscard]] bool recovers() const { return contact_.recovers(); }
  [[nodiscard]] double first_force() const { return contact_.first_force() * factor_(depth_at_first()); }
  [[nodiscard]] double lock_penetration() const { return contact_.lock_penetration(); }
  [[nodiscard]] double contact_radius() const { return contact_.contact_radius(); }
  [[nodiscard]] std::size_t stations() const { return contact_.stations(); }
  [[nodiscard]] std::size_t updates() const { return contact_.updates(); }

  /// Work at a penetration since first contact, J.
  [[nodiscard]] double energy(double y) const requires HasEnergy<Contact> {
    if (is_one_) return contact_.energy(y);
    return work(depth_at_first() + y) - work_before_;
  }

  [[nodiscard]] double crater() const requires RemembersBlows<Contact> { return contact_.crater(); }
  [[nodiscard]] double joint() const requires RemembersBlows<Contact> { return contact_.joint(); }
  void meet_again() requires requires(Contact contact) { contact.meet_again(); }
  { contact_.meet_again(); }

  double lasting_stiffness(const PadTrial& trial) requires FollowsRate<Contact> {
    return contact_.lasting_stiffness(of_columns(trial)) * factor_at(trial);
  }
  [[nodiscard]] bool forgets(const PadTrial& trial) const requires MayForget<Contact> {
    return contact_.forgets(of_columns(trial));
  }
  double rate_corner() requires HasRateCorners<Contact> { return contact_.rate_corner(); }
  double slip_rate(const PadTrial& trial) requires HasRateCorners<Contact> {
    return contact_.slip_rate(of_columns(trial));
  }

  [[nodiscard]] std::size_t layers() const requires HasLayers<Contact> { return contact_.layers(); }
  [[nodiscard]] std::size_t nested_updates() const requires HasLayers<Contact> {
    return contact_.nested_updates();
  }
  [[nodiscard]] double axis_strain(std::size_t layer) const requires HasLayers<Contact> {
    return contact_.axis_strain(layer);
  }

 private:
  [[nodiscard]] double depth_at_first() const {
    if constexpr (RemembersBlows<Contact>)
      return contact_.crater();
    else
      return 0;
  }
  [[nodiscard]] double factor_at(const PadTrial& trial) const {
    return is_one_ ? 1 : factor_(penetration_ + trial.advance);
  }
  [[nodiscard]] PadTrial of_columns(PadTrial trial) const {
    if (!is_one_) trial.force /= factor_at(trial);
    return trial;
  }
  [[nodiscard]] double work(double y) const requires HasEnergy<Contact> {
    return factor_.work(y, [&](double to, int n) { return contact_.integral(to, n); });
  }

  Contact& contact_;
  ColumnFactor factor_;
  bool is_one_;
  double penetration_ = 0;  ///< below the surface of the new pad, m
  double work_before_ = 0;  ///< work up to the crater of an earlier blow, J
};

/// Whether WithNeighbours satisfies all concepts that the contact does; a missing member would go unnoticed
/// otherwise.
template <class Contact>
inline constexpr bool hands_on_all =
    HasEnergy<Contact> == HasEnergy<WithNeighbours<Contact>>&& RemembersBlows<Contact> ==
    RemembersBlows<WithNeighbours<Contact>>&& FollowsRate<Contact> ==
    FollowsRate<WithNeighbours<Contact>>&& MayForget<Contact> ==
    MayForget<WithNeighbours<Contact>>&& HasRateCorners<Contact> ==
    HasRateCorners<WithNeighbours<Contact>>&& HasLayers<Contact> == HasLayers<WithNeighbours<Contact>>;

}  // namespace dashpad
