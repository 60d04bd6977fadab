#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "dashpad/output/impact.hpp"
#include "output/drawing/pictures.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string whole_drawing(const Scene& scene) {
  const Layout& layout = scene.layout;
  constexpr double line_distance = 19.5;  // px
  std::string captions;
  double y = layout.bottom + 25;
  for (const std::string& line : caption_lines(scene)) {
    captions += text_element("dd-text", {scene.left.axis - layout.half_width, y}, "start", line);
    y += line_distance;
  }
  const double height = std::max(y + 1, layout.bottom + strain_legend_height + 12);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"dd-drawing\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" "
      "role=\"img\" aria-labelledby=\"{2}-title {2}-description\" data-scale=\"{3}\">\n"
      "<title id=\"{2}-title\">{4}</title>\n<desc id=\"{2}-description\">{5}</desc>\n"
      "<style>{6}</style>\n",
      px(drawing_width), px(height), own_name, layout.scale, xml_text(drawing_title(scene.impact)),
      xml_text(drawing_description(scene)), impact_drawing_style());
  text += "<defs>\n" + hatchings(scene.moments) + picture_clip(scene, scene.left) +
          picture_clip(scene, scene.right) + "</defs>\n";
  text += rectangle_element("dd-paper", 0, 0, drawing_width, height);
  // The two groups let a narrow page show the halves one below the other.
  const auto group = [&](const char* name, double from, double to, const std::string& inside) {
    return fmt::format("<g id=\"{}-{}\" class=\"dd-drawing\" data-view=\"{} 0 {} {}\">\n{}</g>\n", own_name,
                       name, px(from), px(to - from), px(height), inside);
  };
  text += group("left-half", 0, layout.left_end,
                picture_of(scene, scene.left) + names_on_pad(scene) + text_above_left(scene) +
                    dimensions_left(scene) + captions);
  text += group("right-half", layout.right_begin, drawing_width,
                picture_of(scene, scene.right) + text_above_right(scene) + dimensions_right(scene) +
                    strain_legend(scene.moments, {scene.right.axis - layout.half_width, layout.bottom + 14},
                                  2 * layout.half_width));
  return text + "</svg>\n";
}

/// A name that depends on the drawing alone (FNV-1a, 32 bits): ids of two drawings in a page differ.
std::string name_from(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char character : text) hash = (hash ^ static_cast<unsigned char>(character)) * 16777619U;
  return fmt::format("dd-{:08x}", hash);
}

std::string no_drawing(const ImpactCase& impact) {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"dd-drawing\" width=\"{0}\" height=\"60\" "
             "viewBox=\"0 0 {0} 60\" "
             "role=\"img\">\n<title>{1}</title>\n<desc>No drawing: the case breaks a rule.</desc>\n"
             "<style>{2}</style>\n",
             px(drawing_width), xml_text(impact.title), impact_drawing_style()) +
         rectangle_element("dd-paper", 0, 0, drawing_width, 60) +
         text_element("dd-text", {drawing_width / 2, 34}, "middle", "No drawing: the case is invalid.") +
         "</svg>\n";
}

}  // namespace

std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units) {
  if (!violations(impact).empty()) return no_drawing(impact);
  std::string text = whole_drawing(Scene(impact, solution, units));
  replace_all(text, own_name, name_from(text));
  return text;
}

std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units,
                           PictureFormat format) {
  std::string svg = impact_drawing(impact, solution, units);
  if (format == PictureFormat::svg) return svg;
  // The rules for dark paper are the last.
  const std::size_t dark = svg.find("@media"), end = svg.find("</style>");
  if (dark < end) svg.erase(dark, end - dark);
  return format == PictureFormat::png ? png_of(svg) : pdf_of(svg, drawing_title(impact));
}

}  // namespace dashpad::output
