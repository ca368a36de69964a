// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/picture/canvas.hpp"

namespace lamina {

/// A parallel projection along a viewing direction.
struct View {
  Point3 right;
  Point3 up;
  Point3 towards_viewer;

  Point2 seen(const Point3& point) const { return {right.dot(point), up.dot(point)}; }
};

View viewFrom(double heading_rad, double elevation_rad);

/// Colour of a region that a picture points out.
Colour regionColour();

/// A picture by depth buffer: each pixel shows the nearest of the faces turned to the viewer.
class DepthPicture {
 public:
  DepthPicture(const View& view, const Box2& world, double pixels_per_mm);

  void addPart(const Mesh& mesh);
  /// Adds a mesh in a colour of its own.
  void addSolid(const Mesh& mesh, const Colour& colour);
  /// Tints what it would hide. Of several such faces over each other, the nearest does.
  void addGlass(const Mesh& mesh, const Colour& colour);
  /// Adds a region of the part's surface, which shines through what hides it.
  /// @param nearer  distance by which the region counts as nearer to the viewer than the part's face at the
  ///   same place [mm]
  void addRegion(const Mesh& mesh, double nearer);
  /// Colours the part by the position of each visible point. `colour_at` may be called from any thread.
  void paintPart(const std::function<Colour(const Point3&)>& colour_at);

  CellColours raster() const;

 private:
  struct Pixel {
    double depth = -std::numeric_limits<double>::infinity();
    Colour colour{1.0, 1.0, 1.0};
    double light = 1.0;
    bool is_region = false;
    bool has_region = false;
    bool is_glass = false;  ///< of a face; glass is kept apart from what is seen through it
  };

  static Colour colourOf(const Pixel& pixel);
  Colour colourAt(std::size_t pixel) const;
  void addFaces(const Mesh& mesh, double nearer, Pixel pixel);
  Point3 inPixels(const Point3& point, double nearer) const;
  void fill(const std::array<Point3, 3>& corner, const Pixel& face);
  void put(int row, int column, double depth, const Pixel& face);

  View view_;
  Box2 world_;
  double scale_;
  int columns_;
  int rows_;
  std::vector<Pixel> pixels_;
  std::vector<Pixel> glass_;  ///< the nearest glass of each pixel; empty without any
};

}  // namespace lamina
