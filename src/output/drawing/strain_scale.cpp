#include "output/drawing/strain_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/svg/colour_scale.hpp"
#include "output/svg/svg.hpp"
#include "output/svg/text_fit.hpp"

namespace dashpad::output {

namespace {

constexpr std::array<Colour, 5> on_light{
    {{0xee, 0xf4, 0xf9}, {0xa6, 0xc9, 0xe6}, {0x4a, 0x90, 0xc8}, {0x14, 0x55, 0x94}, {0x06, 0x22, 0x4a}}};
constexpr std::array<Colour, 5> on_dark{
    {{0x23, 0x2d, 0x38}, {0x2c, 0x51, 0x74}, {0x3f, 0x86, 0xbd}, {0x86, 0xc2, 0xee}, {0xe6, 0xf4, 0xff}}};

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

/// The layers that have such a strain. Those whose numbers would touch share a label, in their order on the
/// scale: "3, 1".
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
  double lowest = 1;
  bool any = false;
  for (const DrawnLayer& layer : moments.layers)
    if (layer.tested) {
      lowest = std::min(lowest, *layer.tested);
      any = true;
    }
  if (!any) return "";
  const char* const how = std::ranges::any_of(moments.layers, &DrawnLayer::has_curves) ? "tested" : "fitted";
  return moments.layers.size() == 1 ? fmt::format("{} up to {:.3g}", how, lowest)
                                    : fmt::format("{} up to the bars", how);
}

}  // namespace

std::string shade_class(int shade) {
  return fmt::format("dd-s{}", std::clamp(shade, 0, shades_of_strain - 1));
}

std::string shade_rules(bool dark) {
  std::string text;
  for (int shade = 0; shade < shades_of_strain; ++shade)
    text += fmt::format(".{}{{fill:{}}}", shade_class(shade),
                        colour_on_scale(dark ? on_dark : on_light, double(shade) / (shades_of_strain - 1)));
  return text;
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
