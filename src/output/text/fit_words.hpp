#pragma once
/// Words and tables of a fit.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/fit/report.hpp"
#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The largest misses of the held-out or of the fitted data; absent where there are no such data.
struct Misses {
  std::optional<double> tests;    ///< root mean square over the largest stress
  std::optional<double> figures;  ///< over the stated deviation
  std::optional<double> pulses;   ///< root mean square over the measured peak
};
Misses misses(const fit::FitReport& report, bool held_out);

/// "7 unknowns from 150 points of 1 test: the data determine all of them." and how many starts came to it.
std::string fit_answer(const fit::FitReport& report);

/// The unknown that the program added to those of the fit file, and why; empty if it added none.
std::string words_on_added(const fit::FitReport& report);

/// "The data determine all 5 unknowns; the model misses the tests by 1.2 % of their largest stress (rms)."
std::string fit_headline(const fit::FitReport& report);

/// The accuracy of the predictions of held-out data; empty if nothing was held out.
std::string prediction_words(const fit::FitReport& report);

/// "1.2 to 3.4 kPa", "from 1.2 kPa, with no upper bound", "unbounded on both sides"; ends at natural bounds.
std::string interval_words(const fit::FittedUnknown& unknown, const UnitSystem& units);

/// Unknowns that the data do not determine, a sentence each.
std::vector<std::string> open_matters(const fit::FitReport& report);

/// The origin of the noise and the effect of correlated residuals, a sentence each.
std::vector<std::string> notes_on_noise(const fit::FitReport& report);

/// "1.5 s", "15 min", "2.5 h".
std::string duration_words(double seconds);

Table table_of_unknowns(const fit::FitReport& report, const UnitSystem& units);
Table table_of_tests(const fit::FitReport& report, const UnitSystem& units);
Table table_of_figures(const fit::FitReport& report, const UnitSystem& units);
/// Peak, HIC and rebound of impacts, measured and of the model.
Table table_of_comparison(const fit::FitReport& report, const UnitSystem& units);
/// A row a loop: energy given back over energy put in.
Table table_of_loops(const fit::FitReport& report);
Table table_of_pulses(const fit::FitReport& report, const UnitSystem& units);

}  // namespace dashpad::output
