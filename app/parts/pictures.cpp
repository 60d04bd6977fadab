// PNG and PDF of pictures: a part that is loaded when it is used.

#include "output/svg/svg.hpp"
#include "parts/parts.hpp"

extern "C" const dashpad::app::PicturePart* dashpad_part() {
  static constexpr dashpad::app::PicturePart part{dashpad::output::png_of, dashpad::output::pdf_of};
  return &part;
}
