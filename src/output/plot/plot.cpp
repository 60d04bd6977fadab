#include "dashpad/output/plot/plot.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "output/plot/check.hpp"
#include "output/plot/gnuplot_process.hpp"
#include "output/plot/script.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

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
  for (const Panel& panel : plot.panels) check(panel);
  std::string bytes = gnuplot_output(program, plot_script(plot, format));
  return format == PictureFormat::svg ? with_plain_texts(std::move(bytes)) : bytes;
}

}  // namespace dashpad::output
