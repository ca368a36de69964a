// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/nearest_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kLeafSize = 4;

double squaredDistance(const Box3& box, const Point3& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

}  // namespace

struct NearestTriangle::Search {
  Point3 point;
  double squared;  // of the nearest place so far, or the bound
  NearestPlace place;
  bool is_found = false;
};

NearestTriangle::NearestTriangle(const Mesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
  if (mesh.triangles.empty()) throw InvalidInput("the mesh has 0 triangles; expected at least one");
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Point3> middles;
  middles.reserve(mesh.triangles.size());
  for (const Triangle& corner : mesh.triangles)
    middles.push_back(mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]);
  nodes_.reserve(mesh.triangles.size());
  build(0, static_cast<std::uint32_t>(order_.size()), middles);
}

std::uint32_t NearestTriangle::build(std::uint32_t first, std::uint32_t last,
                                     const std::vector<Point3>& middles) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box;
  Box3 spread;
  for (std::uint32_t i = first; i < last; ++i) {
    for (const std::uint32_t corner : mesh_.triangles[order_[i]]) box.include(mesh_.vertices[corner]);
    spread.include(middles[order_[i]]);
  }
  nodes_[number].box = box;
  if (last - first <= kLeafSize) {
    std::sort(order_.begin() + first, order_.begin() + last);
    nodes_[number].first = first;
    nodes_[number].count = last - first;
    return number;
  }
  Eigen::Index axis = 0;
  spread.size().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double left = middles[a][axis];
                     const double right = middles[b][axis];
                     return left != right ? left < right : a < b;
                   });
  build(first, middle, middles);
  nodes_[number].first = build(middle, last, middles);
  return number;
}

void NearestTriangle::visit(std::uint32_t number, Search& search) const {
  const Node& node = nodes_[number];
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    const Triangle& corner = mesh_.triangles[order_[i]];
    const Point3 place = nearestInTriangle(search.point, mesh_.vertices[corner[0]], mesh_.vertices[corner[1]],
                                           mesh_.vertices[corner[2]]);
    const double squared = (place - search.point).squaredNorm();
    const bool is_equal_but_earlier =
        search.is_found && squared == search.squared && order_[i] < search.place.triangle;
    if (squared > search.squared || (squared == search.squared && !is_equal_but_earlier)) continue;
    search.squared = squared;
    search.place = {order_[i], place, 0.0};
    search.is_found = true;
  }
  if (node.count > 0) return;
  std::uint32_t nearer = number + 1;
  std::uint32_t farther = node.first;
  double near_bound = squaredDistance(nodes_[nearer].box, search.point);
  double far_bound = squaredDistance(nodes_[farther].box, search.point);
  if (far_bound < near_bound) {
    std::swap(nearer, farther);
    std::swap(near_bound, far_bound);
  }
  if (near_bound <= search.squared) visit(nearer, search);
  if (far_bound <= search.squared) visit(farther, search);
}

NearestPlace NearestTriangle::nearest(const Point3& point) const {
  return *nearest(point, std::numeric_limits<double>::infinity());
}

std::optional<NearestPlace> NearestTriangle::nearest(const Point3& point, double within_mm) const {
  Search search{point, within_mm * within_mm, {}, false};
  visit(0, search);
  if (!search.is_found) return std::nullopt;
  search.place.distance_mm = std::sqrt(search.squared);
  return search.place;
}

// The plane is divided into the regions nearest to a corner, a side or the inside [Ericson2005,
// section 5.1.5].
Point3 nearestInTriangle(const Point3& point, const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a;
  const Point3 ac = c - a;
  const double d1 = ab.dot(point - a);
  const double d2 = ac.dot(point - a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = ab.dot(point - b);
  const double d4 = ac.dot(point - b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(point - c);
  const double d6 = ac.dot(point - c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

}  // namespace lamina
