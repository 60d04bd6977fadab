#include <fmt/format.h>

#include "output/plot/svg_plot.hpp"

namespace dashpad::output {

namespace {

// The colours by turns are Okabe and Ito's, which the colour-blind tell apart, but for yellow, which is too
// pale on white; on dark paper the same, lighter. Letters on white are darker than lines, to be read. Series
// take theirs as currentColor: not every renderer has variables.
constexpr std::string_view colours = R"(
.dp-plot{font-family:system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
.dp-paper{fill:#fff}
.dp-title{font-weight:600;fill:#1a2028}
.dp-panel-title{font-weight:600;fill:#1a2028}
.dp-axis-title,.dp-label{fill:#1a2028}
.dp-tick{fill:#3c4652;font-variant-numeric:tabular-nums}
.dp-source{fill:#58626e}
.dp-end-label,.dp-mark-label{fill:currentColor}
.dp-mark-label{stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}
.dp-to-end{text-anchor:end}
.dp-centred{text-anchor:middle}
.dp-axis{fill:none;stroke:#58626e}
.dp-grid{fill:none;stroke:#dde1e6}
.dp-minor-grid{fill:none;stroke:#eef0f3}
.dp-line{fill:none;stroke:currentColor;stroke-linejoin:round}
.dp-dash-1{stroke-dasharray:10 4}
.dp-dash-2{stroke-dasharray:3 3}
.dp-dash-3{stroke-dasharray:10 4 2 4}
.dp-dash-4{stroke-dasharray:16 4 2 4 2 4}
.dp-dash-5{stroke-dasharray:6 4 2 2}
.dp-across{stroke-dasharray:5 3}
.dp-band{fill:currentColor;fill-opacity:.22}
.dp-area{fill:currentColor;stroke:currentColor;stroke-width:.7;stroke-linejoin:round}
.dp-disc{fill:none;stroke:currentColor;stroke-width:5.6;stroke-linecap:round}
.dp-dot{fill:none;stroke:currentColor;stroke-width:3.2;stroke-linecap:round}
.dp-shape{fill:currentColor}
.dp-ring{fill:none;stroke:currentColor;stroke-width:1.4}
.dp-leader{fill:none;stroke:currentColor;stroke-width:.8;stroke-dasharray:1.5 2.5}
.dp-casing{color:#fff}
.dp-grey{color:#555}
.dp-turn-0{color:#0072b2}
.dp-turn-1{color:#d55e00}
.dp-turn-2{color:#009e73}
.dp-turn-3{color:#cc79a7}
.dp-turn-4{color:#e69f00}
.dp-turn-5{color:#56b4e9}
.dp-turn-6{color:#000}
.dp-turn-1 text{fill:#b34f00}
.dp-turn-2 text{fill:#007a59}
.dp-turn-3 text{fill:#a34c7c}
.dp-turn-4 text{fill:#8a6000}
.dp-turn-5 text{fill:#1c74ad}
@media screen and (prefers-color-scheme:dark){
.dp-paper{fill:#14181d}
.dp-title,.dp-panel-title,.dp-axis-title,.dp-label{fill:#e6eaef}
.dp-tick,.dp-source{fill:#a3adb8}
.dp-axis{stroke:#a3adb8}
.dp-grid{stroke:#39424d}
.dp-minor-grid{stroke:#232a31}
.dp-casing{color:#14181d}
.dp-mark-label{stroke:#14181d}
.dp-grey{color:#a3adb8}
.dp-turn-0{color:#4aa8e8}
.dp-turn-1{color:#f5874a}
.dp-turn-2{color:#2fc79a}
.dp-turn-3{color:#e79ccb}
.dp-turn-4{color:#f0b840}
.dp-turn-5{color:#a5dcfb}
.dp-turn-6{color:#f2f2f2}
.dp-end text,.dp-mark text{fill:currentColor}
}
)";

/// All in proportion to one, by which a page makes them smaller together.
std::string sizes() {
  const auto rule = [](const char* name, double size) {
    return fmt::format(".{}{{font-size:{:.4g}em}}\n", name, size / label_text);
  };
  return fmt::format("\n.dp-plot{{font-size:{}px}}\n", label_text) + rule("dp-title", title_text) +
         rule("dp-panel-title", panel_title_text) + rule("dp-axis-title,.dp-label", axis_text) +
         rule("dp-source", source_text);
}

}  // namespace

std::string_view style_sheet(PlotStyle style) {
  static const std::string all = sizes() + std::string(colours);
  const std::string_view both = all;
  switch (style) {
    case PlotStyle::none: return {};
    case PlotStyle::light: return both.substr(0, both.find("@media"));
    case PlotStyle::light_and_dark: return both;
  }
  return {};
}

}  // namespace dashpad::output
