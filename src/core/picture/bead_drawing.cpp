// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture/bead_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/angle.hpp"
#include "toolpath/bead_space.hpp"

namespace lamina {
namespace {

constexpr double kAzimuth = toRadians(-32.0);
constexpr double kElevation = toRadians(30.0);
constexpr double kDarkest = 0.58;
constexpr int kShades = 100;
constexpr double kLeastStep = 0.6;  // px: finer detail cannot be seen

struct Coat {
  double width;  ///< part of the bead's
  double shade;
};
constexpr Coat kCoats[] = {{1.0, 0.68}, {0.84, 1.0}, {0.35, 1.16}};

/// Gathers the points of strokes that share colour and width.
class StrokePen {
 public:
  explicit StrokePen(Canvas& canvas) : canvas_(canvas) {}
  ~StrokePen() { flush(); }

  /// Continues to `to`; starts a new stroke at `from` if the look differs from the one before.
  void draw(const Point2& from, const Point2& to, const Stroke& stroke) {
    if (points_.empty() || stroke.width_px != stroke_.width_px || stroke.colour.red != stroke_.colour.red) {
      flush();
      points_.push_back(from);
      stroke_ = stroke;
    }
    points_.push_back(to);
  }

 private:
  void flush() {
    if (!points_.empty()) canvas_.linePx(points_, stroke_);
    points_.clear();
  }

  Canvas& canvas_;
  Stroke stroke_;
  std::vector<Point2> points_;
};

void drawDrops(Canvas& canvas, const Projection& projection, const Path& path, const Colour& colour) {
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const double width_px = std::max(1.2, projection.seenHeight(path.bead.at(i)) * canvas.pixelsPerMm());
    canvas.dot(projection(path.points[i]), 0.5 * width_px, shaded(colour, 0.9));
  }
}

/// As wide as they are, each coat narrower than the one below.
void drawFlatDrops(Canvas& canvas, const Path& path, const Colour& colour) {
  for (const Coat& coat : kCoats)
    for (std::size_t i = 0; i < path.points.size(); ++i)
      canvas.dot(path.points[i].head<2>(),
                 std::max(0.25, 0.5 * coat.width * path.bead.at(i).width_mm * canvas.pixelsPerMm()),
                 shaded(colour, coat.shade));
}

}  // namespace

Projection::Projection(PictureView view) : elevation_(view == PictureView::Top ? M_PI / 2 : kElevation) {
  const double azimuth = view == PictureView::Top ? 0.0 : kAzimuth;
  right_ = Point3(std::cos(azimuth), std::sin(azimuth), 0.0);
  into_ = Point3(-std::sin(azimuth), std::cos(azimuth), 0.0);
  plane_from_part_.row(0) = right_;
  plane_from_part_.row(1) = std::sin(elevation_) * into_ + std::cos(elevation_) * Point3::UnitZ();
}

Point3 Projection::towardsViewer() const {
  return std::sin(elevation_) * Point3::UnitZ() - std::cos(elevation_) * into_;
}

double Projection::seenHeight(const Bead& bead) const {
  return bead.width_mm * std::sin(elevation_) + bead.height_mm * std::cos(elevation_);
}

double Projection::light(const Point3& direction) const {
  const Point2 level = direction.head<2>();
  if (level.isZero()) return 1.0;
  Point3 side(-level.y(), level.x(), 0.0);
  side.normalize();
  if (side.dot(into_) > 0.0) side = -side;
  const Point3 to_light = (-0.6 * right_ - 0.8 * into_).normalized();
  const double shade = kDarkest + (1.0 - kDarkest) * std::max(0.0, side.dot(to_light));
  return std::round(shade * kShades) / kShades;
}

double Projection::lightOn(const Point3& normal) const {
  const Point3 to_light = (-0.35 * right_ - 0.45 * into_ + 0.8 * Point3::UnitZ()).normalized();
  return kDarkest + (1.0 - kDarkest) * std::max(0.0, normal.dot(to_light));
}

void drawBeads(Canvas& canvas, const Projection& projection, const Path& path, const Colour& colour) {
  if (path.deposit == Deposit::Drops) return drawDrops(canvas, projection, path, colour);
  // Of a wall its side is seen, of a fill its top, which is lit the same in every direction.
  const bool shows_side = kindOf(path.role) == RoleKind::Wall;
  StrokePen pen(canvas);
  Point3 start = path.firstPoint();
  Point2 from = canvas.toPixels(projection(start));
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const Point2 to = canvas.toPixels(projection(path.points[end]));
    if ((to - from).norm() < kLeastStep && m + 1 < path.motionCount()) continue;
    const double width_px = std::max(1.2, projection.seenHeight(path.bead.at(end)) * canvas.pixelsPerMm());
    const double light = shows_side ? projection.light(path.points[end] - start) : 0.9;
    pen.draw(from, to, {shaded(colour, light), width_px});
    start = path.points[end];
    from = to;
  }
}

void drawBead(Canvas& canvas, const Projection& projection, const BeadPiece& piece, const Colour& colour) {
  const Bead& bead = piece.path.bead.at(piece.waypoint);
  const double width_px = std::max(1.2, projection.seenHeight(bead) * canvas.pixelsPerMm());
  const Point3 upper_side = upAt(piece.path, piece.waypoint);
  canvas.linePx({canvas.toPixels(projection(piece.from)), canvas.toPixels(projection(piece.to))},
                {shaded(colour, projection.lightOn(upper_side)), width_px});
}

void drawFlatBeads(Canvas& canvas, const Path& path, const Colour& colour) {
  if (path.deposit == Deposit::Drops) return drawFlatDrops(canvas, path, colour);
  for (const Coat& coat : kCoats) {
    StrokePen pen(canvas);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const double width_px = std::max(0.5, coat.width * path.bead.at(end).width_mm * canvas.pixelsPerMm());
      pen.draw(canvas.toPixels(path.points[m].head<2>()), canvas.toPixels(path.points[end].head<2>()),
               {shaded(colour, coat.shade), width_px});
    }
  }
}

}  // namespace lamina
