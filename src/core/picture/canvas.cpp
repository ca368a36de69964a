// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/canvas.hpp"

#include <algorithm>

#include "base/module.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "picture/cairo_module.hpp"

namespace lamina {
namespace {

constexpr int kSmallest = 16;
constexpr int kLargest = 16384;

std::unique_ptr<PixelSurface> whiteSurface(int width, int height) {
  if (std::min(width, height) < kSmallest || std::max(width, height) > kLargest)
    throw InvalidInput("picture of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; each side must be within 16 and 16384");
  return static_cast<const CairoModule*>(moduleTable("cairo"))->surface(width, height);
}

}  // namespace

Canvas::Canvas(int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px), surface_(whiteSurface(width_px, height_px)) {}

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
  surface_->line(points, stroke);
}

void Canvas::area(const std::vector<Point2>& corners, const Colour& colour) {
  std::vector<Point2> pixels;
  pixels.reserve(corners.size());
  for (const Point2& corner : corners) pixels.push_back(toPixels(corner));
  surface_->area(pixels, colour);
}

void Canvas::rectanglePx(const Box2& box, const Colour& colour) { surface_->rectangle(box, colour); }

void Canvas::dot(const Point2& centre, double radius_px, const Colour& colour) {
  dotPx(toPixels(centre), radius_px, colour);
}

void Canvas::dotPx(const Point2& centre, double radius_px, const Colour& colour) {
  surface_->dot(centre, radius_px, colour);
}

void Canvas::raster(const Box2& extent, const CellColours& cells) {
  if (cells.columns <= 0 || cells.rows <= 0) return;
  const Point2 cell = (pixels_per_mm_ * extent.size()).cwiseQuotient(Point2(cells.columns, cells.rows));
  surface_->raster(toPixels({extent.low.x(), extent.high.y()}), cell, cells);
}

void Canvas::text(const Point2& at, const std::string& text, const TextStyle& style) {
  surface_->text(at, text, style);
}

PixelImage Canvas::pixels() const { return {width_px_, height_px_, surface_->rgb()}; }

std::string Canvas::png() const { return surface_->png(); }

void Canvas::writePng(const std::string& path) const { writeFile(path, png()); }

}  // namespace lamina
