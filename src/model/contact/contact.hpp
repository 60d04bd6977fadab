#pragma once
/// What the contact of a nose with a pad is to the solver.
///
/// The penetration is told to advance evenly over a step, and the pad answers with its force. An answer is a
/// value: trying a step changes nothing, and any trial from the accepted state may be accepted. A contact may
/// keep what it computed for the last trial, and computes it again if it is asked about another one.
///
/// Penetration in m from first contact on, times in s since then, forces in N, compression positive.

#include <concepts>
#include <cstddef>
#include <limits>

namespace dashpad {

/// A step that the penetration was told to take, and the force at its end.
struct PadTrial {
  double advance = 0;  ///< of the penetration; may be far below the rounding of the penetration
  double from = 0;     ///< when the step begins
  double step = 0;     ///< its length
  double force = 0;    ///< of the pad at its end

  [[nodiscard]] double end() const { return from + step; }
  /// Of the same length from the same moment; what depends on time alone is the same.
  [[nodiscard]] bool shares_time_with(const PadTrial& other) const {
    return from == other.from && step == other.step;
  }
  [[nodiscard]] bool is_same_step_as(const PadTrial& other) const {
    return advance == other.advance && shares_time_with(other);
  }
};

/// largest_stress() where no column is pressed: just below zero.
inline constexpr double not_pressed = -std::numeric_limits<double>::min();

template <class C>
concept IsContact = requires(C contact, const C fixed, const PadTrial& trial, double x) {
  /// At rest, for a run at the resolution x; the second number is the penetration that is expected, m.
  contact.start(x, x);
  /// Advance, begin and length of the step.
  { contact.trial(x, x, x) } -> std::same_as<PadTrial>;
  /// dF/dt if the penetration were held from the end of the trial on (theory.md, Eq. 26).
  { contact.force_rate_when_held(trial) } -> std::same_as<double>;
  /// Its sign says whether any column still presses at the end of the trial (theory.md, Eq. 27).
  { contact.largest_stress(trial) } -> std::same_as<double>;
  /// The only call that changes the state.
  contact.accept(trial);
  /// Whether the pad follows its law back on unloading; if not, it holds its deformation.
  { fixed.recovers() } -> std::same_as<bool>;
  /// Force at which the pad, untouched before, begins to give way, N.
  { fixed.first_force() } -> std::same_as<double>;
  /// Where the pad locks (theory.md, Eq. 29).
  { fixed.lock_penetration() } -> std::same_as<double>;
  { fixed.contact_radius() } -> std::same_as<double>;
  /// Columns, and how many of them were computed in all trials since the start: the cost of the run.
  { fixed.stations() } -> std::same_as<std::size_t>;
  { fixed.updates() } -> std::same_as<std::size_t>;
};

/// The work done on the pad is a function of its penetration: a pad without memory.
template <class C>
concept HasEnergy = IsContact<C> && requires(const C contact, double x) {
  { contact.energy(x) } -> std::same_as<double>;
};

/// The pad may have been struck before (theory.md, Eqs. 46 to 48).
template <class C>
concept RemembersBlows = IsContact<C> && requires(const C contact) {
  /// Depth of the crater in which the nose meets the pad, m below the surface of the new pad.
  { contact.crater() } -> std::same_as<double>;
  /// Penetration at which the pad goes over to its first loading: a kink of the force; 0: there is none.
  { contact.joint() } -> std::same_as<double>;
};

/// The force of the pad follows the rate at once. Over a short step it then changes as if the pad were
/// stiffer the shorter the step is; lasting_stiffness is dF/dY without that, N/m.
template <class C>
concept FollowsRate = IsContact<C> && requires(C contact, const PadTrial& trial) {
  { contact.lasting_stiffness(trial) } -> std::same_as<double>;
};

/// The same of a pad with a memory that is shorter than the step.
template <class C>
concept MayForget = IsContact<C> && requires(const C contact, const PadTrial& trial) {
  { contact.forgets(trial) } -> std::same_as<bool>;
};

/// The force has a corner where the rate that it follows comes down to a tested one.
template <class C>
concept HasRateCorners = IsContact<C> && requires(C contact, const PadTrial& trial) {
  /// The next below the rate now, 1/s; 0: none.
  { contact.rate_corner() } -> std::same_as<double>;
  /// At the end of a trial, 1/s.
  { contact.slip_rate(trial) } -> std::same_as<double>;
};

/// The pad has layers, each with a strain of its own.
template <class C>
concept HasLayers = IsContact<C> && requires(const C contact, std::size_t layer) {
  { contact.layers() } -> std::same_as<std::size_t>;
  /// Strain of a layer on the axis.
  { contact.axis_strain(layer) } -> std::same_as<double>;
  /// Updates that took longer: those for a root within a root.
  { contact.nested_updates() } -> std::same_as<std::size_t>;
};

}  // namespace dashpad
