// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/mesh/repair/hole_triangulation.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "geometry/mesh/repair/ear_clipping.hpp"

namespace lamina {
namespace {

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

}  // namespace

std::vector<Triangle> triangulate(const Hole& hole, const std::vector<Point3>& vertices) {
  // Beyond this the cubic time would be felt (some 10 ms).
  constexpr std::size_t kMostCorners = 120;
  if (hole.corners.size() > kMostCorners) return clipEars(hole.corners, vertices);
  return LeastFolds(hole, vertices).triangles();
}

}  // namespace lamina
