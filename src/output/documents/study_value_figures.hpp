#pragma once
/// Figures of the responses of a study, for the top of its page: where draws lie, and ranges over a grid.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::output {

using AsText = std::function<std::string(double)>;

/// Values of that response with unit and three digits.
AsText in_unit_of(const std::string& response, const UnitSystem& units);

/// "95 % interval 10.1 to 14.2 %"; empty where there is none.
std::string interval_of(const study::Estimate& of, const AsText& shown);

/// The response with the strictest limit, else the first of all.
std::size_t leading_response(const study::StudyAnswers& answers);

/// Median and 95 % quantile of a response over draws, towards its limit.
void add_quantiles(std::vector<ValueRow>& figures, const study::StudyAnswers& answers, std::size_t response,
                   const UnitSystem& units);

/// Of the other responses, where most draws lie.
void add_spreads(std::vector<ValueRow>& figures, const study::StudyAnswers& answers, std::size_t leading,
                 const UnitSystem& units);

/// Over several combinations of levels, the least and the greatest median of each response.
void add_medians(std::vector<ValueRow>& figures, const study::StudyAnswers& answers, const UnitSystem& units);

/// The least peak of each thickness from the highest drop, of which the answer speaks.
void add_least_peaks(std::vector<ValueRow>& figures, const study::CushionCurves& curves,
                     const UnitSystem& units);

/// The least and the greatest value of the leading response with where they are, and the range of others.
void add_ranges(std::vector<ValueRow>& figures, const study::StudyAnswers& answers, const UnitSystem& units);

}  // namespace dashpad::output
