// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/unfolding.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"

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
        plan_(fans.vertices(), Point2::Zero()),
        is_deposited_(fans.vertices(), 0) {
    const Triangle& seed = surface.triangles[middleTriangle(surface)];
    const Point3 along = surface.vertices[seed[1]] - surface.vertices[seed[0]];
    plan_[seed[1]] = {along.norm(), 0.0};
    is_deposited_[seed[0]] = is_deposited_[seed[1]] = 1;
    for (std::uint32_t i = fans.first[seed[2]]; i < fans.first[seed[2] + 1]; ++i)
      if (fans.corners[i].next == seed[0] && fans.corners[i].previous == seed[1])
        plan_[seed[2]] = placeBeyond(fans.corners[i]);
    is_deposited_[seed[2]] = 1;
    const Point2 middle = (plan_[seed[0]] + plan_[seed[1]] + plan_[seed[2]]) / 3.0;
    for (const std::uint32_t vertex : seed) plan_[vertex] -= middle;
    for (const std::uint32_t vertex : seed) reachFrom(vertex);
  }

  std::optional<std::vector<Point2>> run() && {
    while (!front_.empty()) {
      const std::uint32_t vertex = front_.front().vertex;
      std::pop_heap(front_.begin(), front_.end());
      front_.pop_back();
      if (is_deposited_[vertex]) continue;
      plan_[vertex] = middleOfPlaces(vertex);
      is_deposited_[vertex] = 1;
      if (!isTrueAround(vertex)) return std::nullopt;
      reachFrom(vertex);
    }
    const auto left = std::find(is_deposited_.begin(), is_deposited_.end(), 0);
    if (left != is_deposited_.end())
      throw InvalidMesh("no way over the surface leads to vertex " +
                        std::to_string(left - is_deposited_.begin()) + "; expected one connected piece");
    return std::move(plan_);
  }

 private:
  struct Reached {
    double squared;  // of the distance from the middle
    std::uint32_t vertex;
    bool operator<(const Reached& other) const {  // the nearest is taken first
      return squared != other.squared ? squared > other.squared : vertex > other.vertex;
    }
  };

  /// Whether the sides to vertices that are deposited have kept their length.
  bool isTrueAround(std::uint32_t vertex) const {
    const auto isTrue = [&](std::uint32_t other, double length) {
      return !is_deposited_[other] ||
             std::abs((plan_[other] - plan_[vertex]).norm() - length) <= tolerance_ * length;
    };
    for (std::uint32_t i = fans_.first[vertex]; i < fans_.first[vertex + 1]; ++i)
      if (!isTrue(fans_.corners[i].next, fans_.corners[i].to_next) ||
          !isTrue(fans_.corners[i].previous, fans_.corners[i].to_previous))
        return false;
    return true;
  }

  /// Where a corner lies of which both other vertices are deposited: at its height above the side between
  /// them, which rounding errors of that side's length do not change, so that they do not grow from row to
  /// row.
  Point2 placeBeyond(const FanCorner& corner) const {
    const Point2 side = plan_[corner.previous] - plan_[corner.next];
    const double flat_length = side.norm();
    const double squared =
        corner.to_next * corner.to_next + corner.to_previous * corner.to_previous - 2.0 * corner.dot;
    if (!(squared > 0.0) || !(flat_length > 0.0)) return plan_[corner.next];
    const double share = (corner.to_next * corner.to_next - corner.dot) / squared;
    const double height = corner.cross / std::sqrt(squared);
    return plan_[corner.next] + share * side + height / flat_length * Point2(-side.y(), side.x());
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

  /// Puts those vertices on the front that a triangle joins to the one just deposited and another one.
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
  std::vector<Point2> plan_;
  std::vector<char> is_deposited_;
  std::vector<Reached> front_;
};

}  // namespace

std::optional<std::vector<Point2>> unfold(const Mesh& surface, const TriangleFans& fans, double tolerance) {
  if (surface.triangles.empty()) return std::nullopt;
  return Unfolding(surface, fans, tolerance).run();
}

}  // namespace lamina
