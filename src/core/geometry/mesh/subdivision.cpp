// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/subdivision.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostTriangles = 20'000'000;
constexpr std::uint32_t kWhole = std::numeric_limits<std::uint32_t>::max();

/// Halves edges of one mesh; both triangles of an edge get the same middle.
class Halving {
 public:
  Halving(Subdivision& result, double longest_mm)
      : mesh_(result.mesh), ends_(result.ends), longest_squared_(longest_mm * longest_mm) {}

  std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) {
    if ((mesh_.vertices[a] - mesh_.vertices[b]).squaredNorm() <= longest_squared_) return kWhole;
    const auto [found, is_new] = middles_.try_emplace(std::minmax(a, b), kWhole);
    if (is_new) {
      found->second = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.emplace_back(0.5 * (mesh_.vertices[a] + mesh_.vertices[b]));
      ends_.push_back({std::min(a, b), std::max(a, b)});
    }
    return found->second;
  }

  double squaredLength(std::uint32_t a, std::uint32_t b) const {
    return (mesh_.vertices[a] - mesh_.vertices[b]).squaredNorm();
  }

 private:
  Mesh& mesh_;
  std::vector<std::array<std::uint32_t, 2>>& ends_;
  double longest_squared_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

/// What is left of a triangle of which two sides are halved, after the corner between them is taken: cut
/// along its shorter diagonal.
void addTrapezium(const std::array<std::uint32_t, 4>& corner, const Halving& halving,
                  std::vector<Triangle>& parts) {
  if (halving.squaredLength(corner[0], corner[2]) <= halving.squaredLength(corner[1], corner[3])) {
    parts.push_back({corner[0], corner[1], corner[2]});
    parts.push_back({corner[0], corner[2], corner[3]});
  } else {
    parts.push_back({corner[0], corner[1], corner[3]});
    parts.push_back({corner[1], corner[2], corner[3]});
  }
}

void addParts(const Triangle& whole, Halving& halving, std::vector<Triangle>& parts) {
  std::array<std::uint32_t, 3> middle{};
  for (std::size_t k = 0; k < 3; ++k) middle[k] = halving.middleOf(whole[k], whole[(k + 1) % 3]);
  const auto halved =
      std::count_if(middle.begin(), middle.end(), [](std::uint32_t m) { return m != kWhole; });
  if (halved == 0) {
    parts.push_back(whole);
    return;
  }
  if (halved == 3) {
    for (std::size_t k = 0; k < 3; ++k) parts.push_back({whole[k], middle[k], middle[(k + 2) % 3]});
    parts.push_back({middle[0], middle[1], middle[2]});
    return;
  }
  // Turned such that side 0 is halved; of two halved sides, side 0 and side 1.
  std::size_t k = 0;
  while (middle[k] == kWhole || (halved == 2 && middle[(k + 1) % 3] == kWhole)) ++k;
  const std::uint32_t a = whole[k];
  const std::uint32_t b = whole[(k + 1) % 3];
  const std::uint32_t c = whole[(k + 2) % 3];
  if (halved == 1) {
    parts.push_back({a, middle[k], c});
    parts.push_back({middle[k], b, c});
    return;
  }
  parts.push_back({middle[k], b, middle[(k + 1) % 3]});
  addTrapezium({a, middle[k], middle[(k + 1) % 3], c}, halving, parts);
}

}  // namespace

Subdivision subdivide(const Mesh& mesh, double longest_edge_mm) {
  if (!(longest_edge_mm > 0.0))
    throw InvalidInput("the longest edge is " + numberText(longest_edge_mm) + " mm; must be positive");
  Subdivision result{mesh, {}};
  std::size_t before = 0;
  while (before != result.mesh.vertices.size()) {
    before = result.mesh.vertices.size();
    Halving halving(result, longest_edge_mm);
    std::vector<Triangle> parts;
    parts.reserve(result.mesh.triangles.size());
    for (const Triangle& triangle : result.mesh.triangles) addParts(triangle, halving, parts);
    if (parts.size() > kMostTriangles)
      throw InvalidInput("edges of at most " + numberText(longest_edge_mm) +
                         " mm would give more than 20 million triangles; expected a greater length");
    result.mesh.triangles = std::move(parts);
  }
  return result;
}

}  // namespace lamina
