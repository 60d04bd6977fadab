#pragma once
/// Factors and responses of a study: what they are called, and their values in the units of people.

#include <string>
#include <vector>

#include "dashpad/study/answers.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

/// The largest number of lines in a plot of a study.
inline constexpr std::size_t max_lines_drawn = 8;

/// Four significant digits: what a study of some thousand rows can tell. "-" if not finite.
std::string four_digits(double value);
/// The same of a value that is infinite where the pad bottomed out on a rigid support: those words then.
std::string four_digits_or_struck(double value);
/// "12.3 (11.9 to 12.8)", "12.3 (below 13)", "12.3" without an interval; an infinite value is "bottomed out".
std::string with_interval(const study::Estimate& estimate, double scale = 1);
/// The same with three decimals: shares.
std::string share_with_interval(const study::Estimate& share);
/// A share in per cent, with three digits, or five near all: "12.3 %", "99.963 %"; "undecided" if not finite.
std::string per_cent(double share);
/// The estimate of a share, in per cent.
std::string percent_with_interval(const study::Estimate& estimate);

/// The response that is the i-th with answers.
const std::string& response_name(const study::StudyAnswers& answers, std::size_t i);
/// "Peak force" of the response peak_force.
std::string title_of(const std::string& name);
std::string si_unit_of(const std::string& response);
/// The value with its unit and three digits, large values too: "9170 N".
std::string three_digits(const std::string& response, double value, const UnitSystem& units);
/// "2080 to 9170 N".
std::string three_digit_range(const std::string& response, double low, double high, const UnitSystem& units);
/// "Peak force (kN)".
std::string label(const std::string& response, const UnitSystem& units);

/// The indices in Study::factors of the factors with levels.
std::vector<std::size_t> level_factors(const study::Study& study);

/// "5 m/s", or the name of a material.
std::string level_text(const study::Study& study, std::size_t factor, double value, const UnitSystem& units);
/// "impact speed 5 m/s".
std::string factor_at(const study::Study& study, std::size_t factor, double value, const UnitSystem& units);
/// "impact speed 5 m/s, thickness of the pad 30 mm"; "" without levels.
std::string words_of_levels(const study::StudyAnswers& answers, const study::Group& group,
                            const UnitSystem& units);

/// "from 34.2 mm (95 % interval 33.9 mm to 34.6 mm)", "up to 30 mm, the greatest level, or more", "none of
/// the study".
std::string turning_text(const study::StudyAnswers& answers, const study::TurningLevel& turn,
                         const UnitSystem& units);
/// The levels of the other factors: "foam epp45"; "" without any.
std::string levels_beside(const study::StudyAnswers& answers, const study::TurningLevel& turn,
                          const UnitSystem& units);

/// The words for a key, "plateau stress of the foam" for pad.curve.plateau_stress; other keys unchanged.
std::string factor_words(const std::string& key);

/// The same, to begin a text with: "Thickness of the pad".
std::string factor_title(const std::string& key);

}  // namespace dashpad::output
