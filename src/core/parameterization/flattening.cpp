// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/flattening.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arap.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/triangle_fans.hpp"
#include "lamina/parameterization/distortion.hpp"
#include "landmark_mds.hpp"
#include "smacof.hpp"

namespace lamina {
namespace {

/// The triangle with area whose middle is nearest to that of the surface.
std::size_t middleTriangle(const Mesh& surface) {
  Point3 moment = Point3::Zero();
  double area = 0.0;
  std::vector<Point3> middles;
  std::vector<double> areas;
  middles.reserve(surface.triangles.size());
  areas.reserve(surface.triangles.size());
  for (const Triangle& corner : surface.triangles) {
    const Point3& a = surface.vertices[corner[0]];
    const Point3& b = surface.vertices[corner[1]];
    const Point3& c = surface.vertices[corner[2]];
    middles.emplace_back((a + b + c) / 3.0);
    areas.push_back((b - a).cross(c - a).norm());
    moment += areas.back() * middles.back();
    area += areas.back();
  }
  const Point3 middle = area > 0.0 ? Point3(moment / area) : middles.front();
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < middles.size(); ++t) {
    const double squared = (middles[t] - middle).squaredNorm();
    if (!(areas[t] > 0.0) || !(squared < least)) continue;
    nearest = t;
    least = squared;
  }
  return nearest;
}

class Unfolding {
 public:
  Unfolding(const Mesh& surface, const TriangleFans& fans, double tolerance)
      : fans_(fans),
        tolerance_(tolerance),
        parameterization_(fans.vertices(), Point2::Zero()),
        is_deposited_(fans.vertices(), 0) {
    const Triangle& seed = surface.triangles[middleTriangle(surface)];
    const Point3 along = surface.vertices[seed[1]] - surface.vertices[seed[0]];
    parameterization_[seed[1]] = {along.norm(), 0.0};
    is_deposited_[seed[0]] = is_deposited_[seed[1]] = 1;
    for (std::uint32_t i = fans.first[seed[2]]; i < fans.first[seed[2] + 1]; ++i)
      if (fans.corners[i].next == seed[0] && fans.corners[i].previous == seed[1])
        parameterization_[seed[2]] = placeBeyond(fans.corners[i]);
    is_deposited_[seed[2]] = 1;
    const Point2 middle =
        (parameterization_[seed[0]] + parameterization_[seed[1]] + parameterization_[seed[2]]) / 3.0;
    for (const std::uint32_t vertex : seed) parameterization_[vertex] -= middle;
    for (const std::uint32_t vertex : seed) reachFrom(vertex);
  }

  std::optional<std::vector<Point2>> run() && {
    while (!front_.empty()) {
      const std::uint32_t vertex = front_.front().vertex;
      std::pop_heap(front_.begin(), front_.end());
      front_.pop_back();
      if (is_deposited_[vertex]) continue;
      parameterization_[vertex] = middleOfPlaces(vertex);
      is_deposited_[vertex] = 1;
      if (!isTrueAround(vertex)) return std::nullopt;
      reachFrom(vertex);
    }
    const auto left = std::find(is_deposited_.begin(), is_deposited_.end(), 0);
    if (left != is_deposited_.end())
      throw InvalidMesh("no way over the surface leads to vertex " +
                        std::to_string(left - is_deposited_.begin()) + "; expected one connected piece");
    return std::move(parameterization_);
  }

 private:
  struct Reached {
    double squared;  // of the distance from the middle
    std::uint32_t vertex;
    bool operator<(const Reached& other) const {  // the nearest is taken first
      return squared != other.squared ? squared > other.squared : vertex > other.vertex;
    }
  };

  /// Whether the sides to vertices that are placed already have kept their length.
  bool isTrueAround(std::uint32_t vertex) const {
    const auto isTrue = [&](std::uint32_t other, double length) {
      return !is_deposited_[other] || std::abs((parameterization_[other] - parameterization_[vertex]).norm() -
                                               length) <= tolerance_ * length;
    };
    for (std::uint32_t i = fans_.first[vertex]; i < fans_.first[vertex + 1]; ++i)
      if (!isTrue(fans_.corners[i].next, fans_.corners[i].to_next) ||
          !isTrue(fans_.corners[i].previous, fans_.corners[i].to_previous))
        return false;
    return true;
  }

  /// Where a corner lies whose two other vertices are placed: at its height above the side between
  /// them, which rounding errors of that side's length do not change, so that they do not grow from row to
  /// row.
  Point2 placeBeyond(const FanCorner& corner) const {
    const Point2 side = parameterization_[corner.previous] - parameterization_[corner.next];
    const double flat_length = side.norm();
    const double squared =
        corner.to_next * corner.to_next + corner.to_previous * corner.to_previous - 2.0 * corner.dot;
    if (!(squared > 0.0) || !(flat_length > 0.0)) return parameterization_[corner.next];
    const double share = (corner.to_next * corner.to_next - corner.dot) / squared;
    const double height = corner.cross / std::sqrt(squared);
    return parameterization_[corner.next] + share * side + height / flat_length * Point2(-side.y(), side.x());
  }

  Point2 middleOfPlaces(std::uint32_t vertex) const {
    Point2 sum = Point2::Zero();
    double weight = 0.0;
    for (std::uint32_t i = fans_.first[vertex]; i < fans_.first[vertex + 1]; ++i) {
      const FanCorner& corner = fans_.corners[i];
      if (!is_deposited_[corner.next] || !is_deposited_[corner.previous]) continue;
      const double one = corner.cross + std::numeric_limits<double>::min();
      sum += one * placeBeyond(corner);
      weight += one;
    }
    return sum / weight;
  }

  /// Puts those vertices on the front that a triangle joins to the one just placed and another one.
  void reachFrom(std::uint32_t vertex) {
    for (std::uint32_t i = fans_.first[vertex]; i < fans_.first[vertex + 1]; ++i) {
      const FanCorner& corner = fans_.corners[i];
      if (is_deposited_[corner.next] == is_deposited_[corner.previous]) continue;
      const std::uint32_t next = is_deposited_[corner.next] ? corner.previous : corner.next;
      front_.push_back({middleOfPlaces(next).squaredNorm(), next});
      std::push_heap(front_.begin(), front_.end());
    }
  }

  const TriangleFans& fans_;
  double tolerance_;
  std::vector<Point2> parameterization_;
  std::vector<char> is_deposited_;
  std::vector<Reached> front_;
};

/// The parameterization of a surface that unrolls, by laying triangle on triangle from the middle outwards;
/// where several reach a vertex, it comes to lie between the places they give it. Nothing if the surface
/// turns out not to unroll, because two neighbours come to lie nearer or farther than they are by more than
/// the tolerance. May overlap itself, and may tear apart triangles that the way around a hole joins
/// (`measureDistortion` reports).
///
/// @param surface    connected by edges; its fans
/// @param tolerance  as a share of each length
/// @throws InvalidMesh if a vertex hangs together with the others by no triangle
std::optional<std::vector<Point2>> unfold(const Mesh& surface, const TriangleFans& fans, double tolerance) {
  if (surface.triangles.empty()) return std::nullopt;
  return Unfolding(surface, fans, tolerance).run();
}

// Surfaces that keep their lengths to this share when they are unrolled need no better parameterization.
constexpr double kUnrollsFlat = 0.005;
// A surface that faces its mean direction so much (cosine of the angle) is projected for a guess.
constexpr double kFacing = 0.5;
// Up to so many vertices the exact parameterization takes no time.
constexpr std::size_t kFewVertices = 1000;

/// Geodesic distances do not distinguish a surface from its mirror image.
void turnCounterClockwise(const Mesh& surface, std::vector<Point2>& parameterization) {
  double area = 0.0;
  for (const Triangle& corner : surface.triangles) {
    const Point2 ab = parameterization[corner[1]] - parameterization[corner[0]];
    const Point2 ac = parameterization[corner[2]] - parameterization[corner[0]];
    area += ab.x() * ac.y() - ab.y() * ac.x();
  }
  if (area >= 0.0) return;
  for (Point2& place : parameterization) place.x() = -place.x();
}

bool isWithin(const Distortion& distortion, double tolerance) {
  return distortion.flipped == 0 && distortion.least_stretch >= 1.0 - tolerance &&
         distortion.greatest_stretch <= 1.0 + tolerance;
}

/// Whether a better parameterization may be within the tolerance where the coarse one is not. It mends single
/// triangles that are too small, mostly at borders.
bool isNearly(const Distortion& distortion, double tolerance) {
  return distortion.flipped == 0 && distortion.least_stretch >= 1.0 - 1.1 * tolerance &&
         distortion.greatest_stretch <= 1.0 + 2.0 * tolerance;
}

/// Unit vector: the mean direction in which the surface faces, and the least cosine to it.
struct Facing {
  Point3 direction = Point3::Zero();
  double least = -1.0;
};

Facing facingOf(const Mesh& surface) {
  std::vector<Point3> area;
  area.reserve(surface.triangles.size());
  Point3 sum = Point3::Zero();
  for (const Triangle& corner : surface.triangles) {
    const Point3& a = surface.vertices[corner[0]];
    area.emplace_back((surface.vertices[corner[1]] - a).cross(surface.vertices[corner[2]] - a));
    sum += area.back();
  }
  Facing facing;
  if (!(sum.norm() > 0.0)) return facing;
  facing.direction = sum.normalized();
  facing.least = 1.0;
  for (const Point3& one : area)
    if (const double norm = one.norm(); norm > 0.0)
      facing.least = std::min(facing.least, one.dot(facing.direction) / norm);
  return facing;
}

std::vector<Point2> project(const Mesh& surface, const Point3& direction) {
  const Point3 x = direction.unitOrthogonal();
  const Point3 y = direction.cross(x);
  std::vector<Point2> parameterization;
  parameterization.reserve(surface.vertices.size());
  for (const Point3& vertex : surface.vertices) parameterization.emplace_back(vertex.dot(x), vertex.dot(y));
  return parameterization;
}

/// Keeps the direction of each vertex from the middle one, and puts it as far away as it is over the surface.
std::vector<Point2> spread(std::vector<Point2> parameterization, const GeodesicDistances& geodesics) {
  Box2 box;
  for (const Point2& place : parameterization) box.include(place);
  const auto middle = std::min_element(
      parameterization.begin(), parameterization.end(), [&](const Point2& a, const Point2& b) {
        return (a - box.centre()).squaredNorm() < (b - box.centre()).squaredNorm();
      });
  const Point2 centre = *middle;
  const std::vector<double> distance =
      geodesics.from(static_cast<std::uint32_t>(middle - parameterization.begin()));
  for (std::size_t i = 0; i < parameterization.size(); ++i) {
    const Point2 away = parameterization[i] - centre;
    if (const double norm = away.norm(); norm > 0.0)
      parameterization[i] = distance[i] / norm * away;
    else
      parameterization[i] = Point2::Zero();
  }
  return parameterization;
}

std::vector<Point2> scaleDistances(const Mesh& surface, TriangleFans fans,
                                   const FlatteningSettings& settings) {
  const GeodesicDistances geodesics(std::move(fans));
  const Landmarks landmarks =
      spreadLandmarks(geodesics, surface.vertices.size(), static_cast<std::size_t>(settings.landmarks));
  std::vector<Point2> parameterization = landmarkMds(landmarks);
  turnCounterClockwise(surface, parameterization);
  if (settings.method != FlatteningMethod::Stress) return parameterization;
  return lessenStress(std::move(parameterization), geodesics.fans(), landmarks);
}

std::vector<Point2> guessOf(const Mesh& surface, TriangleFans fans, const FlatteningSettings& settings) {
  const Facing facing = facingOf(surface);
  if (facing.least >= kFacing) return project(surface, facing.direction);
  if (facing.least > 0.0)
    return spread(project(surface, facing.direction), GeodesicDistances(std::move(fans)));
  return scaleDistances(surface, std::move(fans), settings);
}

std::vector<Point2> flattenArap(const Mesh& surface, const FlatteningSettings& settings) {
  TriangleFans fans = gatherFans(surface);
  if (auto parameterization = unfold(surface, fans, kUnrollsFlat))
    if (isWithin(measureDistortion(surface, *parameterization), kUnrollsFlat))
      return std::move(*parameterization);
  std::vector<Point2> guess = guessOf(surface, std::move(fans), settings);
  const ArapEnergy energy(surface);
  if (surface.vertices.size() <= kFewVertices) return relaxArap(energy, std::move(guess));
  std::vector<Point2> parameterization = relaxCoarsely(energy, std::move(guess));
  const Distortion distortion = measureDistortion(surface, parameterization);
  if (isWithin(distortion, settings.tolerance) || !isNearly(distortion, settings.tolerance))
    return parameterization;
  return relaxArap(energy, std::move(parameterization));
}

}  // namespace

std::vector<Point2> flatten(const Mesh& surface, const FlatteningSettings& settings) {
  if (surface.vertices.empty()) return {};
  if (settings.method == FlatteningMethod::Arap) return flattenArap(surface, settings);
  return scaleDistances(surface, gatherFans(surface), settings);
}

}  // namespace lamina
