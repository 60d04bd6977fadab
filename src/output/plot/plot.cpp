#include "dashpad/output/plot/plot.hpp"

#include <algorithm>
#include <cctype>

#include "output/plot/check.hpp"
#include "output/plot/svg_plot.hpp"
#include "output/svg/rendered.hpp"

namespace dashpad::output {

std::optional<PictureFormat> picture_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".pdf") return PictureFormat::pdf;
  return std::nullopt;
}

std::string picture(const Plot& plot, PictureFormat format) {
  for (const Panel& panel : plot.panels) check(panel);
  switch (format) {
    case PictureFormat::svg: return svg_plot(plot, PlotStyle::light_and_dark);
    case PictureFormat::png: return png_of(svg_plot(plot, PlotStyle::light));
    case PictureFormat::pdf: return pdf_of(svg_plot(plot, PlotStyle::light), plot.title);
  }
  return {};
}

}  // namespace dashpad::output
