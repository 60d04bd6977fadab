#include "dashpad/report/plot.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "report/gnuplot_process.hpp"
#include "report/plot_rows.hpp"
#include "report/plot_script.hpp"
#include "report/plot_text.hpp"

namespace dashpad {

namespace {

void check(const Series& series) {
  const auto rows = [&]() -> std::size_t {
    if (series.style == SeriesStyle::vertical_line) return series.x.size();
    return series.y.size();
  }();
  const bool needs_x = series.style != SeriesStyle::horizontal_line;
  const bool needs_y2 = series.style == SeriesStyle::band;
  if ((needs_x && series.x.size() != rows) || (needs_y2 && series.y2.size() != rows))
    throw std::invalid_argument(
        fmt::format("the columns of the series \"{}\" differ in length", readable(series.label)));
}

void check(const Axis& axis) {
  const auto name = readable(axis.label);
  for (const auto& limit : {axis.low, axis.high}) {
    if (limit && !is_drawable(*limit, axis))
      throw std::invalid_argument(fmt::format("the axis \"{}\" cannot end at {}", name, *limit));
  }
  if (axis.low && axis.high && !(*axis.low < *axis.high))
    throw std::invalid_argument(fmt::format("the axis \"{}\" ends at {}, not above its beginning at {}", name,
                                            *axis.high, *axis.low));
}

void replace_all(std::string& text, std::string_view old, std::string_view fresh) {
  for (auto place = text.find(old); place != std::string::npos; place = text.find(old, place + fresh.size()))
    text.replace(place, old.size(), fresh);
}

/// gnuplot 5.4 leaves these two of a text as they are, though in XML they stand for something else. It writes
/// neither by itself.
std::string with_plain_texts(std::string svg) {
  replace_all(svg, "]]>", "]]&gt;");
  replace_all(svg, "&#x", "&amp;#x");
  return svg;
}

}  // namespace

std::optional<PictureFormat> picture_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".pdf") return PictureFormat::pdf;
  return std::nullopt;
}

std::string picture(const Plot& plot, PictureFormat format, const std::string& program) {
  for (const Panel& panel : plot.panels) {
    check(panel.x);
    check(panel.y);
    for (const Series& series : panel.series) check(series);
  }
  std::string bytes = gnuplot_output(program, plot_script(plot, format));
  return format == PictureFormat::svg ? with_plain_texts(std::move(bytes)) : bytes;
}

}  // namespace dashpad
