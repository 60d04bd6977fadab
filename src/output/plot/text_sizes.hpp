#pragma once
/// Sizes of the texts of a plot.

namespace dashpad::output {

/// px. A plot as wide as a phone is shown somewhat smaller than it is laid out; pages with more room set
/// smaller texts.
inline constexpr double title_text = 18, panel_title_text = 15, axis_text = 14,
                        label_text = 13.5,  ///< of names beside what they name, and of numbers
    source_text = 12;

}  // namespace dashpad::output
