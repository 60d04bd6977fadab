#include "output/page/html_elements.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "output/plot/axis_ticks.hpp"
#include "output/plot/drawing.hpp"
#include "output/plot/svg_plot.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

bool has_something_to_draw(const Plot& plot) {
  return std::ranges::any_of(plot.panels, [](const Panel& panel) {
    return std::ranges::any_of(panel.series, [&](const Series& series) {
      // Lines across mark places among data.
      return !is_marker(series.style) && !drawable_runs(series, panel.x, panel.y).empty();
    });
  });
}

/// Calls `use(element, begin, end)` for each text, with the place of what is written between its tags.
template <typename Use>
void for_texts(const std::string& svg, const Use& use) {
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::string_view element = std::string_view{svg}.substr(at + 1);
    for (const std::string_view name : {"title", "desc", "text"}) {
      if (!element.starts_with(name)) continue;
      const std::size_t begin = svg.find('>', at) + 1;
      use(name, begin, svg.find('<', begin));
    }
  }
}

/// The SVG without its texts and without the name that depends on them.
std::string geometry_of(const std::string& svg) {
  std::string geometry;
  std::size_t done = 0;
  for_texts(svg, [&](std::string_view, std::size_t begin, std::size_t end) {
    geometry.append(svg, done, begin - done);
    done = end;
  });
  geometry.append(svg, done);
  constexpr std::string_view id = "id=\"", name_of_all = "dd-00000000";
  const std::size_t name = svg.find(id);
  if (name != std::string::npos)
    replace_all(geometry, svg.substr(name + id.size(), name_of_all.size()), std::string{name_of_all});
  return geometry;
}

/// The text between the first `opening` and the next `closing`; empty if either is missing.
std::string_view between(std::string_view text, std::string_view opening, std::string_view closing) {
  const std::size_t begin = text.find(opening);
  if (begin == std::string_view::npos) return {};
  text.remove_prefix(begin + opening.size());
  const std::size_t end = text.find(closing);
  return end == std::string_view::npos ? std::string_view{} : text.substr(0, end);
}

}  // namespace

std::vector<std::string> texts_in(const std::string& svg) {
  std::vector<std::string> texts;
  for_texts(svg, [&](std::string_view name, std::size_t begin, std::size_t end) {
    if (name != "title") texts.push_back(svg.substr(begin, end - begin));
  });
  return texts;
}

bool differ_in_texts_only(const std::string& one, const std::string& other) {
  return geometry_of(one) == geometry_of(other);
}

std::string InlineSvgs::add(std::string svg) {
  constexpr std::string_view opening = "<style>", closing = "</style>";
  if (const std::size_t begin = svg.find("<svg"); begin != std::string::npos) svg.erase(0, begin);
  const std::size_t begin = svg.find(opening);
  const std::size_t end = begin == std::string::npos ? begin : svg.find(closing, begin);
  if (end == std::string::npos) return svg;
  styles_.insert(svg.substr(begin + opening.size(), end - begin - opening.size()));
  return svg.erase(begin, end + closing.size() - begin);
}

std::string InlineSvgs::add(const Plot& plot, double width) {
  if (!has_something_to_draw(plot)) return "<p>There is nothing to draw.</p>\n";
  styles_.emplace(style_sheet(PlotStyle::light_and_dark));
  return add(svg_plot(plot, PlotStyle::none, width));
}

std::string InlineSvgs::add_with_halves(std::string svg) {
  svg = add(std::move(svg));
  const std::string_view name = between(svg, "<g id=\"", "-left-half\"");
  if (name.empty()) return svg;
  std::string halves;
  for (const std::string_view half : {"left-half", "right-half"}) {
    const std::string_view group = between(svg, fmt::format("<g id=\"{}-{}\"", name, half), ">");
    halves +=
        fmt::format("<svg class=\"half\" viewBox=\"{}\" aria-hidden=\"true\"><use href=\"#{}-{}\"/></svg>\n",
                    between(group, "data-view=\"", "\""), name, half);
  }
  return svg + halves;
}

}  // namespace dashpad::output
