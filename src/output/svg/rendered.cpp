#include "output/svg/svg.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo.h>
#include <librsvg/rsvg.h>

namespace dashpad::output {

namespace {

struct Release {
  void operator()(GInputStream* stream) const { g_object_unref(stream); }
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <typename Value>
using Owned = std::unique_ptr<Value, Release>;

[[noreturn]] void fail_to_draw(const std::string& words) {
  throw std::runtime_error("could not draw the picture: " + readable(words));
}

[[noreturn]] void fail_to_draw(GError* error) {
  const std::string words = error == nullptr ? "no reason given" : error->message;
  g_clear_error(&error);
  fail_to_draw(words);
}

void check_status(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) fail_to_draw(cairo_status_to_string(status));
}

/// A drawing that knows its size in px.
class Drawing {
 public:
  explicit Drawing(std::string_view svg) {
    const Owned<GInputStream> stream{
        g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr)};
    GError* error = nullptr;
    // A path of many points is longer than the parser takes otherwise.
    handle_.reset(
        rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
    if (!handle_) fail_to_draw(error);
    if (rsvg_handle_get_intrinsic_size_in_pixels(handle_.get(), &width_, &height_) == FALSE)
      fail_to_draw("it has no size");
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  void render(cairo_surface_t* surface, double scale) const {
    const Owned<cairo_t> context{cairo_create(surface)};
    cairo_scale(context.get(), scale, scale);
    const RsvgRectangle whole{0, 0, width_, height_};
    GError* error = nullptr;
    if (rsvg_handle_render_document(handle_.get(), context.get(), &whole, &error) == FALSE)
      fail_to_draw(error);
    check_status(cairo_status(context.get()));
  }

 private:
  Owned<RsvgHandle> handle_;
  double width_ = 0, height_ = 0;
};

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string png_of(std::string_view svg) {
  constexpr double scale = 2;
  const Drawing drawing{svg};
  const Owned<cairo_surface_t> surface{
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(scale * drawing.width())),
                                 static_cast<int>(std::lround(scale * drawing.height())))};
  check_status(cairo_surface_status(surface.get()));
  drawing.render(surface.get(), scale);
  std::string bytes;
  check_status(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

std::string pdf_of(std::string_view svg, const std::string& title) {
  constexpr double points_per_px = 72.0 / 96;
  const Drawing drawing{svg};
  std::string bytes;
  const Owned<cairo_surface_t> surface{cairo_pdf_surface_create_for_stream(
      append, &bytes, points_per_px * drawing.width(), points_per_px * drawing.height())};
  check_status(cairo_surface_status(surface.get()));
  // Without fixed dates cairo writes the time of day, and the same plot would give different files.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_MOD_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, readable(title).c_str());
  drawing.render(surface.get(), points_per_px);
  cairo_surface_finish(surface.get());
  check_status(cairo_surface_status(surface.get()));
  return bytes;
}

}  // namespace dashpad::output
