// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/surface_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

/// A surface being put together from vertices of another one and points on its edges.
class Assembly {
 public:
  explicit Assembly(const LayerSurface& source) : source_(source), place_(source.tip.size(), kNoVertex) {}

  std::uint32_t vertex(std::uint32_t of_source) {
    std::uint32_t& place = place_[of_source];
    if (place == kNoVertex)
      place = add(source_.middle.vertices[of_source], source_.tip[of_source], source_.normal[of_source],
                  source_.height_mm[of_source]);
    return place;
  }

  /// The zero of the field between two vertices of different signs: the same for both triangles of an edge.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b, const std::vector<double>& field) {
    if (a > b) std::swap(a, b);
    const auto [found, is_new] = crossings_.try_emplace({a, b}, kNoVertex);
    if (!is_new) return found->second;
    const double t = field[a] / (field[a] - field[b]);
    const auto between = [&](const std::vector<Point3>& values) {
      return Point3(values[a] + t * (values[b] - values[a]));
    };
    const Point3 normal = between(source_.normal);
    const double norm = normal.norm();
    found->second = add(between(source_.middle.vertices), between(source_.tip),
                        norm > 0.0 ? Point3(normal / norm) : source_.normal[a],
                        source_.height_mm[a] + t * (source_.height_mm[b] - source_.height_mm[a]));
    return found->second;
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) result_.middle.triangles.push_back({a, b, c});
  }

  LayerSurface take() && { return std::move(result_); }

 private:
  std::uint32_t add(const Point3& middle, const Point3& tip, const Point3& normal, double height) {
    result_.middle.vertices.push_back(middle);
    result_.tip.push_back(tip);
    result_.normal.push_back(normal);
    result_.height_mm.push_back(height);
    return static_cast<std::uint32_t>(result_.tip.size() - 1);
  }

  const LayerSurface& source_;
  std::vector<std::uint32_t> place_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  LayerSurface result_;
};

void requireField(const LayerSurface& surface, const std::vector<double>& field) {
  if (field.size() != surface.middle.vertices.size())
    throw InvalidInput("the field has " + std::to_string(field.size()) + " values; the surface has " +
                       std::to_string(surface.middle.vertices.size()) + " vertices");
  const auto bad =
      std::find_if(field.begin(), field.end(), [](double value) { return !std::isfinite(value); });
  if (bad != field.end())
    throw InvalidInput("the field at vertex " + std::to_string(bad - field.begin()) + " is " +
                       numberText(*bad) + "; expected a finite number");
}

/// Keeps what lies on the field's positive side of a triangle. A triangle that only touches zero is dropped.
void addCut(const Triangle& triangle, const std::vector<double>& field, Assembly& assembly) {
  std::array<std::uint32_t, 4> kept{};
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t from = triangle[static_cast<std::size_t>(i)];
    const std::uint32_t to = triangle[static_cast<std::size_t>((i + 1) % 3)];
    if (field[from] >= 0.0) kept[count++] = assembly.vertex(from);
    if ((field[from] > 0.0 && field[to] < 0.0) || (field[from] < 0.0 && field[to] > 0.0))
      kept[count++] = assembly.crossing(from, to, field);
  }
  for (std::size_t i = 2; i < count; ++i) assembly.addTriangle(kept[0], kept[i - 1], kept[i]);
}

}  // namespace

LayerSurface whereNotNegative(const LayerSurface& surface, const std::vector<double>& field) {
  requireField(surface, field);
  Assembly assembly(surface);
  for (const Triangle& triangle : surface.middle.triangles) {
    const double highest = std::max({field[triangle[0]], field[triangle[1]], field[triangle[2]]});
    const double lowest = std::min({field[triangle[0]], field[triangle[1]], field[triangle[2]]});
    if (lowest >= 0.0)
      assembly.addTriangle(assembly.vertex(triangle[0]), assembly.vertex(triangle[1]),
                           assembly.vertex(triangle[2]));
    else if (highest > 0.0)
      addCut(triangle, field, assembly);
  }
  return std::move(assembly).take();
}

std::vector<LayerSurface> connectedPieces(const LayerSurface& surface) {
  const MeshTopology topology = pairHalfEdges(surface.middle);
  const std::size_t count = surface.middle.triangles.size();
  std::vector<char> is_seen(count, 0);
  std::vector<LayerSurface> pieces;
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    if (is_seen[seed]) continue;
    std::vector<std::uint32_t> piece = {seed};
    is_seen[seed] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (HalfEdge side = 3 * piece[i]; side < 3 * piece[i] + 3; ++side) {
        const HalfEdge other = topology.opposite[side];
        if (other == kNoHalfEdge || is_seen[triangleOf(other)]) continue;
        is_seen[triangleOf(other)] = 1;
        piece.push_back(triangleOf(other));
      }
    std::sort(piece.begin(), piece.end());
    pieces.push_back(pieceOf(surface, piece));
  }
  return pieces;
}

LayerSurface pieceOf(const LayerSurface& surface, const std::vector<std::uint32_t>& triangles) {
  Assembly assembly(surface);
  for (const std::uint32_t number : triangles) {
    const Triangle& triangle = surface.middle.triangles[number];
    assembly.addTriangle(assembly.vertex(triangle[0]), assembly.vertex(triangle[1]),
                         assembly.vertex(triangle[2]));
  }
  return std::move(assembly).take();
}

}  // namespace lamina
