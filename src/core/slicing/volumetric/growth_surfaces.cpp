// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/parameterization/surface_cut.hpp"

namespace lamina {
namespace {

constexpr double kLevelMm = 1e-9;

using CubeNumbers = std::vector<std::uint32_t>;

/// Layers whose middle lies from one growth to another: first, and one past the last.
std::array<std::size_t, 2> layersCut(const std::vector<LayerBounds>& layers, double low, double high) {
  const auto isBelow = [](const LayerBounds& layer, double growth) { return layer.cut() <= growth; };
  const auto first = std::lower_bound(layers.begin(), layers.end(), low, isBelow);
  const auto last = std::lower_bound(first, layers.end(), high, isBelow);
  return {static_cast<std::size_t>(first - layers.begin()), static_cast<std::size_t>(last - layers.begin())};
}

std::array<double, 2> rangeOf(const GrowthLattice& lattice, const GrowthCube& cube) {
  double low = lattice.samples()[cube.sample[0]].growth_mm;
  double high = low;
  for (const std::uint32_t sample : cube.sample) {
    low = std::min(low, lattice.samples()[sample].growth_mm);
    high = std::max(high, lattice.samples()[sample].growth_mm);
  }
  return {low, high};
}

/// The cubes that each layer's middle passes, ascending.
std::vector<CubeNumbers> cubesOfLayers(const GrowthLattice& lattice, const std::vector<LayerBounds>& layers,
                                       const std::vector<char>& is_left) {
  std::vector<CubeNumbers> of_layers(layers.size());
  for (std::uint32_t number = 0; number < lattice.cubes().size(); ++number) {
    const auto [low, high] = rangeOf(lattice, lattice.cubes()[number]);
    const auto [first, last] = layersCut(layers, low, high);
    for (std::size_t layer = first; layer < last; ++layer)
      if (is_left[layer] == 0) of_layers[layer].push_back(number);
  }
  return of_layers;
}

/// Where growth goes; up where fronts meet that cancel each other.
Point3 directionOf(const GrowthSample& sample) {
  const double length = sample.gradient.norm();
  return length > 1e-6 ? Point3(sample.gradient / length) : Point3(Point3::UnitZ());
}

/// Which triangles meet at vertices, each with those that share a side with it there. Sides of more than two
/// triangles join none.
class VertexFans {
 public:
  explicit VertexFans(const Mesh& mesh) : mesh_(mesh), fan_(3 * mesh.triangles.size()) {
    std::iota(fan_.begin(), fan_.end(), std::size_t{0});
    std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> sides;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t a = mesh.triangles[triangle][side];
        const std::uint32_t b = mesh.triangles[triangle][(side + 1) % 3];
        sides[{std::min(a, b), std::max(a, b)}].push_back(triangle);
      }
    for (const auto& [ends, triangles] : sides) {
      if (triangles.size() != 2) continue;
      for (const std::uint32_t end : ends) join(cornerOf(triangles[0], end), cornerOf(triangles[1], end));
    }
  }

  /// A corner (3 x triangle + its number) that stands for all of its fan.
  std::size_t of(std::size_t corner) {
    while (fan_[corner] != corner) corner = fan_[corner] = fan_[fan_[corner]];
    return corner;
  }

 private:
  std::size_t cornerOf(std::size_t triangle, std::uint32_t vertex) const {
    const Triangle& corner = mesh_.triangles[triangle];
    return 3 * triangle +
           static_cast<std::size_t>(std::find(corner.begin(), corner.end(), vertex) - corner.begin());
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    fan_[std::max(a, b)] = std::min(a, b);
  }

  const Mesh& mesh_;
  std::vector<std::size_t> fan_;
};

/// Where pieces of a surface touch at a vertex or along a side, each gets vertices of its own.
LayerSurface withoutTouchingPieces(LayerSurface surface) {
  VertexFans fans(surface.middle);
  constexpr std::size_t kFree = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> taken(surface.middle.vertices.size(), kFree);
  std::map<std::size_t, std::uint32_t> copies;
  for (std::size_t corner = 0; corner < 3 * surface.middle.triangles.size(); ++corner) {
    std::uint32_t& vertex = surface.middle.triangles[corner / 3][corner % 3];
    const std::size_t fan = fans.of(corner);
    if (taken[vertex] == kFree) taken[vertex] = fan;
    if (taken[vertex] == fan) continue;
    const auto [copy, is_new] =
        copies.emplace(fan, static_cast<std::uint32_t>(surface.middle.vertices.size()));
    if (is_new) {
      surface.middle.vertices.push_back(Point3(surface.middle.vertices[vertex]));
      surface.tip.push_back(Point3(surface.tip[vertex]));
      surface.normal.push_back(Point3(surface.normal[vertex]));
      surface.height_mm.push_back(double(surface.height_mm[vertex]));
    }
    vertex = copy->second;
  }
  return surface;
}

class EqualGrowth {
 public:
  EqualGrowth(const GrowthLattice& lattice, const CellGraph& cells, const CubeNumbers& cubes,
              const LayerBounds& layer, const SignedDistance& skin)
      : lattice_(lattice), cells_(cells), cubes_(cubes), layer_(layer), skin_(skin) {}

  LayerSurface surface() && {
    for (const std::uint32_t number : cubes_) addVertex(lattice_.cubes()[number]);
    for (std::size_t i = 0; i < cubes_.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) addFace(i, axis);
    return withoutTouchingPieces(whereNotNegative(surface_, inside_));
  }

 private:
  const GrowthSample& sampleAt(const GrowthCube& cube, std::size_t corner) const {
    return lattice_.samples()[cube.sample[corner]];
  }
  bool isBelow(const GrowthSample& sample) const { return sample.growth_mm < layer_.cut(); }

  /// Mean of where the layer's middle crosses the edges of a cube.
  Point3 crossing(const GrowthCube& cube) const {
    Point3 sum = Point3::Zero();
    int count = 0;
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t b = a | std::size_t{1} << axis;
        const GrowthSample& from = sampleAt(cube, a);
        const GrowthSample& to = sampleAt(cube, b);
        if (a == b || isBelow(from) == isBelow(to)) continue;
        const double part = (layer_.cut() - from.growth_mm) / (to.growth_mm - from.growth_mm);
        sum += from.at + part * (to.at - from.at);
        ++count;
      }
    return sum / count;
  }

  void addVertex(const GrowthCube& cube) {
    const double cell = cells_.frame().voxel_mm;
    Point3 point = crossing(cube);
    GrowthSample sample = lattice_.within(cube, point);
    const double step = (layer_.cut() - sample.growth_mm) / sample.steepness;
    point += std::clamp(step, -0.25 * cell, 0.25 * cell) * directionOf(sample);
    sample = lattice_.within(cube, point);
    const double height = layer_.height() / sample.steepness;
    surface_.middle.vertices.push_back(point);
    surface_.normal.push_back(directionOf(sample));
    surface_.height_mm.push_back(height);
    surface_.tip.emplace_back(point + 0.5 * height * surface_.normal.back());
    inside_.push_back(isDeep(cube) ? cell : skin_.at(point).inside_mm);
  }

  bool isDeep(const GrowthCube& cube) const {
    return std::all_of(cube.sample.begin(), cube.sample.end(), [this](std::uint32_t sample) {
      const std::uint32_t node = lattice_.samples()[sample].node;
      return node != CellGraph::kNone && cells_.bits(node) == CellGraph::kFull;
    });
  }

  /// Vertex of the cube with two samples at two corners; none if there is none.
  std::uint32_t vertexOf(const std::array<int, 3>& cell, std::array<std::size_t, 2> corners,
                         std::array<std::uint32_t, 2> samples) const {
    const auto [first, last] = lattice_.cubesAt(cell);
    for (std::uint32_t number = first; number < last; ++number) {
      const GrowthCube& cube = lattice_.cubes()[number];
      if (cube.sample[corners[0]] != samples[0] || cube.sample[corners[1]] != samples[1]) continue;
      const auto at = std::lower_bound(cubes_.begin(), cubes_.end(), number);
      return static_cast<std::uint32_t>(at - cubes_.begin());
    }
    return CellGraph::kNone;
  }

  /// The face across the edge of a cube that ends at its last corner, between the four cubes around it.
  void addFace(std::size_t vertex, std::size_t axis) {
    const GrowthCube& cube = lattice_.cubes()[cubes_[vertex]];
    const std::size_t from = 7 - (std::size_t{1} << axis);
    const bool begins_below = isBelow(sampleAt(cube, from));
    if (begins_below == isBelow(sampleAt(cube, 7))) return;
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    constexpr std::array<std::array<int, 2>, 4> kAround = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<std::uint32_t, 4> around{};
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<int, 3> cell = cube.cell;
      cell[u] += kAround[i][0];
      cell[v] += kAround[i][1];
      const std::size_t back =
          static_cast<std::size_t>(kAround[i][0]) << u | static_cast<std::size_t>(kAround[i][1]) << v;
      around[i] = vertexOf(cell, {from ^ back, 7 ^ back}, {cube.sample[from], cube.sample[7]});
      if (around[i] == CellGraph::kNone) return;
    }
    if (!begins_below) std::swap(around[1], around[3]);
    split(around);
  }

  void split(const std::array<std::uint32_t, 4>& face) {
    const auto squared = [&](std::size_t a, std::size_t b) {
      return (surface_.middle.vertices[face[a]] - surface_.middle.vertices[face[b]]).squaredNorm();
    };
    std::vector<Triangle>& triangles = surface_.middle.triangles;
    if (squared(0, 2) <= squared(1, 3) * (1.0 + 1e-9)) {
      triangles.push_back({face[0], face[1], face[2]});
      triangles.push_back({face[0], face[2], face[3]});
    } else {
      triangles.push_back({face[0], face[1], face[3]});
      triangles.push_back({face[1], face[2], face[3]});
    }
  }

  const GrowthLattice& lattice_;
  const CellGraph& cells_;
  const CubeNumbers& cubes_;
  LayerBounds layer_;
  const SignedDistance& skin_;
  LayerSurface surface_;
  std::vector<double> inside_;
};

bool isLevelSample(const GrowthSample& sample, double bed_mm) {
  return std::abs(sample.growth_mm - (sample.at.z() - bed_mm)) <= kLevelMm;
}

}  // namespace

std::vector<char> levelLayers(const CellGraph& cells, const GrowthLattice& lattice,
                              const std::vector<LayerBounds>& layers, double bed_mm) {
  std::vector<char> is_level(layers.size(), 1);
  const auto bendBetween = [&](double low, double high) {
    const auto [first, last] = layersCut(layers, low, high);
    for (std::size_t layer = first; layer < last; ++layer) is_level[layer] = 0;
  };
  const double cell = cells.frame().voxel_mm;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) {
    const double bottom = cells.corner(node).z() - bed_mm;
    if (!isLevelSample(lattice.samples()[node], bed_mm))
      bendBetween(bottom - 0.5 * cell, bottom + 1.5 * cell);
  }
  for (const GrowthCube& cube : lattice.cubes()) {
    const auto isBent = [&](std::uint32_t sample) {
      return !isLevelSample(lattice.samples()[sample], bed_mm);
    };
    if (std::none_of(cube.sample.begin(), cube.sample.end(), isBent)) continue;
    const auto [low, high] = rangeOf(lattice, cube);
    bendBetween(low, high);
  }
  return is_level;
}

std::vector<LayerSurface> growthSurfaces(const GrowthLattice& lattice, const CellGraph& cells,
                                         const LayersToCut& cut, const SignedDistance& skin,
                                         Progress& progress) {
  const std::vector<LayerBounds>& layers = cut.layers;
  const std::vector<CubeNumbers> cubes = cubesOfLayers(lattice, layers, cut.is_left);
  std::vector<LayerSurface> surfaces(layers.size());
  const auto makeSurface = [&](std::size_t i) {
    if (!cubes[i].empty()) surfaces[i] = EqualGrowth(lattice, cells, cubes[i], layers[i], skin).surface();
  };
  parallelFor(layers.size(), makeSurface, progress, "layers");
  return surfaces;
}

}  // namespace lamina
