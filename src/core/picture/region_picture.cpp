// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/region_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/picture/annotation.hpp"

namespace lamina {
namespace {

constexpr int kRegionWidth = 1400;
constexpr int kRegionHeight = 800;
constexpr double kRegionMargin = 40.0;        // px
constexpr double kRegionFooterHeight = 72.0;  // px
constexpr double kLineHeight = 22.0;          // px
constexpr std::size_t kLineLength = 150;
constexpr double kShineThrough = 0.22;
constexpr Colour kPart{0.72, 0.74, 0.78};
constexpr Colour kRegion{0.85, 0.10, 0.10};

/// Looks along a direction, without perspective.
struct View {
  Point3 right;
  Point3 up;
  Point3 towards_viewer;

  Point2 seen(const Point3& point) const { return {right.dot(point), up.dot(point)}; }
};

View viewFrom(double heading_rad, double elevation_rad) {
  const Point3 towards(std::cos(elevation_rad) * std::cos(heading_rad),
                       std::cos(elevation_rad) * std::sin(heading_rad), std::sin(elevation_rad));
  const Point3 right = Point3::UnitZ().cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

/// What is seen in each pixel of a view: of all faces turned to the viewer the nearest.
class DepthPicture {
 public:
  DepthPicture(const View& view, const Box2& world, double pixels_per_mm)
      : view_(view),
        world_(world),
        scale_(pixels_per_mm),
        columns_(std::max(1, static_cast<int>(std::ceil(world.size().x() * scale_)))),
        rows_(std::max(1, static_cast<int>(std::ceil(world.size().y() * scale_)))),
        pixels_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void addPart(const Mesh& mesh) { addFaces(mesh, kPart, 0.0, false); }
  /// Shines through what hides it.
  /// @param nearer  how far it is held to lie before the part's own face in the same place [mm]
  void addRegion(const Mesh& mesh, double nearer) { addFaces(mesh, kRegion, nearer, true); }

  CellColours raster() const {
    CellColours raster{columns_, rows_, {}};
    raster.cells.reserve(pixels_.size());
    for (const Pixel& pixel : pixels_) raster.cells.push_back(colourOf(pixel));
    return raster;
  }

 private:
  struct Pixel {
    double depth = -std::numeric_limits<double>::infinity();
    Colour colour{1.0, 1.0, 1.0};
    bool is_region = false;
    bool has_region = false;
  };

  static Colour colourOf(const Pixel& pixel) {
    if (pixel.is_region || !pixel.has_region) return pixel.colour;
    const double kept = 1.0 - kShineThrough;
    return {kept * pixel.colour.red + kShineThrough * kRegion.red,
            kept * pixel.colour.green + kShineThrough * kRegion.green,
            kept * pixel.colour.blue + kShineThrough * kRegion.blue};
  }

  void addFaces(const Mesh& mesh, const Colour& colour, double nearer, bool is_region) {
    for (const Triangle& corner : mesh.triangles) {
      const Point3& a = mesh.vertices[corner[0]];
      const Point3& b = mesh.vertices[corner[1]];
      const Point3& c = mesh.vertices[corner[2]];
      const Point3 normal = (b - a).cross(c - a).normalized();
      const double facing = normal.dot(view_.towards_viewer);
      if (!(facing > 0.0)) continue;
      const double light = 0.55 + 0.25 * facing + 0.20 * std::max(0.0, normal.dot(view_.up));
      Pixel pixel;
      pixel.colour = {colour.red * light, colour.green * light, colour.blue * light};
      pixel.is_region = is_region;
      fill({inPixels(a, nearer), inPixels(b, nearer), inPixels(c, nearer)}, pixel);
    }
  }

  /// Column, row and depth.
  Point3 inPixels(const Point3& point, double nearer) const {
    const Point2 seen = scale_ * (view_.seen(point) - world_.low);
    return {seen.x(), seen.y(), view_.towards_viewer.dot(point) + nearer};
  }

  /// Turned to the viewer, the corners run counter-clockwise.
  void fill(const std::array<Point3, 3>& corner, const Pixel& face) {
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

  void put(int row, int column, double depth, const Pixel& face) {
    Pixel& pixel = pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                           static_cast<std::size_t>(column)];
    pixel.has_region = pixel.has_region || face.is_region;
    if (depth <= pixel.depth) return;
    pixel.depth = depth;
    pixel.colour = face.colour;
    pixel.is_region = face.is_region;
  }

  const View& view_;
  Box2 world_;
  double scale_;
  int columns_;
  int rows_;
  std::vector<Pixel> pixels_;
};

void drawView(Canvas& canvas, const RegionPicture& picture, const View& view, const Box2& area) {
  Box2 seen;
  for (const Mesh* mesh : {&picture.part, &picture.region})
    for (const Point3& vertex : mesh->vertices) seen.include(view.seen(vertex));
  canvas.show(seen, area);
  DepthPicture pixels(view, seen, canvas.pixelsPerMm());
  pixels.addPart(picture.part);
  pixels.addRegion(picture.region, 1e-3 * boundingBox(picture.part).size().norm());
  canvas.raster(seen, pixels.raster());
}

}  // namespace

void drawRegion(const RegionPicture& picture, const std::string& png_path) {
  if (picture.part.triangles.empty() && picture.region.triangles.empty())
    throw InvalidInput("part and region have 0 triangles to draw; expected at least one");
  Canvas canvas(kRegionWidth, kRegionHeight);
  const std::vector<std::string> lines = brokenInto(kLineLength, picture.reason);
  const double top = 62.0 + kLineHeight * static_cast<double>(lines.size());
  const double middle = 0.5 * kRegionWidth;
  drawView(canvas, picture, viewFrom(-M_PI / 4.0, M_PI / 6.0),
           {{kRegionMargin, top}, {middle - 10.0, kRegionHeight - kRegionFooterHeight}});
  drawView(canvas, picture, viewFrom(-3.0 * M_PI / 4.0, -M_PI / 6.0),
           {{middle + 10.0, top}, {kRegionWidth - kRegionMargin, kRegionHeight - kRegionFooterHeight}});
  drawTitle(canvas, picture.title, listed(lines, "\n"));
  drawScaleBar(canvas, {kRegionMargin, kRegionHeight - 30.0});
  drawLegend(canvas, {kRegionMargin + 270.0, kRegionHeight - 26.0}, {{"in the way", kRegion}});
  canvas.writePng(png_path);
}

}  // namespace lamina
