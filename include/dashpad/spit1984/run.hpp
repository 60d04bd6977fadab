#pragma once
/// The impact as subroutines SPIT and PAD Version 2 (December 1984) computed it, PAD alone, and what is
/// written of a run.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/spit1984/deck.hpp"

namespace dashpad::spit1984 {

/// The numbers that the program computes with.
enum class Arithmetic {
  binary32,  ///< IEEE single precision: what a later machine would have made of the listing
  binary64,  ///< IEEE double precision: what the report's section A.5 advises
  pdp10,     ///< the 36-bit words of the machine that printed Appendix C (dashpad/spit1984/pdp10.hpp)
};

/// The defects of the listing; docs/spit1984.md shows what each does to the results. True: as printed, which
/// is the faithful mode. False: mended.
struct Defects {
  /// A trial that does not widen the contact keeps the bookkeeping of an earlier trial (LAST, RL), and a
  /// later restore puts that back. Mended: every trial starts from the contact at the start of the step.
  bool stale_contact = true;
  /// The later segments of a piecewise-linear support are added where `1 - X(j)/XS > 1`, which compression
  /// never meets: the first slope acts alone. Mended: the secant of the curve, F(XS)/XS.
  bool idle_segments = true;
  /// The strain of the station on the contact edge is what rounding leaves of zero, and a power of it enters
  /// the stress one step later. Mended: it is zero.
  bool edge_residue = true;
  /// The check for tension starts at the outermost station and ends at the first that is not tensile. Laws 4
  /// and 5 set the outermost stress to zero, so it ends there and the rim of the contact pulls on the sphere.
  /// Mended: a tensile stress is zero.
  bool tension = true;

  friend bool operator==(const Defects&, const Defects&) = default;
};

inline constexpr Defects all_mended{false, false, false, false};

/// For people: the name on the command line and one line of explanation.
struct Defect {
  const char* name;
  bool Defects::*present;
  const char* meaning;
};

inline constexpr std::array<Defect, 4> defects{{
    {"stale-contact", &Defects::stale_contact,
     "a rejected trial restores the contact of an earlier one, not that of the step's start"},
    {"idle-segments", &Defects::idle_segments,
     "only the first slope of a piecewise-linear support ever acts"},
    {"edge-residue", &Defects::edge_residue,
     "the strain on the contact edge is rounding error instead of zero"},
    {"tension", &Defects::tension,
     "the rim of the contact pulls on the sphere during rebound (laws 4 and 5)"},
}};

/// What the listing has as constants and dimensions.
struct Settings {
  Arithmetic arithmetic = Arithmetic::pdp10;
  Defects defects;
  int max_steps = 1000;                 ///< dimension of the time history; ABEND 902 beyond
  int max_stations = 1000;              ///< dimension of the contact field; ABEND 904 beyond
  int max_iterations = 100;             ///< ABEND 900 beyond
  double equilibrium_tolerance = 0.02;  ///< TOLMAX, of the force; Eq. 21
  double precision_tolerance = 1e-5;    ///< TOL, of the penetration; Eq. 23
};

/// Why a run ended before its time; the numbers are the listing's statement numbers.
enum class Abend {
  none = 0,
  too_many_iterations = 900,
  bisection_failed = 901,
  too_many_time_steps = 902,
  rate_sensitive_instability = 903,
  too_many_contact_divisions = 904,
};

/// An iteration that stopped at the precision of the penetration, its force out of equilibrium by `error`.
struct PrecisionStop {
  int step = 0;         ///< K, the vector index: time is (K - 2) time steps
  double force_lb = 0;  ///< negative in compression
  double error = 0;     ///< fraction of the force
};

/// One time of the history. Signs are the program's: force and acceleration are negative in compression,
/// speed, motion and penetration positive towards the pad.
struct Step {
  double time_ms = 0;
  double force_lb = 0;
  double acceleration_g = 0;  ///< 0 in the last step of a run, where the program no longer computes it
  double speed_in_per_s = 0;
  double motion_in = 0;
  double penetration_in = 0;
};

struct Run {
  std::vector<Step> history;     ///< from first contact, t = 0 (vector index 2), to the last step (index K)
  double rebound_speed_mph = 0;  ///< VREB: negative, away from the pad
  double duration_ms = 0;
  double time_of_peak_force_ms = 0;
  double peak_force_lb = 0;                             ///< negative
  std::array<double, 4> tangent_stiffness_lb_per_in{};  ///< SPAR(9) to SPAR(12)
  Abend abend = Abend::none;
  /// False after ABENDs 900, 901 and 904: the last row is that of a trial, as printed.
  bool last_step_accepted = true;
  std::optional<double> speed_error;  ///< Eq. 27, with ABEND 903 only; fraction of the last speed
  std::vector<PrecisionStop> precision_stops;
  int halvings = 0;      ///< of the time step, at the end
  int max_stations = 0;  ///< that the contact field held
  long trials = 0;       ///< penetrations tried, all steps together
};

/// Short names: "binary32", "binary64", "pdp10".
const char* to_string(Arithmetic arithmetic);

/// What an ABEND said, "too many iterations" for example, and what to do about it (report, section A.5).
struct AbendText {
  const char* message;
  const char* advice;
};
/// Not for Abend::none.
AbendText text_of(Abend abend);

/// The largest time step with which the report's section A.3 expects the motion to stay stable, ms:
/// 0.25 sqrt(M/K), with the largest tangent stiffness of the support.
double longest_time_step_ms(const Deck& deck);

/// Is told the number of each time step as it begins.
using Progress = std::function<void(int step)>;

/// Runs the program; what goes wrong in a sound deck is an ABEND. Throws std::invalid_argument for
/// violations() of the deck, fewer than 3 time steps or fewer than 2 stations. Memory is taken for the
/// dimensions at once.
Run run(const Deck& deck, const Settings& settings = {}, const Progress& progress = {});

/// The stress of one station at the end of each step, psi, positive in compression (the program's own sign is
/// negative). `strains` are positive in compression and begin with 0, that of first contact; one stress each,
/// the first 0. `step` in s, > 0. Law 5 takes its time at the end of a step, as in the program.
///
/// The stress may be tensile, below zero: it is SPIT, not PAD, that looks for tension. On the way back to
/// strain zero laws 4 and 5 divide by the strain; the last stresses there mean nothing.
///
/// Throws std::invalid_argument for parameters that violations(Deck) refuses, fewer than two strains, a first
/// one that is not 0, or strains outside [0, 1).
std::vector<double> column_stresses(PadKey pad, const std::array<double, 21>& parameters,
                                    const std::vector<double>& strains, double step,
                                    Arithmetic arithmetic = Arithmetic::pdp10);

/// The same of a material of one of the five laws, in Pa. Throws std::invalid_argument for a material that no
/// deck of the program can hold.
std::vector<double> stresses_of_update(const Material& material, const std::vector<double>& strains,
                                       double step);

/// The two devices that the listing writes to. The line printer (unit 21) printed Appendix C. Only the
/// terminal (unit 5) is told of iterations stopped at the precision limit and of ABENDs 903 and 904.
enum class Device { printer, terminal };

/// The report in the layout of the report's Appendix C: FORMAT statements 6000 and 601 to 613. Lines end in
/// '\n'. The first character of each Fortran record is carriage control and becomes what it did: '1' a form
/// feed, '0' an empty line before.
std::string listing(const Deck& deck, const Run& run, Device device);

/// The deck, how it was run and what came out, as JSON. Keys name the units; forces are negative in
/// compression, the rebound speed is negative. A number that is not finite is null.
std::string run_json(const Deck& deck, const Settings& settings, const Run& run);

/// The time history, every step of it, as CSV: time_ms, force_lbf, acceleration_g, speed_in_per_s, motion_in,
/// penetration_in. Numbers read back as the very same double; one that is not finite is an empty field.
std::string run_csv(const Run& run);

}  // namespace dashpad::spit1984
