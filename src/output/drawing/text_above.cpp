#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "output/drawing/annotations.hpp"
#include "output/drawing/drawing_words.hpp"
#include "output/drawing/elements.hpp"
#include "output/svg/text_fit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The first of the wordings that has room; the last one is cut if it has none.
std::string heading(const Scene& scene, const Picture& picture, double end,
                    const std::vector<std::string>& wordings) {
  const double x = picture.axis - scene.layout.half_width, size = size_for_bold * heading_size;
  std::size_t i = 0;
  while (i + 1 < wordings.size() && text_room(wordings[i], size) > end - x) ++i;
  return text_element("dd-heading", {x, 18}, "start", fitting(wordings[i], size, end - x));
}

/// With its time, where that is known.
std::vector<std::string> wordings_of_deepest(const Scene& scene) {
  const std::string words = scene.moments.is_so_far ? "Deepest so far" : "Greatest penetration";
  if (!scene.moments.time) return {words};
  const std::string time = brief_quantity(*scene.moments.time, "s", scene.units, 3);
  return {words + ", at " + time, words + ", " + time, "Deepest at " + time};
}

}  // namespace

std::string text_above_left(const Scene& scene) {
  const Impactor& impactor = scene.impact.impactor;
  const auto shown = [&](double value, const char* unit) {
    return brief_quantity(value, unit, scene.units, 3);
  };
  const bool falls = impactor.gravity > 0;
  const double x = scene.left.axis;
  std::string text =
      heading(scene, scene.left, scene.layout.left_end,
              {scene.summary.blows > 1 ? fmt::format("First contact of blow {}", scene.summary.blow)
                                       : "First contact"});
  text += line_element("dd-arrow", {x, 32}, {x, 58});
  text += path_element("dd-arrow-head", {{x - 5, 54}, {x + 5, 54}, {x, 65}}, true);
  text += text_element("dd-value", {x - 14, 52}, "end", shown(impactor.mass, "kg"));
  text += text_element("dd-value", {x + 14, falls ? 44.0 : 52.0}, "start", shown(impactor.speed, "m/s"));
  if (falls)
    text += text_element("dd-small", {x + 14, 61}, "start",
                         "drop of " + shown(impactor.speed * impactor.speed / (2 * impactor.gravity), "m"));
  return text;
}

std::string text_above_right(const Scene& scene) {
  std::string text = heading(scene, scene.right, drawing_width, wordings_of_deepest(scene));
  const std::string alarm = alarm_words(scene.moments);
  const double x = scene.right.axis - scene.layout.half_width;
  const double width = drawing_width - x - 4;
  if (!alarm.empty())
    text += text_element("dd-value dd-alarm dd-strain-reached", {x, 40}, "start",
                         fitting(alarm, text_size, width));
  return text + text_element("dd-text dd-strain-reached", {x, alarm.empty() ? 40.0 : 58.0}, "start",
                             fitting(strain_words(scene.moments), text_size, width));
}

}  // namespace dashpad::output
