// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/creases.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "parameterization/net_curvature.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
// Cosine of the angle between triangles from which on an edge is a crease.
const double kCrease = std::cos(M_PI / 6.0);
// Parts that would enclose more curvature than this when joined do not unroll together [rad].
constexpr double kUnrolls = 0.05;

std::vector<Point3> areaVectors(const Mesh& surface) {
  std::vector<Point3> areas;
  areas.reserve(surface.triangles.size());
  for (const Triangle& corner : surface.triangles) {
    const Point3& a = surface.vertices[corner[0]];
    areas.emplace_back(0.5 * (surface.vertices[corner[1]] - a).cross(surface.vertices[corner[2]] - a));
  }
  return areas;
}

/// Patches without creases inside, some of them joined.
class Patches {
 public:
  Patches(const Mesh& surface, const MeshTopology& topology)
      : surface_(surface),
        topology_(topology),
        area_vector_(areaVectors(surface)),
        curvature_(insideCurvature(surface, topology)),
        patch_(surface.triangles.size(), kNone) {
    for (std::uint32_t seed = 0; seed < patch_.size(); ++seed)
      if (patch_[seed] == kNone) flood(seed);
    joined_.resize(area_.size());
    std::iota(joined_.begin(), joined_.end(), 0U);
    enclosed_.assign(area_.size(), 0.0);
    gatherBorders();
  }

  /// Counts patches smaller than an area to their neighbours.
  void absorbSmall(double least_area) {
    std::vector<std::pair<double, std::uint32_t>> neighbour(area_.size(), {0.0, kNone});
    for (const auto& [pair, length] : borders_) {
      neighbour[pair.first] = std::max(neighbour[pair.first], {length, pair.second});
      neighbour[pair.second] = std::max(neighbour[pair.second], {length, pair.first});
    }
    for (std::uint32_t patch = 0; patch < area_.size(); ++patch)
      if (area_[patch] < least_area && neighbour[patch].second != kNone)
        join(rootOf(patch), rootOf(neighbour[patch].second));
  }

  /// Joins what unrolls together, longest common borders first, each with one other at a time.
  void joinUnrolling() {
    std::vector<std::pair<double, std::pair<std::uint32_t, std::uint32_t>>> order;
    order.reserve(borders_.size());
    for (const auto& [pair, length] : borders_) order.emplace_back(-length, pair);
    std::sort(order.begin(), order.end());
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      std::vector<char> is_joined(area_.size(), 0);
      for (const auto& [length, pair] : order) {
        const std::uint32_t one = rootOf(pair.first);
        const std::uint32_t other = rootOf(pair.second);
        if (one == other || is_joined[one] != 0 || is_joined[other] != 0) continue;
        if (!joinIfUnrolling(one, other)) continue;
        is_joined[one] = is_joined[other] = 1;
        is_changed = true;
      }
    }
  }

  Creases result() {
    Creases creases;
    std::vector<std::uint32_t> number(area_.size(), kNone);
    creases.part.reserve(patch_.size());
    for (const std::uint32_t patch : patch_) {
      std::uint32_t& part = number[rootOf(patch)];
      if (part == kNone) part = creases.parts++;
      creases.part.push_back(part);
    }
    double whole = 0.0;
    for (const double one : curvature_) whole += std::abs(one);
    for (const auto& [vertex, patches] : around_)
      if (!isOneRoot(patches)) creases.curvature += std::abs(curvature_[vertex]);
    creases.inside = whole - creases.curvature;
    return creases;
  }

 private:
  bool isCrease(std::uint32_t one, std::uint32_t other) const {
    const Point3& a = area_vector_[one];
    const Point3& b = area_vector_[other];
    return a.dot(b) <= kCrease * a.norm() * b.norm();  // also where one has no area
  }

  void flood(std::uint32_t seed) {
    const auto patch = static_cast<std::uint32_t>(area_.size());
    area_.push_back(0.0);
    std::vector<std::uint32_t> waiting = {seed};
    patch_[seed] = patch;
    while (!waiting.empty()) {
      const std::uint32_t triangle = waiting.back();
      waiting.pop_back();
      area_[patch] += area_vector_[triangle].norm();
      for (HalfEdge side = 3 * triangle; side < 3 * triangle + 3; ++side) {
        const HalfEdge other = topology_.opposite[side];
        if (other == kNoHalfEdge || patch_[triangleOf(other)] != kNone) continue;
        if (isCrease(triangle, triangleOf(other))) continue;
        patch_[triangleOf(other)] = patch;
        waiting.push_back(triangleOf(other));
      }
    }
  }

  /// Lengths of common borders, and the patches around each vertex on them.
  void gatherBorders() {
    const auto sides = static_cast<HalfEdge>(3 * patch_.size());
    sides_.resize(area_.size());
    for (HalfEdge side = 0; side < sides; ++side) {
      const HalfEdge other = topology_.opposite[side];
      if (other == kNoHalfEdge || patch_[triangleOf(side)] == patch_[triangleOf(other)]) continue;
      sides_[patch_[triangleOf(side)]].push_back(side);
      if (patch_[triangleOf(side)] > patch_[triangleOf(other)]) continue;
      const std::uint32_t from = originOf(surface_, side);
      const std::uint32_t to = originOf(surface_, other);
      borders_[{patch_[triangleOf(side)], patch_[triangleOf(other)]}] +=
          (surface_.vertices[from] - surface_.vertices[to]).norm();
      around_[from];
      around_[to];
    }
    corners_.resize(area_.size());
    for (std::uint32_t triangle = 0; triangle < patch_.size(); ++triangle)
      for (const std::uint32_t vertex : surface_.triangles[triangle])
        if (const auto found = around_.find(vertex); found != around_.end())
          found->second.push_back(patch_[triangle]);
    for (auto& [vertex, patches] : around_) {
      std::sort(patches.begin(), patches.end());
      patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
      for (const std::uint32_t patch : patches) corners_[patch].push_back(vertex);
    }
  }

  std::uint32_t rootOf(std::uint32_t patch) {
    while (joined_[patch] != patch) patch = joined_[patch] = joined_[joined_[patch]];
    return patch;
  }

  bool isOneRoot(const std::vector<std::uint32_t>& patches) {
    return std::all_of(patches.begin(), patches.end(),
                       [&](std::uint32_t patch) { return rootOf(patch) == rootOf(patches.front()); });
  }

  void join(std::uint32_t root, std::uint32_t onto) {
    if (root == onto) return;
    joined_[root] = onto;
    if (corners_[root].size() > corners_[onto].size()) std::swap(corners_[root], corners_[onto]);
    corners_[onto].insert(corners_[onto].end(), corners_[root].begin(), corners_[root].end());
    corners_[root].clear();
    if (sides_[root].size() > sides_[onto].size()) std::swap(sides_[root], sides_[onto]);
    sides_[onto].insert(sides_[onto].end(), sides_[root].begin(), sides_[root].end());
    sides_[root].clear();
  }

  bool joinIfUnrolling(std::uint32_t one, std::uint32_t other) {
    const Meeting meeting =
        corners_[one].size() < corners_[other].size() ? meet(one, other) : meet(other, one);
    const double enclosed = enclosed_[one] + enclosed_[other] + meeting.enclosed;
    if (enclosed > kUnrolls || meeting.stretches > 1) return false;
    enclosed_[one] = enclosed;
    join(other, one);
    return true;
  }

  /// Where two patches meet.
  struct Meeting {
    double enclosed = 0.0;         // curvature at creases that both together would enclose [rad]
    std::ptrdiff_t stretches = 0;  // of border in common, unless it runs all around; two would close a ring
  };

  Meeting meet(std::uint32_t smaller, std::uint32_t larger) {
    std::vector<std::uint32_t>& corners = corners_[smaller];
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    Meeting meeting;
    for (const std::uint32_t vertex : corners) {
      bool is_enclosed = true;
      bool is_shared = false;
      for (const std::uint32_t patch : around_.at(vertex)) {
        const std::uint32_t root = rootOf(patch);
        is_enclosed = is_enclosed && (root == smaller || root == larger);
        is_shared = is_shared || root == larger;
      }
      if (!is_shared) continue;
      ++meeting.stretches;
      if (is_enclosed) meeting.enclosed += std::abs(curvature_[vertex]);
    }
    for (const HalfEdge side : sides_[smaller])
      if (rootOf(patch_[triangleOf(topology_.opposite[side])]) == larger) --meeting.stretches;
    return meeting;
  }

  const Mesh& surface_;
  const MeshTopology& topology_;
  std::vector<Point3> area_vector_;
  std::vector<double> curvature_;
  std::vector<std::uint32_t> patch_;  // of each triangle
  std::vector<double> area_;
  std::vector<std::uint32_t> joined_;  // towards the patch that stands for all joined ones
  std::vector<double> enclosed_;       // at creases inside joined patches [rad]
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> borders_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> around_;
  std::vector<std::vector<std::uint32_t>> corners_;  // vertices on the creases around each
  std::vector<std::vector<HalfEdge>> sides_;         // of its triangles at creases
};

}  // namespace

Creases findCreases(const Mesh& surface, const MeshTopology& topology, double least_area) {
  Patches patches(surface, topology);
  patches.absorbSmall(least_area);
  Creases apart = patches.result();
  patches.joinUnrolling();
  Creases joined = patches.result();
  return joined.parts > 1 ? joined : apart;
}

}  // namespace lamina
