#pragma once
/// The figures of a study; empty where the study has none of the kind.

#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "dashpad/study/questions.hpp"

namespace dashpad::output {

/// Empirical distribution functions, a panel a response.
std::vector<CaptionedPlot> distribution_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response over each sampled factor.
std::vector<CaptionedPlot> scatter_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response as the colour of its rows over the two sampled factors that it follows most.
std::vector<CaptionedPlot> coloured_scatter_figures(const study::StudyAnswers& answers,
                                                    const UnitSystem& units);
/// Sobol' indices with their intervals.
std::vector<CaptionedPlot> index_figures(const study::StudyAnswers& answers);
/// Each response over the factor with the most levels, a line for each level of the next.
std::vector<CaptionedPlot> curve_figures(const study::StudyAnswers& answers, const UnitSystem& units);
/// Each response as coloured areas over two factors with levels.
std::vector<CaptionedPlot> map_figures(const study::StudyAnswers& answers, const UnitSystem& units);
std::vector<CaptionedPlot> cushion_figures(const study::StudyAnswers& answers, const UnitSystem& units);

/// The small print.
std::string study_source(const study::StudyAnswers& answers);

}  // namespace dashpad::output
