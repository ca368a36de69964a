// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/canvas.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr int kSmallest = 16;
constexpr int kLargest = 16384;

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

}  // namespace

struct Canvas::Surface {
  SurfacePointer surface;
  std::unique_ptr<cairo_t, DestroyContext> context;
  cairo_t* get() const { return context.get(); }
};

Canvas::Canvas(int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px), surface_(std::make_unique<Surface>()) {
  if (std::min(width_px, height_px) < kSmallest || std::max(width_px, height_px) > kLargest)
    throw InvalidInput("picture of " + std::to_string(width_px) + " x " + std::to_string(height_px) +
                       " pixels; each side must be within 16 and 16384");
  surface_->surface.reset(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width_px, height_px));
  surface_->context.reset(cairo_create(surface_->surface.get()));
  cairo_t* context = surface_->get();
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  setColour(context, {1.0, 1.0, 1.0});
  cairo_paint(context);
}

Canvas::~Canvas() = default;

void Canvas::show(const Box2& world, const Box2& area) {
  Box2 shown = world;
  if (shown.isEmpty() || shown.size().maxCoeff() <= 0.0) {
    const Point2 centre = shown.isEmpty() ? Point2(Point2::Zero()) : shown.centre();
    shown.low = centre - Point2(0.5, 0.5);
    shown.high = centre + Point2(0.5, 0.5);
  }
  const Point2 size = shown.size().cwiseMax(1e-9);
  pixels_per_mm_ = area.size().cwiseQuotient(size).minCoeff();
  origin_px_ = area.centre() - pixels_per_mm_ * Point2(shown.centre().x(), -shown.centre().y());
}

Point2 Canvas::toPixels(const Point2& point) const {
  return origin_px_ + pixels_per_mm_ * Point2(point.x(), -point.y());
}

void Canvas::line(const std::vector<Point2>& points, const Stroke& stroke) {
  std::vector<Point2> pixels;
  pixels.reserve(points.size());
  for (const Point2& point : points) pixels.push_back(toPixels(point));
  linePx(pixels, stroke);
}

void Canvas::linePx(const std::vector<Point2>& points, const Stroke& stroke) {
  cairo_t* context = surface_->get();
  for (const Point2& point : points) cairo_line_to(context, point.x(), point.y());
  setColour(context, stroke.colour);
  cairo_set_line_width(context, stroke.width_px);
  cairo_set_dash(context, &stroke.dash_px, stroke.dash_px > 0.0 ? 1 : 0, 0.0);
  cairo_stroke(context);
}

void Canvas::area(const std::vector<Point2>& corners, const Colour& colour) {
  cairo_t* context = surface_->get();
  for (const Point2& corner : corners) {
    const Point2 pixel = toPixels(corner);
    cairo_line_to(context, pixel.x(), pixel.y());
  }
  setColour(context, colour);
  cairo_fill(context);
}

void Canvas::rectanglePx(const Box2& box, const Colour& colour) {
  cairo_t* context = surface_->get();
  cairo_rectangle(context, box.low.x(), box.low.y(), box.size().x(), box.size().y());
  setColour(context, colour);
  cairo_fill(context);
}

void Canvas::dot(const Point2& centre, double radius_px, const Colour& colour) {
  dotPx(toPixels(centre), radius_px, colour);
}

void Canvas::dotPx(const Point2& centre, double radius_px, const Colour& colour) {
  cairo_t* context = surface_->get();
  cairo_new_sub_path(context);
  cairo_arc(context, centre.x(), centre.y(), radius_px, 0.0, 2.0 * M_PI);
  setColour(context, colour);
  cairo_fill(context);
}

void Canvas::raster(const Box2& extent, const CellColours& cells) {
  if (cells.columns <= 0 || cells.rows <= 0) return;
  const SurfacePointer image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, cells.columns, cells.rows));
  unsigned char* bytes = cairo_image_surface_get_data(image.get());
  if (bytes == nullptr)
    throw InvalidInput("a raster of " + std::to_string(cells.columns) + " columns is too wide");
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const std::uint32_t pixel = packed(cells.cells[static_cast<std::size_t>(row) * cells.columns + column]);
      const auto offset = std::ptrdiff_t{stride} * (cells.rows - 1 - row) + std::ptrdiff_t{4} * column;
      std::memcpy(bytes + offset, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(image.get());
  cairo_t* context = surface_->get();
  const Point2 corner = toPixels({extent.low.x(), extent.high.y()});
  cairo_save(context);
  cairo_translate(context, corner.x(), corner.y());
  cairo_scale(context, extent.size().x() * pixels_per_mm_ / cells.columns,
              extent.size().y() * pixels_per_mm_ / cells.rows);
  cairo_set_source_surface(context, image.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
  cairo_paint(context);
  cairo_restore(context);
}

void Canvas::text(const Point2& at, const std::string& text, const TextStyle& style) {
  cairo_t* context = surface_->get();
  const bool is_bold = style.weight == TextWeight::Bold;
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size_px);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  const double part = style.anchor == TextAnchor::Left ? 0.0 : style.anchor == TextAnchor::Centre ? 0.5 : 1.0;
  cairo_move_to(context, at.x() - part * extents.x_advance, at.y());
  setColour(context, style.colour);
  cairo_show_text(context, text.c_str());
  cairo_new_path(context);
}

std::string Canvas::png() const {
  std::string png;
  const auto write = [](void* closure, const unsigned char* bytes, unsigned int size) {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_->surface.get(), write, &png);
  if (status != CAIRO_STATUS_SUCCESS)
    throw InvalidInput(std::string("the picture cannot be made a PNG: ") + cairo_status_to_string(status));
  return png;
}

void Canvas::writePng(const std::string& path) const { writeFile(path, png()); }

}  // namespace lamina
