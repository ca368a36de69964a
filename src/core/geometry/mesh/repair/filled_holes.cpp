// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/mesh/border_loops.hpp"
#include "geometry/mesh/repair/steps.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

/// A closed line of corners that a hole's new triangles shall span.
struct Hole {
  std::vector<std::uint32_t> corners;  ///< each once, counter-clockwise seen from outside the solid
  std::vector<Point3>
      normals;  ///< of the triangle across the edge from corner i to i + 1; 0 if it has no area
};

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

/// Triangulates a closed line of at least three corners by cutting off ears that are convex and empty in the
/// line's mean plane; where there is none because the line winds, the smallest corner is cut. Time grows with
/// the corners times the reflex ones among them.
std::vector<Triangle> clipEars(const std::vector<std::uint32_t>& corners,
                               const std::vector<Point3>& vertices) {
  return EarClipper(corners, vertices).clip();
}

/// How bad a triangulation is: by its sharpest fold, 0 flat to 2 folded back, then by its area.
struct Cost {
  double fold = 0.0;
  double area = 0.0;

  bool operator<(const Cost& other) const {
    // Folds are distinguished no finer than rounding leaves them.
    constexpr double kSame = 1e-9;
    if (fold < other.fold - kSame) return true;
    if (fold > other.fold + kSame) return false;
    return area < other.area;
  }
};

constexpr Cost kWorst = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// The best triangulation of the corners from one to another, for all pairs, the nearest first.
class LeastFolds {
 public:
  LeastFolds(const Hole& hole, const std::vector<Point3>& vertices)
      : hole_(hole),
        count_(hole.corners.size()),
        best_(count_ * count_),
        split_(count_ * count_, 0),
        normals_(count_ * count_) {
    for (const std::uint32_t corner : hole.corners) points_.push_back(vertices[corner]);
    for (std::size_t i = 0; i + 1 < count_; ++i) normals_[i * count_ + i + 1] = hole.normals[i];
  }

  std::vector<Triangle> triangles() {
    for (std::size_t length = 2; length < count_; ++length)
      for (std::size_t i = 0; i + length < count_; ++i) choose(i, i + length);
    std::vector<Triangle> triangles;
    collect(0, count_ - 1, triangles);
    return triangles;
  }

 private:
  Point3 crossOf(std::size_t i, std::size_t k, std::size_t j) const {
    return (points_[k] - points_[i]).cross(points_[j] - points_[i]);
  }

  static double foldBetween(const Point3& a, const Point3& b) { return 1.0 - a.dot(b); }

  Cost costOf(std::size_t i, std::size_t k, std::size_t j) const {
    const Point3 cross = crossOf(i, k, j);
    const Point3 normal = cross.normalized();
    const Cost& left = best_[i * count_ + k];
    const Cost& right = best_[k * count_ + j];
    double fold = std::max(left.fold, right.fold);
    fold = std::max(fold, foldBetween(normal, normals_[i * count_ + k]));
    fold = std::max(fold, foldBetween(normal, normals_[k * count_ + j]));
    if (i == 0 && j + 1 == count_) fold = std::max(fold, foldBetween(normal, hole_.normals[j]));
    return {fold, left.area + right.area + 0.5 * cross.norm()};
  }

  void choose(std::size_t i, std::size_t j) {
    Cost& best = best_[i * count_ + j];
    best = kWorst;
    for (std::size_t k = i + 1; k < j; ++k) {
      const Cost cost = costOf(i, k, j);
      if (!(cost < best)) continue;
      best = cost;
      split_[i * count_ + j] = k;
    }
    normals_[i * count_ + j] = crossOf(i, split_[i * count_ + j], j).normalized();
  }

  void collect(std::size_t i, std::size_t j, std::vector<Triangle>& triangles) const {
    if (j < i + 2) return;
    const std::size_t k = split_[i * count_ + j];
    triangles.push_back({hole_.corners[i], hole_.corners[k], hole_.corners[j]});
    collect(i, k, triangles);
    collect(k, j, triangles);
  }

  const Hole& hole_;
  std::size_t count_;
  std::vector<Point3> points_;
  std::vector<Cost> best_;
  std::vector<std::size_t> split_;
  std::vector<Point3> normals_;  // across the line from i to j: of the triangle chosen there, or of the mesh
};

/// Triangles between the corners, two fewer than there are: always so that each edge of the line gets exactly
/// one. Small holes get the triangulation whose sharpest fold is least and then whose area is ([Liepa2003],
/// cubic in the corners); large ones are clipped ear by ear in their mean plane.
std::vector<Triangle> triangulate(const Hole& hole, const std::vector<Point3>& vertices) {
  // Beyond this the cubic time would be felt (some 10 ms).
  constexpr std::size_t kMostCorners = 120;
  if (hole.corners.size() > kMostCorners) return clipEars(hole.corners, vertices);
  return LeastFolds(hole, vertices).triangles();
}

/// Cuts a loop at vertices that it passes more than once into loops that pass each vertex once. There and
/// back between two vertices needs no filling and is left out.
std::vector<std::vector<HalfEdge>> simpleLoops(const Mesh& mesh, const std::vector<HalfEdge>& loop) {
  std::vector<std::uint32_t> origins;
  origins.reserve(loop.size());
  for (const HalfEdge h : loop) origins.push_back(originOf(mesh, h));
  std::vector<std::uint32_t> sorted = origins;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  constexpr std::size_t kAbsent = 0xFFFFFFFF;
  std::vector<std::size_t> place(sorted.size(), kAbsent);  // on the path, per vertex
  std::vector<std::vector<HalfEdge>> loops;
  std::vector<HalfEdge> path;
  const auto place_of = [&](std::uint32_t v) -> std::size_t& {
    return place[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) -
                                          sorted.begin())];
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    place_of(origins[i]) = path.size();
    path.push_back(loop[i]);
    const std::size_t start = place_of(origins[(i + 1) % loop.size()]);
    if (start == kAbsent) continue;
    if (path.size() - start > 2)
      loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(start), path.end());
    for (std::size_t k = start; k < path.size(); ++k) place_of(originOf(mesh, path[k])) = kAbsent;
    path.resize(start);
  }
  return loops;
}

/// The hole on the other side of a border: its corners in reverse order.
Hole holeOf(const Mesh& mesh, const std::vector<HalfEdge>& loop) {
  Hole hole;
  for (auto h = loop.rbegin(); h != loop.rend(); ++h) {
    const Triangle& t = mesh.triangles[triangleOf(*h)];
    const Point3& a = mesh.vertices[t[0]];
    hole.corners.push_back(originOf(mesh, nextInTriangle(*h)));
    hole.normals.push_back((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized());
  }
  return hole;
}

Point3 middleOfCorners(const Mesh& mesh, const Hole& hole) {
  Point3 sum = Point3::Zero();
  for (const std::uint32_t corner : hole.corners) sum += mesh.vertices[corner];
  return sum / static_cast<double>(hole.corners.size());
}

}  // namespace

RepairStep fillHoles(Mesh mesh, const MeshTopology& topology) {
  // So many are reported one by one; a mesh full of cracks would fill pages.
  constexpr std::size_t kMostNamed = 20;
  std::vector<RepairChange> changes;
  for (const auto& loop : findBorderLoops(topology)) {
    for (const auto& simple : simpleLoops(mesh, loop)) {
      const Hole hole = holeOf(mesh, simple);
      const std::vector<Triangle> filling = triangulate(hole, mesh.vertices);
      mesh.triangles.insert(mesh.triangles.end(), filling.begin(), filling.end());
      if (changes.size() < kMostNamed) {
        changes.push_back({"edges around a hole closed", simple.size(), middleOfCorners(mesh, hole)});
      } else {
        if (changes.size() == kMostNamed)
          changes.push_back({"further holes closed", 0, middleOfCorners(mesh, hole)});
        ++changes.back().count;
      }
    }
  }
  return {std::move(mesh), std::move(changes)};
}

}  // namespace lamina
