// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture/depth_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/picture/colour.hpp"

namespace lamina {
namespace {

constexpr double kShineThrough = 0.22;
constexpr double kGlassTint = 0.2;
constexpr Colour kPartColour{0.72, 0.74, 0.78};
constexpr Colour kRegionColour{0.85, 0.10, 0.10};

Colour tinted(const Colour& own, const Colour& tint, double share) {
  const double kept = 1.0 - share;
  return {kept * own.red + share * tint.red, kept * own.green + share * tint.green,
          kept * own.blue + share * tint.blue};
}

}  // namespace

View viewFrom(double heading_rad, double elevation_rad) {
  const Point3 towards(std::cos(elevation_rad) * std::cos(heading_rad),
                       std::cos(elevation_rad) * std::sin(heading_rad), std::sin(elevation_rad));
  const Point3 right = Point3::UnitZ().cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

Colour regionColour() { return kRegionColour; }

DepthPicture::DepthPicture(const View& view, const Box2& world, double pixels_per_mm)
    : view_(view),
      world_(world),
      scale_(pixels_per_mm),
      columns_(std::max(1, static_cast<int>(std::ceil(world.size().x() * scale_)))),
      rows_(std::max(1, static_cast<int>(std::ceil(world.size().y() * scale_)))),
      pixels_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void DepthPicture::addPart(const Mesh& mesh) { addSolid(mesh, kPartColour); }

void DepthPicture::addSolid(const Mesh& mesh, const Colour& colour) {
  Pixel pixel;
  pixel.colour = colour;
  addFaces(mesh, 0.0, pixel);
}

void DepthPicture::addGlass(const Mesh& mesh, const Colour& colour) {
  glass_.resize(pixels_.size());
  Pixel pixel;
  pixel.colour = colour;
  pixel.is_glass = true;
  addFaces(mesh, 0.0, pixel);
}

void DepthPicture::addRegion(const Mesh& mesh, double nearer) {
  Pixel pixel;
  pixel.colour = kRegionColour;
  pixel.is_region = true;
  addFaces(mesh, nearer, pixel);
}

void DepthPicture::paintPart(const std::function<Colour(const Point3&)>& colour_at) {
  NoProgress nobody;
  const auto columns = static_cast<std::size_t>(columns_);
  const auto paintRow = [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      Pixel& pixel = pixels_[row * columns + column];
      if (pixel.is_region || !std::isfinite(pixel.depth)) continue;
      const Point2 seen =
          world_.low + Point2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5) / scale_;
      pixel.colour =
          colour_at(seen.x() * view_.right + seen.y() * view_.up + pixel.depth * view_.towards_viewer);
    }
  };
  parallelFor(static_cast<std::size_t>(rows_), paintRow, nobody, "picture");
}

CellColours DepthPicture::raster() const {
  CellColours raster{columns_, rows_, {}};
  raster.cells.reserve(pixels_.size());
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) raster.cells.push_back(colourAt(pixel));
  return raster;
}

Colour DepthPicture::colourOf(const Pixel& pixel) {
  const Colour own = shaded(pixel.colour, pixel.light);
  return pixel.is_region || !pixel.has_region ? own : tinted(own, kRegionColour, kShineThrough);
}

Colour DepthPicture::colourAt(std::size_t pixel) const {
  const Colour own = colourOf(pixels_[pixel]);
  if (glass_.empty() || glass_[pixel].depth <= pixels_[pixel].depth) return own;
  return tinted(own, shaded(glass_[pixel].colour, glass_[pixel].light), kGlassTint);
}

void DepthPicture::addFaces(const Mesh& mesh, double nearer, Pixel pixel) {
  for (const Triangle& corner : mesh.triangles) {
    const Point3& a = mesh.vertices[corner[0]];
    const Point3& b = mesh.vertices[corner[1]];
    const Point3& c = mesh.vertices[corner[2]];
    const Point3 normal = (b - a).cross(c - a).normalized();
    const double facing = normal.dot(view_.towards_viewer);
    if (!(facing > 0.0)) continue;
    pixel.light = 0.55 + 0.25 * facing + 0.20 * std::max(0.0, normal.dot(view_.up));
    fill({inPixels(a, nearer), inPixels(b, nearer), inPixels(c, nearer)}, pixel);
  }
}

/// Column, row and depth.
Point3 DepthPicture::inPixels(const Point3& point, double nearer) const {
  const Point2 seen = scale_ * (view_.seen(point) - world_.low);
  return {seen.x(), seen.y(), view_.towards_viewer.dot(point) + nearer};
}

/// Turned to the viewer, the corners run counter-clockwise.
void DepthPicture::fill(const std::array<Point3, 3>& corner, const Pixel& face) {
  const auto doubled = [](const Point3& a, const Point3& b, double x, double y) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  const double whole = doubled(corner[0], corner[1], corner[2].x(), corner[2].y());
  if (!(whole > 0.0)) return;
  Box3 box;
  for (const Point3& each : corner) box.include(each);
  const int last_row = std::min(rows_ - 1, static_cast<int>(std::floor(box.high.y() - 0.5)));
  const int last_column = std::min(columns_ - 1, static_cast<int>(std::floor(box.high.x() - 0.5)));
  for (int row = std::max(0, static_cast<int>(std::ceil(box.low.y() - 0.5))); row <= last_row; ++row)
    for (int column = std::max(0, static_cast<int>(std::ceil(box.low.x() - 0.5))); column <= last_column;
         ++column) {
      const double x = column + 0.5;
      const double y = row + 0.5;
      const double wa = doubled(corner[1], corner[2], x, y) / whole;
      const double wb = doubled(corner[2], corner[0], x, y) / whole;
      const double wc = 1.0 - wa - wb;
      if (wa < 0.0 || wb < 0.0 || wc < 0.0) continue;
      put(row, column, wa * corner[0].z() + wb * corner[1].z() + wc * corner[2].z(), face);
    }
}

void DepthPicture::put(int row, int column, double depth, const Pixel& face) {
  Pixel& pixel =
      (face.is_glass ? glass_ : pixels_)[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                         static_cast<std::size_t>(column)];
  pixel.has_region = pixel.has_region || face.is_region;
  if (depth <= pixel.depth) return;
  const bool has_region = pixel.has_region;
  pixel = face;
  pixel.depth = depth;
  pixel.has_region = has_region;
}

}  // namespace lamina
