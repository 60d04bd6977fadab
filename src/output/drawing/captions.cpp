#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "output/drawing/annotations.hpp"
#include "output/drawing/drawing_words.hpp"
#include "output/drawing/elements.hpp"
#include "output/drawing/support_picture.hpp"
#include "output/svg/text_fit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Room that a name on the pad needs, px.
constexpr double least_height = 20;
constexpr double least_half_width = 60;

bool has_names_on_pad(const Scene& scene) {
  if (scene.pad_half_width() < least_half_width || scene.moments.crater > 0) return false;
  for (std::size_t i = 0; i < scene.moments.layers.size(); ++i)
    if (scene.front_of_layer(i + 1) - scene.front_of_layer(i) < least_height) return false;
  return true;
}

std::string name_of_layer(const Scene& scene, std::size_t i) {
  const std::string name = one_line(scene.moments.layers[i].name);
  return scene.moments.layers.size() == 1 ? name : fmt::format("{} {}", i + 1, name);
}

/// The pad as far as it is not written beside it.
std::string pad_words(const Scene& scene) {
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  const auto length = [&](double value) { return unbroken(brief_quantity(value, "m", scene.units, 3)); };
  if (!has_names_on_pad(scene))
    for (std::size_t i = 0; i < scene.moments.layers.size(); ++i) add(unbroken(name_of_layer(scene, i)));
  if (const auto& half = scene.moments.half_width) add("a block, " + length(2 * *half) + " across as drawn");
  if (scene.impact.pad.sheet > 0)
    add("under a sheet of " + unbroken(brief_quantity(scene.impact.pad.sheet, "kg/m2", scene.units, 3)));
  if (const double earlier = scene.impact.pad.earlier_penetration; earlier > 0)
    add("struck before to a depth of " + length(earlier));
  return text;
}

}  // namespace

std::string names_on_pad(const Scene& scene) {
  std::string text;
  if (!has_names_on_pad(scene)) return text;
  for (std::size_t i = 0; i < scene.moments.layers.size(); ++i) {
    const double from = scene.front_of_layer(i), to = scene.front_of_layer(i + 1);
    // A pad that is cut has its break below the middle.
    const double middle = scene.layout.pad_is_cut ? from + 0.3 * (to - from) : (from + to) / 2;
    text += text_element("dd-text dd-on-pad", {scene.left.axis, scene.layout.face + middle + 5}, "middle",
                         fitting(name_of_layer(scene, i), text_size, 2 * scene.pad_half_width() - 16));
  }
  return text;
}

std::vector<std::string> caption_lines(const Scene& scene) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& text) {
    for (std::string& line : lines_within(text, text_size, scene.layout.captions_width))
      lines.push_back(std::move(line));
  };
  add("Nose: " + nose_words(scene.impact.impactor.nose, scene.units));
  if (const std::string pad = pad_words(scene); !pad.empty()) add("Pad: " + pad);
  add("Support: " + support_words(scene.impact, scene.units));
  if (scene.layout.sink_is_cut) add("The way of the support is not to scale.");
  return lines;
}

}  // namespace dashpad::output
