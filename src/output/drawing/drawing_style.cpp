// The style sheet of the drawing, the colours of strains and their legend.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dashpad/output/impact.hpp"
#include "output/drawing/pictures.hpp"
#include "quantities/text.hpp"

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

/// The rules with colours, by the names that PaperColours has for them.
constexpr const char* rules_of_colours =
    ".dd-paper{fill:$paper}"
    ".dd-drawing text,.dd-mark,.dd-arrow-head{fill:$text}"
    ".dd-drawing .dd-small,.dd-drawing .dd-faint{fill:$faint}"
    ".dd-drawing .dd-alarm{fill:$alarm}"
    ".dd-drawing .dd-on-pad{stroke:$paper}"
    ".dd-line,.dd-leader,.dd-extension,.dd-rest{stroke:$line}"
    ".dd-tick,.dd-tested,.dd-cut,.dd-arrow{stroke:$text}"
    ".dd-pad-edge,.dd-layer-edge,.dd-part,.dd-ground,.dd-hatching,.dd-break,.dd-sheet-bent{stroke:$edge}"
    ".dd-sheet-face,.dd-sheet-bent{fill:$edge}"
    ".dd-nose,.dd-panel,.dd-body{fill:$nose;stroke:$edge}"
    ".dd-break{fill:$paper}"
    ".dd-struck-edge{stroke:$alarm}";

struct PaperColours {
  std::array<std::pair<const char*, const char*>, 7> named;
  std::array<Colour, 5> strains;  ///< small strains are near the colour of the paper
};
constexpr PaperColours on_light{
    {{{"$paper", "#fff"},
      {"$text", "#1a2028"},
      {"$faint", "#58626e"},
      {"$line", "#6b7682"},
      {"$nose", "#c9cfd6"},
      {"$edge", "#3c4754"},
      {"$alarm", "#b3161d"}}},
    {{{0xee, 0xf4, 0xf9}, {0xa6, 0xc9, 0xe6}, {0x4a, 0x90, 0xc8}, {0x14, 0x55, 0x94}, {0x06, 0x22, 0x4a}}}};
constexpr PaperColours on_dark{
    {{{"$paper", "#14181d"},
      {"$text", "#e6eaef"},
      {"$faint", "#a3adb8"},
      {"$line", "#87919c"},
      {"$nose", "#566170"},
      {"$edge", "#b9c3ce"},
      {"$alarm", "#ff8b85"}}},
    {{{0x23, 0x2d, 0x38}, {0x2c, 0x51, 0x74}, {0x3f, 0x86, 0xbd}, {0x86, 0xc2, 0xee}, {0xe6, 0xf4, 0xff}}}};

std::string colour_rules(const PaperColours& on) {
  std::string text = rules_of_colours;
  for (const auto& [name, colour] : on.named) replace_all(text, name, colour);
  for (int shade = 0; shade < shades_of_strain; ++shade)
    text += fmt::format(".{}{{fill:{}}}", shade_class(shade),
                        colour_on_scale(on.strains, double(shade) / (shades_of_strain - 1)));
  return text;
}

/// A number at a strain, the layer that it is of.
struct Mark {
  double strain = 0;
  std::vector<std::size_t> layers;

  [[nodiscard]] std::string label() const { return fmt::format("{}", fmt::join(layers, ", ")); }
};

bool touch(const Mark& left, const Mark& right, double width) {
  constexpr double apart = 6;
  return (right.strain - left.strain) * width <
         text_room(left.label() + right.label(), small_text_size) / 2 + apart;
}

/// Labels for the strains of layers. Labels that would touch become one, in the order of the scale: "3, 1".
template <class StrainOf>
std::vector<Mark> labels(const DrawnMoments& moments, double width, StrainOf&& strain_of) {
  std::vector<Mark> list;
  for (std::size_t i = 0; i < moments.layers.size(); ++i)
    if (const std::optional<double> strain = strain_of(moments.layers[i])) list.push_back({*strain, {i + 1}});
  std::ranges::stable_sort(list, {}, &Mark::strain);
  std::vector<Mark> apart;
  for (const Mark& mark : list) {
    apart.push_back(mark);
    // A shared label is longer, and may touch the one before.
    while (apart.size() > 1 && touch(apart[apart.size() - 2], apart.back(), width)) {
      const Mark last = apart.back();
      apart.pop_back();
      apart.back().layers.insert(apart.back().layers.end(), last.layers.begin(), last.layers.end());
    }
  }
  return apart;
}

std::string tested_words(const DrawnMoments& moments) {
  if (std::ranges::none_of(moments.layers, [](const DrawnLayer& layer) { return layer.tested.has_value(); }))
    return "";
  const char* const how = std::ranges::any_of(moments.layers, &DrawnLayer::has_curves) ? "tested" : "fitted";
  return moments.layers.size() == 1 ? fmt::format("{} up to {:.3g}", how, *moments.layers[0].tested)
                                    : fmt::format("{} up to the bars", how);
}

}  // namespace

std::string_view impact_drawing_style() {
  static const std::string style = text_rules() + rules + colour_rules(on_light) +
                                   "@media screen and (prefers-color-scheme:dark){" + colour_rules(on_dark) +
                                   "}";
  return style;
}

std::string shade_class(int shade) {
  return fmt::format("dd-s{}", std::clamp(shade, 0, shades_of_strain - 1));
}

std::string strain_legend(const DrawnMoments& moments, Place corner, double width) {
  const bool layered = moments.layers.size() > 1;
  const double bar = corner.y + (layered ? 45 : 28), height = 10;
  std::string text = text_element("dd-text", {corner.x, corner.y + 13}, "start", "Strain");
  text += text_element("dd-faint", {corner.x + width, corner.y + 13}, "end", tested_words(moments));
  for (int shade = 0; shade < shades_of_strain; ++shade) {
    const double left = std::round(corner.x + width * shade / shades_of_strain);
    const double right = std::round(corner.x + width * (shade + 1) / shades_of_strain);
    text += rectangle_element(shade_class(shade), left, bar, right - left, height);
  }
  text += rectangle_element("dd-line", corner.x, bar, width, height);
  const auto x_of = [&](double strain) { return corner.x + width * strain; };
  for (const DrawnLayer& layer : moments.layers) {
    const double x = x_of(layer.strain);
    text += path_element("dd-mark dd-strain-reached", {{x - 4.5, bar - 8}, {x + 4.5, bar - 8}, {x, bar - 1}},
                         true);
    if (layer.tested)
      text +=
          line_element("dd-tested", {x_of(*layer.tested), bar - 4}, {x_of(*layer.tested), bar + height + 4});
  }
  const auto write = [&](const char* style, const std::vector<Mark>& list, double y) {
    for (const Mark& mark : list) text += text_element(style, {x_of(mark.strain), y}, "middle", mark.label());
  };
  if (layered) {
    const auto reached = [](const DrawnLayer& layer) { return std::optional(layer.strain); };
    write("dd-small dd-strain-reached", labels(moments, width, reached), bar - 11);
    write("dd-small", labels(moments, width, [](const DrawnLayer& layer) { return layer.tested; }),
          bar + height + 17);
  }
  for (const double strain : {0.0, 1.0})
    text += text_element("dd-small", {x_of(strain) + (strain == 0 ? -3 : 3), bar + height + 17},
                         strain == 0 ? "start" : "end", strain == 0 ? "0" : "1");
  return text;
}

}  // namespace dashpad::output
