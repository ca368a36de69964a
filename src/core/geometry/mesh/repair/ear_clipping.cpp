// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/mesh/repair/ear_clipping.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

double turnOf(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The line seen along its area vector, from where it runs counter-clockwise.
Polygon projected(const std::vector<std::uint32_t>& corners, const std::vector<Point3>& vertices) {
  const Point3& origin = vertices[corners.front()];
  Point3 area = Point3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += (vertices[corners[i]] - origin).cross(vertices[corners[i + 1]] - origin);
  const Point3 normal = area.norm() > 0.0 ? Point3(area.normalized()) : Point3(Point3::UnitZ());
  const Point3 x_axis = normal.unitOrthogonal();
  const Point3 y_axis = normal.cross(x_axis);
  Polygon polygon;
  for (const std::uint32_t corner : corners)
    polygon.emplace_back(x_axis.dot(vertices[corner] - origin), y_axis.dot(vertices[corner] - origin));
  return polygon;
}

class EarClipper {
 public:
  EarClipper(const std::vector<std::uint32_t>& corners, const std::vector<Point3>& vertices)
      : corners_(corners), points_(projected(corners, vertices)), left_(corners.size()) {
    for (std::size_t i = 0; i < left_; ++i) {
      next_.push_back((i + 1) % left_);
      previous_.push_back((i + left_ - 1) % left_);
    }
    for (std::size_t i = 0; i < left_; ++i)
      if (turnAt(i) <= 0.0) reflex_.push_back(i);
  }

  std::vector<Triangle> clip() {
    std::size_t i = 0;
    for (std::size_t tried = 0; left_ > 3;) {
      if (tried >= left_) {
        i = smallestFrom(i);
      } else if (!isEar(i)) {
        i = next_[i];
        ++tried;
        continue;
      }
      // Going on after the next corner keeps the triangles from fanning about one.
      const std::size_t after = next_[next_[i]];
      cut(i);
      i = after;
      tried = 0;
    }
    triangles_.push_back({corners_[previous_[i]], corners_[i], corners_[next_[i]]});
    return std::move(triangles_);
  }

 private:
  double turnAt(std::size_t i) const { return turnOf(points_[previous_[i]], points_[i], points_[next_[i]]); }

  bool isEar(std::size_t i) const {
    if (turnAt(i) <= 0.0) return false;
    const Point2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t r) {
      if (r == previous_[i] || r == i || r == next_[i]) return false;
      const Point2& p = points_[r];
      return turnOf(a, b, p) >= 0.0 && turnOf(b, c, p) >= 0.0 && turnOf(c, a, p) >= 0.0;
    });
  }

  std::size_t smallestFrom(std::size_t start) const {
    std::size_t smallest = start;
    double least = std::numeric_limits<double>::infinity();
    std::size_t i = start;
    for (std::size_t k = 0; k < left_; ++k, i = next_[i]) {
      const double size = std::abs(turnAt(i));
      if (size < least) least = size, smallest = i;
    }
    return smallest;
  }

  void cut(std::size_t i) {
    triangles_.push_back({corners_[previous_[i]], corners_[i], corners_[next_[i]]});
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    --left_;
    const auto is_done = [&](std::size_t r) {
      const bool is_neighbour = r == previous_[i] || r == next_[i];
      return r == i || (is_neighbour && turnAt(r) > 0.0);
    };
    reflex_.erase(std::remove_if(reflex_.begin(), reflex_.end(), is_done), reflex_.end());
  }

  const std::vector<std::uint32_t>& corners_;
  Polygon points_;
  std::size_t left_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::vector<std::size_t> reflex_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> clipEars(const std::vector<std::uint32_t>& corners,
                               const std::vector<Point3>& vertices) {
  return EarClipper(corners, vertices).clip();
}

}  // namespace lamina
