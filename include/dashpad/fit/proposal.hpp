#pragma once
/// A fit proposed for compression tests: law, base curve and unknowns by what was measured. SI throughout;
/// stress and strain are engineering values, compression positive. docs/fits.md describes the rules.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::fit {

/// A compression test as a fit file names it.
struct TestSource {
  std::filesystem::path file;
  input::StressStrainColumns columns = {};  ///< with the column of times, if its rate is not stated
  std::optional<double> rate = {};          ///< 1/s, > 0; absent: by the times in the file
};

/// A test in short.
struct Evidence {
  std::string file;                     ///< with the column, if the file has several tests
  double rate = 0;                      ///< 1/s, mean of its loading
  double highest_strain = 0;            ///< [0, 1)
  double largest_stress = 0;            ///< Pa
  double first_stress = 0;              ///< Pa, of its first point
  std::size_t loading_points = 0;       ///< along the first loading
  std::optional<double> returned = {};  ///< energy given back over energy taken in; absent without a way back
  double strain_left = 0;  ///< strain at which the way back has lost its stress; 0 if it does not
  std::optional<double> lost_held = {};  ///< share of the stress lost while the strain was held
  double time_held = 0;                  ///< s, of the longest hold
  bool has_cycles = false;               ///< whether it was loaded again
};

/// A law with its base curve and rate effect that might fit.
struct Candidate {
  std::string law;   ///< "foam"
  std::string base;  ///< form of its base curve: "table", "avalle"
  std::string rate;  ///< "none", "power", "power with slope", "by relaxation"
  Fit fit;
  /// Reason to try one that takes long, if the others miss by more than misfit_of_others; empty: always
  /// tried.
  std::string if_others_miss = {};
};

inline constexpr double misfit_of_others = 0.02;

/// The fits that tests allow.
struct Proposal {
  std::vector<TestSource> sources;    ///< in the order of the tests in each fit
  std::vector<Evidence> tests;        ///< likewise
  std::vector<std::string> reasons;   ///< for law, base curve and unknowns, a sentence each
  std::vector<Candidate> candidates;  ///< at least one; those that may be left out come last
};

/// Reads the tests and proposes fits to them. `rates`, 1/s, are those of the files in their order and may be
/// fewer where headers or times tell them. Faults of all files at once: those of the tables; a rate that
/// nothing tells; a strain that is held without times; a single loading with too few points for a formula.
input::Reading<Proposal> propose(const std::vector<std::filesystem::path>& files,
                                 std::span<const double> rates, const input::StressStrainColumns& wanted);

/// The misfit of a candidate.
struct Tried {
  std::string law, base, rate;
  std::optional<double>
      misfit;  ///< root mean square over the largest stress of each test; absent if it failed
  std::size_t unknowns = 0;
  std::size_t open = 0;  ///< unknowns that the data do not determine
};

/// The candidate that was chosen, with its result.
struct AutoFit {
  Proposal proposal;
  std::vector<Tried> tried;  ///< in the order of the candidates
  std::size_t chosen = 0;
  FitReport report;
  std::vector<std::string> open;  ///< what the tests leave open, a sentence each
  std::vector<std::string> next;  ///< what to measure next, the most valuable first

  [[nodiscard]] const Candidate& candidate() const { return proposal.candidates[chosen]; }
};

/// Fits all candidates and chooses: the law with the least misfit; the base curve with the least misfit, or a
/// fifth more if more of its unknowns are determined; a slope of the rate's exponent only if its interval
/// excludes 0 and the misfit falls by a twentieth. Throws Stopped.
AutoFit run_proposal(Proposal proposal, const RunOptions& options = {});

}  // namespace dashpad::fit
