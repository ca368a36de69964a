// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/conformal/facing_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace lamina {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

bool faces(const Mesh& mesh, const Triangle& corner, double sign, double limit) {
  const Point3 doubled = (mesh.vertices[corner[1]] - mesh.vertices[corner[0]])
                             .cross(mesh.vertices[corner[2]] - mesh.vertices[corner[0]]);
  return sign * doubled.z() > limit * doubled.norm();
}

/// Disjoint sets of vertices, each named by its least one.
class VertexSets {
 public:
  explicit VertexSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    const auto [least, other] = std::minmax({find(a), find(b)});
    parent_[other] = least;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

struct NumberedPatch {
  Mesh patch;
  std::vector<std::uint32_t> place;  // of each vertex of the mesh in the patch, or kNone
};

NumberedPatch numberedPatch(const Mesh& mesh, const TriangleNumbers& triangles) {
  NumberedPatch result{{}, std::vector<std::uint32_t>(mesh.vertices.size(), kNone)};
  result.patch.triangles.reserve(triangles.size());
  for (const std::uint32_t number : triangles) {
    Triangle corner = mesh.triangles[number];
    for (std::uint32_t& vertex : corner) {
      std::uint32_t& place = result.place[vertex];
      if (place == kNone) {
        place = static_cast<std::uint32_t>(result.patch.vertices.size());
        result.patch.vertices.push_back(mesh.vertices[vertex]);
      }
      vertex = place;
    }
    result.patch.triangles.push_back(corner);
  }
  return result;
}

}  // namespace

std::vector<TriangleNumbers> facingPatches(const Mesh& mesh, Facing facing, double normal_limit) {
  const double sign = facing == Facing::Up ? 1.0 : -1.0;
  TriangleNumbers facing_it;
  VertexSets sets(mesh.vertices.size());
  for (std::uint32_t number = 0; number < mesh.triangles.size(); ++number) {
    const Triangle& corner = mesh.triangles[number];
    if (!faces(mesh, corner, sign, normal_limit)) continue;
    facing_it.push_back(number);
    sets.unite(corner[0], corner[1]);
    sets.unite(corner[0], corner[2]);
  }
  std::vector<std::uint32_t> patch_of_set(mesh.vertices.size(), kNone);
  std::vector<TriangleNumbers> patches;
  for (const std::uint32_t number : facing_it) {
    std::uint32_t& patch = patch_of_set[sets.find(mesh.triangles[number][0])];
    if (patch == kNone) {
      patch = static_cast<std::uint32_t>(patches.size());
      patches.emplace_back();
    }
    patches[patch].push_back(number);
  }
  std::size_t seed = 0;
  for (std::size_t i = 1; i < patches.size(); ++i)
    if (greatestHeight(mesh, patches[i], sign) > greatestHeight(mesh, patches[seed], sign)) seed = i;
  if (seed > 0)
    std::rotate(patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(seed),
                patches.begin() + static_cast<std::ptrdiff_t>(seed) + 1);
  return patches;
}

TriangleNumbers remainder(const Mesh& mesh, const TriangleNumbers& lower, const TriangleNumbers& upper) {
  std::vector<char> is_taken(mesh.triangles.size(), 0);
  for (const std::uint32_t number : lower) is_taken[number] = 1;
  for (const std::uint32_t number : upper) is_taken[number] = 1;
  TriangleNumbers rest;
  for (std::uint32_t number = 0; number < mesh.triangles.size(); ++number)
    if (!is_taken[number]) rest.push_back(number);
  return rest;
}

Mesh patchOf(const Mesh& mesh, const TriangleNumbers& triangles) {
  return numberedPatch(mesh, triangles).patch;
}

ShellSource shellSourceOf(const Mesh& mesh, const TriangleNumbers& triangles) {
  NumberedPatch numbered = numberedPatch(mesh, triangles);
  ShellSource source{std::move(numbered.patch), {}};
  auto next = triangles.begin();
  for (std::uint32_t number = 0; number < mesh.triangles.size(); ++number) {
    if (next != triangles.end() && *next == number) {
      ++next;
      continue;
    }
    const Triangle& corner = mesh.triangles[number];
    const Point3& a = mesh.vertices[corner[0]];
    const Point3 normal =
        (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a).stableNormalized();
    if (normal.isZero(0.0)) continue;
    for (const std::uint32_t vertex : corner)
      if (numbered.place[vertex] != kNone) source.walls.push_back({numbered.place[vertex], normal});
  }
  return source;
}

Mesh turnedOver(Mesh mesh) {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

double greatestHeight(const Mesh& mesh, const TriangleNumbers& triangles, double sign) {
  double height = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t number : triangles)
    for (const std::uint32_t corner : mesh.triangles[number])
      height = std::max(height, sign * mesh.vertices[corner].z());
  return height;
}

}  // namespace lamina
