// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture/cairo_module.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using SurfacePointer = std::unique_ptr<cairo_surface_t, DestroySurface>;

void setColour(cairo_t* context, const Colour& colour) {
  cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.alpha);
}

std::uint32_t packed(const Colour& colour) {
  const auto byte = [](double part) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255.0));
  };
  return byte(colour.alpha) << 24 | byte(colour.red * colour.alpha) << 16 |
         byte(colour.green * colour.alpha) << 8 | byte(colour.blue * colour.alpha);
}

class CairoSurface final : public PixelSurface {
 public:
  CairoSurface(int width, int height)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)),
        context_(cairo_create(surface_.get())) {
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
    setColour(context_.get(), {1.0, 1.0, 1.0});
    cairo_paint(context_.get());
  }

  void line(const std::vector<Point2>& points, const Stroke& stroke) override {
    cairo_t* context = context_.get();
    for (const Point2& point : points) cairo_line_to(context, point.x(), point.y());
    setColour(context, stroke.colour);
    cairo_set_line_width(context, stroke.width_px);
    cairo_set_dash(context, &stroke.dash_px, stroke.dash_px > 0.0 ? 1 : 0, 0.0);
    cairo_stroke(context);
  }

  void area(const std::vector<Point2>& corners, const Colour& colour) override {
    cairo_t* context = context_.get();
    for (const Point2& corner : corners) cairo_line_to(context, corner.x(), corner.y());
    setColour(context, colour);
    cairo_fill(context);
  }

  void rectangle(const Box2& box, const Colour& colour) override {
    cairo_t* context = context_.get();
    cairo_rectangle(context, box.low.x(), box.low.y(), box.size().x(), box.size().y());
    setColour(context, colour);
    cairo_fill(context);
  }

  void dot(const Point2& centre, double radius, const Colour& colour) override {
    cairo_t* context = context_.get();
    cairo_new_sub_path(context);
    cairo_arc(context, centre.x(), centre.y(), radius, 0.0, 2.0 * M_PI);
    setColour(context, colour);
    cairo_fill(context);
  }

  void raster(const Point2& corner, const Point2& cell, const CellColours& cells) override {
    const SurfacePointer image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, cells.columns, cells.rows));
    unsigned char* bytes = cairo_image_surface_get_data(image.get());
    if (bytes == nullptr)
      throw InvalidInput("a raster of " + std::to_string(cells.columns) + " columns is too wide");
    const int stride = cairo_image_surface_get_stride(image.get());
    for (int row = 0; row < cells.rows; ++row) {
      for (int column = 0; column < cells.columns; ++column) {
        const std::uint32_t pixel =
            packed(cells.cells[static_cast<std::size_t>(row) * cells.columns + column]);
        const auto offset = std::ptrdiff_t{stride} * (cells.rows - 1 - row) + std::ptrdiff_t{4} * column;
        std::memcpy(bytes + offset, &pixel, sizeof pixel);
      }
    }
    cairo_surface_mark_dirty(image.get());
    cairo_t* context = context_.get();
    cairo_save(context);
    cairo_translate(context, corner.x(), corner.y());
    cairo_scale(context, cell.x(), cell.y());
    cairo_set_source_surface(context, image.get(), 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
    cairo_paint(context);
    cairo_restore(context);
  }

  void text(const Point2& at, const std::string& text, const TextStyle& style) override {
    cairo_t* context = context_.get();
    const bool is_bold = style.weight == TextWeight::Bold;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size_px);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    const double part = style.anchor == TextAnchor::Left     ? 0.0
                        : style.anchor == TextAnchor::Centre ? 0.5
                                                             : 1.0;
    cairo_move_to(context, at.x() - part * extents.x_advance, at.y());
    setColour(context, style.colour);
    cairo_show_text(context, text.c_str());
    cairo_new_path(context);
  }

  std::vector<std::uint8_t> rgb() const override {
    cairo_surface_flush(surface_.get());
    const unsigned char* const bytes = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    std::vector<std::uint8_t> rgb;
    for (int row = 0; row < cairo_image_surface_get_height(surface_.get()); ++row)
      for (int column = 0; column < cairo_image_surface_get_width(surface_.get()); ++column) {
        std::uint32_t pixel = 0;
        std::memcpy(&pixel, bytes + std::ptrdiff_t{row} * stride + std::ptrdiff_t{4} * column, sizeof pixel);
        for (const unsigned shift : {16U, 8U, 0U})
          rgb.push_back(static_cast<std::uint8_t>(pixel >> shift & 255U));
      }
    return rgb;
  }

  std::string png() const override {
    std::string png;
    const auto write = [](void* closure, const unsigned char* bytes, unsigned int size) {
      static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), size);
      return CAIRO_STATUS_SUCCESS;
    };
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), write, &png);
    if (status != CAIRO_STATUS_SUCCESS)
      throw InvalidInput(std::string("the picture cannot be made a PNG: ") + cairo_status_to_string(status));
    return png;
  }

 private:
  SurfacePointer surface_;
  std::unique_ptr<cairo_t, DestroyContext> context_;
};

std::unique_ptr<PixelSurface> surfaceOf(int width, int height) {
  return std::make_unique<CairoSurface>(width, height);
}

}  // namespace
}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::CairoModule kTable{&lamina::surfaceOf};
  return &kTable;
}
