#include <string>

#include <fmt/format.h>

#include "dashpad/output/drawing/impact_drawing.hpp"
#include "output/drawing/elements.hpp"
#include "output/drawing/strain_scale.hpp"

namespace dashpad::output {

namespace {

/// Contrasts of texts are 4.5 to 1 and more on either paper.
std::string text_rules() {
  return fmt::format(
      ".dd-drawing text{{font-family:system-ui,-apple-system,\"Segoe UI\",Roboto,\"Helvetica Neue\",Arial,"
      "\"DejaVu Sans\",sans-serif;font-size:{}px;font-variant-numeric:tabular-nums}}"
      ".dd-drawing .dd-heading{{font-size:{}px;font-weight:600}}"
      ".dd-drawing .dd-value{{font-weight:600}}"
      ".dd-drawing .dd-small,.dd-drawing .dd-faint{{font-size:{}px}}",
      text_size, heading_size, small_text_size);
}

constexpr const char* rules =
    ".dd-drawing .dd-on-pad{paint-order:stroke;stroke-width:3px;stroke-linejoin:round}"
    ".dd-line,.dd-leader,.dd-extension,.dd-rest,.dd-tick,.dd-tested,.dd-cut,.dd-pad-edge,.dd-layer-edge,"
    ".dd-part,.dd-arrow{fill:none}"
    ".dd-line,.dd-leader,.dd-extension,.dd-rest{stroke-width:.8}"
    ".dd-rest{stroke-dasharray:5 3}"
    ".dd-tick,.dd-cut,.dd-part{stroke-width:1.3}"
    ".dd-pad-edge,.dd-layer-edge{stroke-width:1.1}"
    ".dd-tested,.dd-ground,.dd-arrow{stroke-width:2}"
    ".dd-nose,.dd-panel,.dd-body{stroke-width:1.4}"
    ".dd-struck-edge{stroke-width:5}"
    ".dd-sheet-bent{stroke-linejoin:round}"
    ".dd-hatching{fill:none;stroke-width:1;stroke-opacity:.45}"
    ".dd-break{stroke-width:1.1}";

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
  return rule(".dd-paper", "fill:" + paper) +
         rule(".dd-drawing text,.dd-mark,.dd-arrow-head", "fill:" + text) +
         rule(".dd-drawing .dd-small,.dd-drawing .dd-faint", "fill:" + faint) +
         rule(".dd-drawing .dd-alarm", "fill:" + alarm) + rule(".dd-drawing .dd-on-pad", "stroke:" + paper) +
         rule(".dd-line,.dd-leader,.dd-extension,.dd-rest", "stroke:" + line) +
         rule(".dd-tick,.dd-tested,.dd-cut,.dd-arrow", "stroke:" + text) +
         rule(".dd-pad-edge,.dd-layer-edge,.dd-part,.dd-ground,.dd-hatching,.dd-break,.dd-sheet-bent",
              "stroke:" + edge) +
         rule(".dd-sheet-face,.dd-sheet-bent", "fill:" + edge) +
         rule(".dd-nose,.dd-panel,.dd-body", "fill:" + nose + ";stroke:" + edge) +
         rule(".dd-break", "fill:" + paper) + rule(".dd-struck-edge", "stroke:" + alarm);
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
  return text_rules() + rules + colour_rules(light) + shade_rules(false) +
         "@media screen and (prefers-color-scheme:dark){" + colour_rules(dark) + shade_rules(true) + "}";
}

}  // namespace

std::string_view impact_drawing_style() {
  static const std::string style = whole_style();
  return style;
}

}  // namespace dashpad::output
