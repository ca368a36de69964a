// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/picture/canvas.hpp"
#include "lamina/picture/toolpath_picture.hpp"

namespace lamina {

/// A parallel projection of the part along a viewing direction.
class Projection {
 public:
  explicit Projection(PictureView view);

  /// Projects a point to the plane of the picture [mm].
  Point2 operator()(const Point3& point) const { return plane_from_part_ * point; }
  Point3 towardsViewer() const;
  /// Height of a bead as seen in the picture [mm].
  double seenHeight(const Bead& bead) const;
  /// Brightness of the side of a bead that runs in this direction, about 0.6 to 1.
  double light(const Point3& direction) const;
  /// Brightness of a surface with this normal, about 0.6 to 1.
  double lightOn(const Point3& normal) const;

 private:
  Eigen::Matrix<double, 2, 3> plane_from_part_;
  Point3 right_;
  Point3 into_;  ///< horizontal, away from the viewer
  double elevation_;
};

/// Draws the visible sides of a path's beads or drops, lit from the left.
void drawBeads(Canvas& canvas, const Projection& projection, const Path& path, const Colour& colour);

/// A piece of a path's bead, or a drop.
struct BeadPiece {
  const Path& path;
  std::size_t waypoint = 0;  ///< waypoint at which it ends
  Point3 from = Point3::Zero();
  Point3 to = Point3::Zero();
};

/// Draws a piece, lit as its upper side, towards the nozzle, is.
void drawBead(Canvas& canvas, const Projection& projection, const BeadPiece& piece, const Colour& colour);

/// Draws a path's beads or drops at their width from above, each with a darker edge.
void drawFlatBeads(Canvas& canvas, const Path& path, const Colour& colour);

}  // namespace lamina
