#pragma once
/// Subroutines SPIT and PAD Version 2 (December 1984), PAD alone, and the output of a run.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/spit1984/deck.hpp"

namespace dashpad::spit1984 {

/// The arithmetic of the program.
enum class Arithmetic {
  binary32,  ///< IEEE single precision, as on a later machine
  binary64,  ///< IEEE double precision, as the report's section A.5 advises
  pdp10,     ///< the 36-bit words of the machine that printed Appendix C (dashpad/spit1984/pdp10.hpp)
};

/// The defects of the listing; docs/spit1984.md shows their effects. True: as printed; false: mended.
struct Defects {
  /// A trial that does not widen the contact keeps the bookkeeping of an earlier trial (LAST, RL), which a
  /// later restore then brings back. Mended: every trial starts from the contact at the start of the step.
  bool stale_contact = true;
  /// The later segments of a piecewise-linear support are added where `1 - X(j)/XS > 1`, which compression
  /// never meets: the first slope acts alone. Mended: the secant of the curve, F(XS)/XS.
  bool idle_segments = true;
  /// The strain of the station on the contact edge is a rounding error instead of zero, and a power of it
  /// enters the stress one step later. Mended: it is zero.
  bool edge_residue = true;
  /// The check for tension goes inwards from the outermost station and stops at the first one that is not
  /// tensile. Laws 4 and 5 set the outermost stress to zero, so it stops there and the rim of the contact
  /// pulls on the sphere. Mended: a tensile stress is zero.
  bool tension = true;

  friend bool operator==(const Defects&, const Defects&) = default;
};

inline constexpr Defects all_mended{false, false, false, false};

/// A defect for people: its name on the command line and an explanation of one line.
struct Defect {
  const char* name;
  bool Defects::*present;
  const char* meaning;
};

inline constexpr std::array<Defect, 4> defects{{
    {"stale-contact", &Defects::stale_contact,
     "after a rejected trial, the contact is reset to an earlier trial, not to the start of the step"},
    {"idle-segments", &Defects::idle_segments,
     "only the first slope of a piecewise-linear support is ever used"},
    {"edge-residue", &Defects::edge_residue,
     "the strain at the contact edge is a rounding error instead of zero"},
    {"tension", &Defects::tension,
     "the rim of the contact pulls on the sphere during rebound (laws 4 and 5)"},
}};

/// Constants and dimensions of the listing.
struct Settings {
  Arithmetic arithmetic = Arithmetic::pdp10;
  Defects defects;
  int max_steps = 1000;                 ///< dimension of the time history; ABEND 902 beyond
  int max_stations = 1000;              ///< dimension of the contact field; ABEND 904 beyond
  int max_iterations = 100;             ///< ABEND 900 beyond
  double equilibrium_tolerance = 0.02;  ///< TOLMAX, of the force; Eq. 21
  double precision_tolerance = 1e-5;    ///< TOL, of the penetration; Eq. 23
};

/// The reason why a run ended early; the numbers are the listing's statement numbers.
enum class Abend {
  none = 0,
  too_many_iterations = 900,
  bisection_failed = 901,
  too_many_time_steps = 902,
  rate_sensitive_instability = 903,
  too_many_contact_divisions = 904,
};

/// An iteration that stopped at the penetration's precision limit, its force out of balance by `error`.
struct PrecisionStop {
  int step = 0;         ///< K, the vector index: time is (K - 2) time steps
  double force_lb = 0;  ///< negative in compression
  double error = 0;     ///< fraction of the force
};

/// One row of the history, with the program's signs: force and acceleration are negative in compression;
/// speed, motion and penetration are positive towards the pad.
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
  /// False after ABENDs 900, 901 and 904: then the last row is that of a trial, as printed.
  bool last_step_accepted = true;
  std::optional<double> speed_error;  ///< Eq. 27, with ABEND 903 only; fraction of the last speed
  std::vector<PrecisionStop> precision_stops;
  int halvings = 0;      ///< how often the time step was halved
  int max_stations = 0;  ///< largest number in the contact field
  long trials = 0;       ///< number of penetrations tried in all steps
};

/// Short names: "binary32", "binary64", "pdp10".
const char* to_string(Arithmetic arithmetic);

/// The message of an ABEND, such as "too many iterations", and the report's advice (section A.5).
struct AbendText {
  const char* message;
  const char* advice;
};
/// Not for Abend::none.
AbendText text_of(Abend abend);

/// The largest time step for which the report expects stable motion (section A.3), ms: 0.25 sqrt(M/K), with
/// the largest tangent stiffness of the support.
double longest_time_step_ms(const Deck& deck);

/// Receives the number of each time step as it begins.
using Progress = std::function<void(int step)>;

/// Runs the program. Failures of a valid deck are ABENDs. Throws std::invalid_argument for violations() of
/// the deck, fewer than 3 time steps or fewer than 2 stations. Memory is allocated at once.
Run run(const Deck& deck, const Settings& settings = {}, const Progress& progress = {});

/// The stress of one station at the end of each step, psi, positive in compression unlike in the program.
/// `strains` are positive in compression and begin with 0 at first contact; there is one stress per strain,
/// the first 0. `step` in s, > 0. Law 5 takes its time at the end of a step, as in the program.
///
/// The stress may be tensile, since SPIT, not PAD, looks for tension. Near strain zero on the way back, laws
/// 4 and 5 divide by the strain, and their last stresses are meaningless.
///
/// Throws std::invalid_argument for parameters that violations(Deck) refuses, fewer than two strains, a first
/// strain other than 0, or strains outside [0, 1).
std::vector<double> column_stresses(PadKey pad, const std::array<double, 21>& parameters,
                                    const std::vector<double>& strains, double step,
                                    Arithmetic arithmetic = Arithmetic::pdp10);

/// The same stresses in Pa, for a material of one of the five laws. Throws std::invalid_argument for a
/// material that no deck can hold.
std::vector<double> stresses_of_update(const Material& material, const std::vector<double>& strains,
                                       double step);

/// The output devices of the listing. The line printer (unit 21) printed Appendix C. Only the terminal (unit
/// 5) reports iterations stopped at the precision limit and ABENDs 903 and 904.
enum class Device { printer, terminal };

/// The printout in the layout of the report's Appendix C: FORMAT statements 6000 and 601 to 613. Lines end in
/// '\n'. Carriage control in the first character of a Fortran record is carried out: '1' becomes a form feed,
/// '0' an empty line before.
std::string listing(const Deck& deck, const Run& run, Device device);

/// The deck, the settings and the results as JSON. Keys name the units; forces in compression and the rebound
/// speed are negative. Numbers that are not finite are null.
std::string run_json(const Deck& deck, const Settings& settings, const Run& run);

/// The whole time history as CSV: time_ms, force_lbf, acceleration_g, speed_in_per_s, motion_in,
/// penetration_in. Numbers read back as the same double; one that is not finite is an empty field.
std::string run_csv(const Run& run);

}  // namespace dashpad::spit1984
