#include "output/drawing/drawing_words.hpp"

#include <cstddef>
#include <type_traits>

#include <fmt/format.h>

#include "output/drawing/elements.hpp"
#include "output/drawing/support_picture.hpp"
#include "output/text/capitals.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

std::string nose_words(const Nose& nose, const UnitSystem& units) {
  const auto shown = [&](double length) { return unbroken(brief_quantity(length, "m", units, 3)); };
  return std::visit(
      [&]<class Shape>(const Shape& shape) -> std::string {
        if constexpr (std::is_same_v<Shape, Sphere>)
          return fmt::format("sphere, {} across", shown(2 * shape.radius));
        else if constexpr (std::is_same_v<Shape, FlatDisc>)
          return fmt::format("flat disc, {} across", shown(2 * shape.radius));
        else if constexpr (std::is_same_v<Shape, Cone>)
          return fmt::format("cone, half angle {}, base {} across",
                             brief_quantity(shape.half_angle, "rad", units, 3), shown(2 * shape.radius));
        else if constexpr (std::is_same_v<Shape, Ellipsoid>)
          return fmt::format("ellipsoid, {} across as drawn, {} across the other way",
                             shown(2 * shape.half_length), shown(2 * shape.half_width));
        else if constexpr (std::is_same_v<Shape, Rod>)
          return fmt::format("rod, {} across, its dome of radius {}", shown(2 * shape.radius),
                             shown(shape.tip_radius));
        else if constexpr (std::is_same_v<Shape, Platen>)
          return fmt::format("platen, {} long as drawn, {} wide", shown(shape.length), shown(shape.width));
        else if constexpr (std::is_same_v<Shape, Cylinder>)
          return fmt::format("cylinder on its side, {} across, {} long", shown(2 * shape.radius),
                             shown(shape.length));
        else
          return fmt::format("shape through {} points, {} across", shape.points.size(),
                             shown(2 * shape.sections().radius(shape.sections().depth)));
      },
      nose);
}

std::string alarm_words(const DrawnMoments& moments) {
  if (moments.bottomed) return "Bottomed out";
  if (moments.struck_through) return "Struck through";
  std::string numbers;
  bool several = false;
  for (std::size_t i = 0; i < moments.layers.size(); ++i) {
    if (!moments.layers[i].struck_through) continue;
    several = !numbers.empty();
    numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", i + 1);
  }
  if (numbers.empty()) return "";
  return several ? "Struck through: layers " + numbers : "Struck through: layer " + numbers;
}

std::string strain_words(const DrawnMoments& moments) {
  if (moments.layers.size() == 1) return fmt::format("Strain on the axis {:.2f}", moments.layers[0].strain);
  if (moments.layers.size() > 3) {
    std::size_t most = 0;
    for (std::size_t i = 1; i < moments.layers.size(); ++i)
      if (moments.layers[i].strain > moments.layers[most].strain) most = i;
    return fmt::format("Strain up to {:.2f}, layer {}", moments.layers[most].strain, most + 1);
  }
  std::string text = moments.layers.size() == 2 ? "Strain in layers 1 and 2:" : "Strain in layers 1 to 3:";
  for (std::size_t i = 0; i < moments.layers.size(); ++i)
    text += fmt::format("{}{:.2f}", i == 0 ? " " : ", ", moments.layers[i].strain);
  return text;
}

std::string drawing_title(const ImpactCase& impact) {
  if (!impact.title.empty()) return one_line(impact.title);
  return capitalised(with_article(words_of(impact.impactor.nose))) + " on a pad";
}

std::string drawing_description(const ImpactCase& impact, const DrawnMoments& moments, const Layout& layout,
                                const UnitSystem& units) {
  const auto length = [&](double value) { return brief_quantity(value, "m", units, 3); };
  std::string text =
      fmt::format("Left: first contact. {} of {} meets a pad of {} at {}.",
                  capitalised(with_article(words_of(impact.impactor.nose))),
                  brief_quantity(impact.impactor.mass, "kg", units, 3), length(moments.thickness),
                  brief_quantity(impact.impactor.speed, "m/s", units, 3));
  if (moments.layers.size() > 1) text += fmt::format(" The pad has {} layers.", moments.layers.size());
  text +=
      fmt::format(" Support: {}. Right: {}, {}; {} of the pad is left on the axis.",
                  support_words(impact, units), moments.is_so_far ? "deepest so far" : "greatest penetration",
                  length(moments.penetration), length(moments.left()));
  if (moments.deflection > 0) text += fmt::format(" The support deflects by {}.", length(moments.deflection));
  if (moments.body_motion > 0)
    text += fmt::format(" The body behind it moved {}.", length(moments.body_motion));
  if (const std::string alarm = alarm_words(moments); !alarm.empty()) text += " " + alarm + ".";
  text += " " + strain_words(moments) + "; columns of the pad are shaded by their strain.";
  text += " Nose and pad are true to scale; parts of the support";
  text += impact.pad.sheet > 0 ? " and the sheet on the pad are symbols." : " are symbols.";
  if (layout.pad_is_cut) text += " A stretch of the pad is left out.";
  if (layout.sink_is_cut) text += " The way of the support is drawn shorter than it is.";
  return text;
}

}  // namespace dashpad::output
