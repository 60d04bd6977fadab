#include <fmt/format.h>

#include "output/drawing/annotations.hpp"
#include "output/drawing/drawing_words.hpp"
#include "output/drawing/elements.hpp"
#include "output/svg/text_fit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string heading(const Scene& scene, const Picture& picture, const std::string& words) {
  return text_element("dd-heading", {picture.axis - scene.layout.half_width, 18}, "start", words);
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
      heading(scene, scene.left,
              scene.summary.blows > 1 ? fmt::format("First contact of blow {}", scene.summary.blow)
                                      : "First contact");
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
  const auto& time = scene.moments.time;
  const std::string words = scene.moments.is_so_far ? "Deepest so far" : "Greatest penetration";
  std::string text = heading(scene, scene.right,
                             time ? words + ", at " + brief_quantity(*time, "s", scene.units, 3) : words);
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
