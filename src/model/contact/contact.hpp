#pragma once
/// The contact of a nose with a pad, as the solver uses it.
///
/// A trial advances the penetration evenly over a step and returns the force of the pad, as a value: it
/// changes no state, and any trial from the accepted state may be accepted. A contact may keep what it
/// computed for the last trial, and computes it again for another one.
///
/// Penetration in m from first contact on, times in s since then, forces in N, compression positive.

#include <concepts>
#include <cstddef>
#include <limits>

namespace dashpad {

/// A step tried with a given advance of the penetration, and the force at its end.
struct PadTrial {
  double advance = 0;  ///< advance of the penetration, m; may be far below its rounding
  double from = 0;     ///< start of the step, s
  double step = 0;     ///< length of the step, s
  double force = 0;    ///< force of the pad at its end, N
  /// Advance with which the step ends beyond the trial, m, small against `advance`, as the nose takes up what
  /// is left of Eq. 25: only accept() asks for it, of a contact that follows the rate.
  double further = 0;

  [[nodiscard]] double whole_advance() const { return advance + further; }
  [[nodiscard]] double end() const { return from + step; }
  /// Whether start and length agree, so that what depends on time alone is the same.
  [[nodiscard]] bool shares_time_with(const PadTrial& other) const {
    return from == other.from && step == other.step;
  }
  [[nodiscard]] bool is_same_step_as(const PadTrial& other) const {
    return advance == other.advance && shares_time_with(other);
  }
};

/// Value of largest_stress() where no column is pressed: just below zero.
inline constexpr double not_pressed = -std::numeric_limits<double>::min();

template <class C>
concept IsContact = requires(C contact, const C fixed, const PadTrial& trial, double x) {
  /// Starts a run at rest. Arguments: resolution, and expected largest penetration, m.
  contact.start(x, x);
  /// Arguments: advance, m; start and length of the step, s.
  { contact.trial(x, x, x) } -> std::same_as<PadTrial>;
  /// dF/dt if the penetration were held from the end of the trial on, N/s (theory.md, Eq. 26).
  { contact.force_rate_when_held(trial) } -> std::same_as<double>;
  /// Positive if any column still presses at the end of the trial (theory.md, Eq. 27).
  { contact.largest_stress(trial) } -> std::same_as<double>;
  /// Makes the end of the trial the accepted state; no other call but start() changes it.
  contact.accept(trial);
  /// Whether the pad follows its law back on unloading; if not, it holds its deformation.
  { fixed.recovers() } -> std::same_as<bool>;
  /// Force at which the pad, untouched before, begins to give way, N.
  { fixed.first_force() } -> std::same_as<double>;
  /// Penetration at which the pad locks, m (theory.md, Eq. 29).
  { fixed.lock_penetration() } -> std::same_as<double>;
  { fixed.contact_radius() } -> std::same_as<double>;
  /// Number of columns, and of column updates in all trials since the start: the cost of the run.
  { fixed.stations() } -> std::same_as<std::size_t>;
  { fixed.updates() } -> std::same_as<std::size_t>;
};

/// A pad without memory: the work done on it is a function of its penetration, J.
template <class C>
concept HasEnergy = IsContact<C> && requires(const C contact, double x) {
  { contact.energy(x) } -> std::same_as<double>;
};

/// A pad that may have been struck before (theory.md, Eqs. 46 to 48).
template <class C>
concept RemembersBlows = IsContact<C> && requires(const C contact) {
  /// Depth of the crater in which the nose meets the pad, m below the surface of the new pad.
  { contact.crater() } -> std::same_as<double>;
  /// Penetration at which the pad joins its first loading, where the force has a kink, m; 0: none.
  { contact.joint() } -> std::same_as<double>;
};

/// A pad whose force follows the rate at once, so that it seems the stiffer the shorter the step is.
/// lasting_stiffness is dF/dY without that effect, N/m.
template <class C>
concept FollowsRate = IsContact<C> && requires(C contact, const PadTrial& trial) {
  { contact.lasting_stiffness(trial) } -> std::same_as<double>;
};

/// A pad whose memory may be shorter than the step, with the same effect.
template <class C>
concept MayForget = IsContact<C> && requires(const C contact, const PadTrial& trial) {
  { contact.forgets(trial) } -> std::same_as<bool>;
};

/// A pad whose force has a corner where the rate that it follows falls to a tested one.
template <class C>
concept HasRateCorners = IsContact<C> && requires(C contact, const PadTrial& trial) {
  /// The next tested rate below the present rate, 1/s; 0: none.
  { contact.rate_corner() } -> std::same_as<double>;
  /// The rate at the end of a trial, 1/s.
  { contact.slip_rate(trial) } -> std::same_as<double>;
};

/// A pad of layers, each with a strain of its own.
template <class C>
concept HasLayers = IsContact<C> && requires(const C contact, std::size_t layer) {
  { contact.layers() } -> std::same_as<std::size_t>;
  /// Strain of a layer on the axis.
  { contact.axis_strain(layer) } -> std::same_as<double>;
  /// Number of the updates for a root within a root, which take longer.
  { contact.nested_updates() } -> std::same_as<std::size_t>;
};

}  // namespace dashpad
