// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/distortion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/spatial/box_tree.hpp"
#include "lamina/base/error.hpp"
#include "lamina/parameterization/chart_outline.hpp"

namespace lamina {
namespace {

// A triangle is nearly a line if its height is this share of its longest side,
constexpr double kThinness = 1e-6;
// or so little that no machine resolves it [mm], neither by itself nor beside a usual triangle.
constexpr double kNoStretch = 0.02;
constexpr double kNoFlip = 0.005;
constexpr double kUnusual = 0.05;

/// Heights of triangles up to which they count as lines [mm].
struct Limits {
  double no_stretch;
  double no_flip;
};

Limits limitsFor(const Mesh& surface) {
  if (surface.triangles.empty()) return {0.0, 0.0};
  const double mean_area = surfaceArea(surface) / static_cast<double>(surface.triangles.size());
  const double usual = kUnusual * std::sqrt(mean_area);
  return {std::min(kNoStretch, usual), std::min(kNoFlip, usual)};
}

/// A triangle on the surface and in the parameter plane: two sides from one corner, and twice the area.
struct TrianglePair {
  Point3 ab, ac;
  Point2 flat_ab, flat_ac;
  double cross, flat_cross;
};

struct Stretch {
  double least;
  double greatest;
};

TrianglePair pairOf(const Mesh& surface, const std::vector<Point2>& parameterization,
                    const Triangle& corner) {
  TrianglePair pair;
  pair.ab = surface.vertices[corner[1]] - surface.vertices[corner[0]];
  pair.ac = surface.vertices[corner[2]] - surface.vertices[corner[0]];
  pair.flat_ab = parameterization[corner[1]] - parameterization[corner[0]];
  pair.flat_ac = parameterization[corner[2]] - parameterization[corner[0]];
  pair.cross = pair.ab.cross(pair.ac).norm();
  pair.flat_cross = pair.flat_ab.x() * pair.flat_ac.y() - pair.flat_ab.y() * pair.flat_ac.x();
  return pair;
}

std::array<double, 3> sides(const TrianglePair& pair) {
  return {pair.ab.norm(), pair.ac.norm(), (pair.ac - pair.ab).norm()};
}

std::array<double, 3> flatSides(const TrianglePair& pair) {
  return {pair.flat_ab.norm(), pair.flat_ac.norm(), (pair.flat_ac - pair.flat_ab).norm()};
}

bool isThin(const TrianglePair& pair, double limit_mm) {
  const double longest =
      std::sqrt(std::max({pair.ab.squaredNorm(), pair.ac.squaredNorm(), (pair.ac - pair.ab).squaredNorm()}));
  return pair.cross <= std::max(kThinness * longest, limit_mm) * longest;
}

double perimeterIndex(const TrianglePair& pair) {
  const std::array<double, 3> side = sides(pair);
  const std::array<double, 3> flat = flatSides(pair);
  const double perimeter = side[0] + side[1] + side[2];
  return perimeter > 0.0 ? std::abs(1.0 - (flat[0] + flat[1] + flat[2]) / perimeter) : 0.0;
}

/// Of the two longer sides, unless they are as short as the triangle is low.
Stretch stretchOfLine(const TrianglePair& pair, double limit_mm) {
  const std::array<double, 3> side = sides(pair);
  const std::array<double, 3> flat = flatSides(pair);
  const auto shortest = std::min_element(side.begin(), side.end()) - side.begin();
  Stretch stretch{std::numeric_limits<double>::infinity(), 0.0};
  for (std::ptrdiff_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i == shortest || side[at] <= limit_mm) continue;
    stretch.least = std::min(stretch.least, side[at] / flat[at]);
    stretch.greatest = std::max(stretch.greatest, side[at] / flat[at]);
  }
  if (stretch.greatest == 0.0) return {1.0, 1.0};
  return stretch;
}

/// The singular values of the linear map from the parameterization to the surface.
Stretch stretchOf(const TrianglePair& pair) {
  if (pair.flat_cross == 0.0) return {0.0, std::numeric_limits<double>::infinity()};
  const Point3 along_x = (pair.ab * pair.flat_ac.y() - pair.ac * pair.flat_ab.y()) / pair.flat_cross;
  const Point3 along_y = (pair.ac * pair.flat_ab.x() - pair.ab * pair.flat_ac.x()) / pair.flat_cross;
  const double middle = 0.5 * (along_x.squaredNorm() + along_y.squaredNorm());
  const double half = std::hypot(0.5 * (along_x.squaredNorm() - along_y.squaredNorm()), along_x.dot(along_y));
  const double greatest = std::sqrt(middle + half);
  return {pair.cross / std::abs(pair.flat_cross) / greatest, greatest};
}

/// A side of an outline.
struct Segment {
  Point2 start;
  Point2 end;
};

std::vector<Segment> segmentsOf(const std::vector<Polygon>& outlines) {
  std::vector<Segment> segments;
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i)
      segments.push_back({outline[i], outline[(i + 1) % outline.size()]});
  return segments;
}

double side(const Segment& segment, const Point2& point) {
  const Point2 along = segment.end - segment.start;
  const Point2 to = point - segment.start;
  return along.x() * to.y() - along.y() * to.x();
}

double distance(const Segment& segment, const Point2& point) {
  const Point2 along = segment.end - segment.start;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(along.dot(point - segment.start) / squared, 0.0, 1.0) : 0.0;
  return (point - segment.start - share * along).norm();
}

/// Whether two segments cross, all ends being farther than `depth` from the other one.
bool cross(const Segment& a, const Segment& b, double depth) {
  if (side(a, b.start) * side(a, b.end) >= 0.0 || side(b, a.start) * side(b, a.end) >= 0.0) return false;
  return distance(a, b.start) > depth && distance(a, b.end) > depth && distance(b, a.start) > depth &&
         distance(b, a.end) > depth;
}

bool anyCross(const std::vector<Segment>& segments, double depth) {
  std::vector<Box3> boxes(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const Point2& point : {segments[i].start, segments[i].end})
      boxes[i].include({point.x(), point.y(), 0.0});
  const BoxTree tree(std::move(boxes));
  bool is_found = false;
  for (std::uint32_t i = 0; i < segments.size() && !is_found; ++i)
    tree.visitOverlapping(tree.box(i), [&](std::uint32_t j) {
      if (j < i && cross(segments[i], segments[j], depth)) is_found = true;
    });
  return is_found;
}

}  // namespace

Distortion measureDistortion(const Mesh& surface, const std::vector<Point2>& parameterization) {
  if (parameterization.size() != surface.vertices.size())
    throw InvalidInput("the parameterization has " + std::to_string(parameterization.size()) +
                       " places; the surface has " + std::to_string(surface.vertices.size()) + " vertices");
  Distortion distortion;
  if (surface.triangles.empty()) return distortion;
  const Limits limits = limitsFor(surface);
  distortion.least_stretch = std::numeric_limits<double>::infinity();
  distortion.greatest_stretch = 0.0;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const TrianglePair pair = pairOf(surface, parameterization, surface.triangles[t]);
    distortion.index_sum += perimeterIndex(pair);
    if (!(pair.flat_cross > 0.0) && !isThin(pair, limits.no_flip)) ++distortion.flipped;
    const Stretch stretch =
        isThin(pair, limits.no_stretch) ? stretchOfLine(pair, limits.no_stretch) : stretchOf(pair);
    if (stretch.least < distortion.least_stretch) distortion.least_triangle = t;
    if (stretch.greatest > distortion.greatest_stretch) distortion.greatest_triangle = t;
    distortion.least_stretch = std::min(distortion.least_stretch, stretch.least);
    distortion.greatest_stretch = std::max(distortion.greatest_stretch, stretch.greatest);
  }
  distortion.index_mean = distortion.index_sum / static_cast<double>(surface.triangles.size());
  return distortion;
}

bool isInjective(const Mesh& surface, const std::vector<Point2>& parameterization) {
  const std::vector<Polygon> outlines = outlineOf(surface, parameterization);
  const auto outer = std::count_if(outlines.begin(), outlines.end(),
                                   [](const Polygon& one) { return signedArea(one) > 0.0; });
  return outer == 1 && !anyCross(segmentsOf(outlines), limitsFor(surface).no_flip);
}

}  // namespace lamina
