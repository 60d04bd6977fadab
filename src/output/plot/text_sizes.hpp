#pragma once
/// Sizes of the texts of a plot.

namespace dashpad::output {

/// px. A plot as wide as a phone is shown somewhat smaller than it is laid out; pages with more room set
/// smaller texts.
inline constexpr double title_text = 18, panel_title_text = 16, axis_text = 15.2,
                        label_text = 14.8,  ///< of names beside what they name, and of numbers
    source_text = 12.5;

}  // namespace dashpad::output
