// The drawing in words: its title, its description, headings, captions and names.

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/drawing/pictures.hpp"
#include "output/svg/svg.hpp"
#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Replaces blanks by no-break spaces, to keep a number with its unit.
std::string unbroken(std::string text) {
  replace_all(text, " ", "\u00a0");
  return text;
}

/// "cylinder on its side, 120 mm across, 150 mm long"
std::string nose_words(const Scene& scene) {
  const auto shown = [&](double length) { return unbroken(scene.shown(length, "m")); };
  return std::visit(
      [&]<class Shape>(const Shape& shape) -> std::string {
        if constexpr (std::is_same_v<Shape, Sphere>)
          return fmt::format("sphere, {} across", shown(2 * shape.radius));
        else if constexpr (std::is_same_v<Shape, FlatDisc>)
          return fmt::format("flat disc, {} across", shown(2 * shape.radius));
        else if constexpr (std::is_same_v<Shape, Cone>)
          return fmt::format("cone, half angle {}, base {} across", scene.shown(shape.half_angle, "rad"),
                             shown(2 * shape.radius));
        else if constexpr (std::is_same_v<Shape, Ellipsoid>)
          return fmt::format("ellipsoid, {} across as drawn, {} across in the other direction",
                             shown(2 * shape.half_length), shown(2 * shape.half_width));
        else if constexpr (std::is_same_v<Shape, Rod>)
          return fmt::format("rod, {} across, dome radius {}", shown(2 * shape.radius),
                             shown(shape.tip_radius));
        else if constexpr (std::is_same_v<Shape, Platen>)
          return fmt::format("platen, {} long as drawn, {} wide", shown(shape.length), shown(shape.width));
        else if constexpr (std::is_same_v<Shape, Cylinder>)
          return fmt::format("cylinder on its side, {} across, {} long", shown(2 * shape.radius),
                             shown(shape.length));
        else if constexpr (std::is_same_v<Shape, Profile>)
          return fmt::format("shape through {} points, {} across", shape.points.size(),
                             shown(2 * shape.sections().radius(shape.sections().depth)));
        else
          return words_of(Nose(shape));
      },
      scene.impact.impactor.nose);
}

/// "a crushable spring of 100 N/mm, a panel of 1.2 kg": what stands there.
std::string support_words(const Scene& scene) {
  const Backing& backing = scene.impact.backing;
  const Support& support = scene.impact.support;
  const auto shown = [&](double value, const char* unit) { return unbroken(scene.shown(value, unit)); };
  std::string text = "rigid";
  if (!support.is_rigid()) {
    const auto& points = support.points();
    const Support::Point& last = points.back();
    text = backing.unloading_stiffness > 0 ? "a crushable spring " : "a spring ";
    text += points.size() == 1 ? "of " + shown(last.force / last.deflection, "N/m")
                               : fmt::format("with a curve up to {} at {}", shown(last.force, "N"),
                                             shown(last.deflection, "m"));
  }
  if (backing.damping > 0) text += ", a damper of " + shown(backing.damping, "N s/m");
  if (backing.loss_factor > 0) text += fmt::format(", a loss factor of {:.3g}", backing.loss_factor);
  if (backing.mass > 0) text += ", a panel of " + shown(backing.mass, "kg");
  if (backing.gap > 0) text += ", a gap of " + shown(backing.gap, "m");
  if (backing.preload > 0)
    text += fmt::format(", preloaded by {} against a stop", shown(backing.preload, "N"));
  if (backing.body_mass > 0) text += ", on a free body of " + shown(backing.body_mass, "kg");
  return text;
}

/// "Less than 0.1 % left", or the layers of which that is true; empty for another pad.
std::string alarm_words(const DrawnMoments& moments) {
  if (moments.bottomed) return "Bottomed out";
  if (moments.struck_through) return "Less than 0.1 % left";
  std::vector<std::size_t> layers;
  for (std::size_t i = 0; i < moments.layers.size(); ++i)
    if (moments.layers[i].struck_through) layers.push_back(i + 1);
  if (layers.empty()) return "";
  return fmt::format("Less than 0.1 % left in layer{} {}", layers.size() > 1 ? "s" : "",
                     fmt::join(layers, ", "));
}

/// "Strain on the axis 0.81"; of layers, each one's or the largest.
std::string strain_words(const DrawnMoments& moments) {
  if (moments.layers.size() == 1) return fmt::format("Strain on the axis {:.2f}", moments.layers[0].strain);
  if (moments.layers.size() > 3) {
    const auto most = std::ranges::max_element(moments.layers, {}, &DrawnLayer::strain);
    return fmt::format("Largest strain {:.2f}, in layer {}", most->strain, most - moments.layers.begin() + 1);
  }
  std::string text = moments.layers.size() == 2 ? "Strain in layers 1 and 2:" : "Strain in layers 1 to 3:";
  for (std::size_t i = 0; i < moments.layers.size(); ++i)
    text += fmt::format("{}{:.2f}", i == 0 ? " " : ", ", moments.layers[i].strain);
  return text;
}

/// Room that a name on the pad needs, px.
constexpr double min_height = 20;
constexpr double min_half_width = 60;

bool has_names_on_pad(const Scene& scene) {
  if (scene.pad_half_width() < min_half_width || scene.moments.crater > 0) return false;
  for (std::size_t i = 0; i < scene.moments.layers.size(); ++i)
    if (scene.front_of_layer(i + 1) - scene.front_of_layer(i) < min_height) return false;
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
  const auto shown = [&](double value, const char* unit) { return unbroken(scene.shown(value, unit)); };
  if (!has_names_on_pad(scene))
    for (std::size_t i = 0; i < scene.moments.layers.size(); ++i) add(unbroken(name_of_layer(scene, i)));
  if (const auto& half = scene.moments.half_width)
    add("a block, " + shown(2 * *half, "m") + " across as drawn");
  if (scene.impact.pad.sheet > 0) add("under a sheet of " + shown(scene.impact.pad.sheet, "kg/m2"));
  if (const double earlier = scene.impact.pad.earlier_penetration; earlier > 0)
    add("already compressed to a depth of " + shown(earlier, "m"));
  return text;
}

/// The first of the wordings that has room; the last one is cut if it has none.
std::string heading(const Scene& scene, const Picture& picture, double end,
                    const std::vector<std::string>& wordings) {
  const double x = picture.axis - scene.layout.half_width, size = size_for_bold * heading_size;
  std::size_t i = 0;
  while (i + 1 < wordings.size() && text_room(wordings[i], size) > end - x) ++i;
  return text_element("dd-heading", {x, 18}, "start", fitting(wordings[i], size, end - x));
}

/// The wordings of the right heading, the longest first.
std::vector<std::string> wordings_of_deepest(const Scene& scene) {
  const std::string words = scene.moments.is_so_far ? "Deepest so far" : "Greatest penetration";
  if (!scene.moments.time) return {words};
  const std::string time = scene.shown(*scene.moments.time, "s");
  return {words + ", at " + time, words + ", " + time, "Deepest at " + time};
}

}  // namespace

std::string drawing_title(const ImpactCase& impact) {
  if (!impact.title.empty()) return one_line(impact.title);
  return capitalised(with_article(words_of(impact.impactor.nose))) + " on a pad";
}

std::string drawing_description(const Scene& scene) {
  const ImpactCase& impact = scene.impact;
  const DrawnMoments& moments = scene.moments;
  const auto length = [&](double value) { return scene.shown(value, "m"); };
  std::string text = fmt::format("Left: first contact. {} of mass {} strikes a {} pad at {}.",
                                 capitalised(with_article(words_of(impact.impactor.nose))),
                                 scene.shown(impact.impactor.mass, "kg"), length(moments.thickness),
                                 scene.shown(impact.impactor.speed, "m/s"));
  if (moments.layers.size() > 1) text += fmt::format(" The pad has {} layers.", moments.layers.size());
  text += fmt::format(" Support: {}. Right: {}, {}; {} of the pad is left on the axis.", support_words(scene),
                      moments.is_so_far ? "deepest so far" : "greatest penetration",
                      length(moments.penetration), length(moments.left()));
  if (moments.deflection > 0) text += fmt::format(" The support deflects by {}.", length(moments.deflection));
  if (moments.body_motion > 0)
    text += fmt::format(" The body behind the support moves by {}.", length(moments.body_motion));
  if (const std::string alarm = alarm_words(moments); !alarm.empty()) text += " " + alarm + ".";
  text += " " + strain_words(moments) + "; the columns of the pad are shaded according to their strain.";
  text += " Nose and pad are drawn to scale; parts of the support";
  text += impact.pad.sheet > 0 ? " and the sheet on the pad are shown as symbols." : " are shown as symbols.";
  if (scene.layout.pad_is_cut) text += " Part of the pad is omitted.";
  if (scene.layout.sink_is_cut) text += " The deflection of the support is drawn shorter than it is.";
  return text;
}

std::string text_above_left(const Scene& scene) {
  const Impactor& impactor = scene.impact.impactor;
  const bool falls = impactor.gravity > 0;
  const double x = scene.left.axis;
  std::string text =
      heading(scene, scene.left, scene.layout.left_end,
              {scene.summary.blows > 1 ? fmt::format("First contact of blow {}", scene.summary.blow)
                                       : "First contact"});
  text += line_element("dd-arrow", {x, 32}, {x, 58});
  text += path_element("dd-arrow-head", {{x - 5, 54}, {x + 5, 54}, {x, 65}}, true);
  text += text_element("dd-value", {x - 14, 52}, "end", scene.shown(impactor.mass, "kg"));
  text +=
      text_element("dd-value", {x + 14, falls ? 44.0 : 52.0}, "start", scene.shown(impactor.speed, "m/s"));
  if (falls)
    text +=
        text_element("dd-small", {x + 14, 61}, "start",
                     "drop of " + scene.shown(impactor.speed * impactor.speed / (2 * impactor.gravity), "m"));
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
  add("Nose: " + nose_words(scene));
  if (const std::string pad = pad_words(scene); !pad.empty()) add("Pad: " + pad);
  add("Support: " + support_words(scene));
  if (scene.layout.sink_is_cut) add("The deflection of the support is not to scale.");
  return lines;
}

}  // namespace dashpad::output
