#include <string>

#include "dashpad/output/drawing/impact_drawing.hpp"
#include "output/drawing/strain_scale.hpp"

namespace dashpad::output {

namespace {

/// Contrasts of texts are 4.5 to 1 and more on either paper.
constexpr const char* rules =
    ".dp-drawing text{font-family:system-ui,-apple-system,\"Segoe UI\",Roboto,\"Helvetica Neue\",Arial,"
    "\"DejaVu Sans\",sans-serif;font-size:13px;font-variant-numeric:tabular-nums}"
    ".dp-drawing .dp-heading{font-size:15px;font-weight:600}"
    ".dp-drawing .dp-value{font-weight:600}"
    ".dp-drawing .dp-small,.dp-drawing .dp-faint{font-size:12px}"
    ".dp-drawing .dp-on-pad{paint-order:stroke;stroke-width:3px;stroke-linejoin:round}"
    ".dp-line,.dp-leader,.dp-extension,.dp-rest,.dp-tick,.dp-tested,.dp-cut,.dp-pad-edge,.dp-layer-edge,"
    ".dp-part,.dp-arrow{fill:none}"
    ".dp-line,.dp-leader,.dp-extension,.dp-rest{stroke-width:.8}"
    ".dp-rest{stroke-dasharray:5 3}"
    ".dp-tick,.dp-cut,.dp-part{stroke-width:1.3}"
    ".dp-pad-edge,.dp-layer-edge{stroke-width:1.1}"
    ".dp-tested,.dp-ground,.dp-arrow{stroke-width:2}"
    ".dp-nose,.dp-panel,.dp-body{stroke-width:1.4}"
    ".dp-struck-edge{stroke-width:5}"
    ".dp-hatching{fill:none;stroke-width:1;stroke-opacity:.45}"
    ".dp-break{stroke-width:1.1}";

struct Colours {
  const char* paper;
  const char* text;
  const char* faint;
  const char* line;
  const char* nose;
  const char* edge;
  const char* alarm;
};

std::string colour_rules(const Colours& colours) {
  const auto rule = [](const std::string& selectors, const std::string& declarations) {
    return selectors + "{" + declarations + "}";
  };
  const std::string paper = colours.paper, text = colours.text, faint = colours.faint, line = colours.line,
                    nose = colours.nose, edge = colours.edge, alarm = colours.alarm;
  return rule(".dp-paper", "fill:" + paper) +
         rule(".dp-drawing text,.dp-mark,.dp-arrow-head", "fill:" + text) +
         rule(".dp-drawing .dp-small,.dp-drawing .dp-faint", "fill:" + faint) +
         rule(".dp-drawing .dp-alarm", "fill:" + alarm) + rule(".dp-drawing .dp-on-pad", "stroke:" + paper) +
         rule(".dp-line,.dp-leader,.dp-extension,.dp-rest", "stroke:" + line) +
         rule(".dp-tick,.dp-tested,.dp-cut,.dp-arrow", "stroke:" + text) +
         rule(".dp-pad-edge,.dp-layer-edge,.dp-part,.dp-ground,.dp-hatching,.dp-break", "stroke:" + edge) +
         rule(".dp-nose,.dp-panel,.dp-body", "fill:" + nose + ";stroke:" + edge) +
         rule(".dp-break", "fill:" + paper) + rule(".dp-struck-edge", "stroke:" + alarm);
}

std::string whole_style() {
  const Colours light{.paper = "#fff",
                      .text = "#1a2028",
                      .faint = "#58626e",
                      .line = "#6b7682",
                      .nose = "#c9cfd6",
                      .edge = "#3c4754",
                      .alarm = "#b3161d"};
  const Colours dark{.paper = "#14181d",
                     .text = "#e6eaef",
                     .faint = "#a3adb8",
                     .line = "#87919c",
                     .nose = "#566170",
                     .edge = "#b9c3ce",
                     .alarm = "#ff8b85"};
  return rules + colour_rules(light) + shade_rules(false) + "@media screen and (prefers-color-scheme:dark){" +
         colour_rules(dark) + shade_rules(true) + "}";
}

}  // namespace

std::string_view impact_drawing_style() {
  static const std::string style = whole_style();
  return style;
}

}  // namespace dashpad::output
