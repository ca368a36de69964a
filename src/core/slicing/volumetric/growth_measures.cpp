// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_measures.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lamina/base/parallel.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "slicing/volumetric/skin_samples.hpp"

namespace lamina {
namespace {

constexpr std::size_t kBlockOfTriangles = 1024;
constexpr double kBeyond = 0.02;
constexpr double kMeeting = 0.9;  // cosine between neighbours' directions, below which fronts meet

/// Growth at a place of the surface as the layers have it: in the cube around it that joins the node below
/// it.
GrowthSample sampleThere(const CellGraph& cells, const GrowthLattice& lattice, const Point3& place,
                         std::uint32_t node) {
  const Point3 at = (place - cells.frame().corner) / cells.frame().voxel_mm - Point3::Constant(0.5);
  const auto [first, last] =
      lattice.cubesAt({static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z())});
  for (std::uint32_t number = first; number < last; ++number) {
    const GrowthCube& cube = lattice.cubes()[number];
    if (std::find(cube.sample.begin(), cube.sample.end(), node) != cube.sample.end())
      return lattice.within(cube, place);
  }
  return lattice.samples()[node];
}

/// Whether there is part below a place, or as far beside that as a layer may overhang: by its height.
bool isOnPart(const CellGraph& cells, const Point3& below, const Point3& normal, double height_mm) {
  if (cells.nodeAt(below) != CellGraph::kNone) return true;
  const Point3 across = normal.unitOrthogonal();
  const Point3 along = normal.cross(across);
  for (const Point3& aside : {across, along, Point3(-across), Point3(-along)})
    if (cells.nodeAt(below + height_mm * aside) != CellGraph::kNone) return true;
  return false;
}

bool isGrown(const GrowthSample& sample) { return std::isfinite(sample.growth_mm); }

}  // namespace

HangingSurface hangingSurface(const Mesh& mesh, const CellGraph& cells, const GrowthLattice& lattice,
                              const OverhangQuestion& question, Progress& progress) {
  const double sine = std::sin(question.max_overhang_rad);
  struct Sums {
    double surface = 0.0;
    double level = 0.0;
  };
  std::vector<Sums> sums(mesh.triangles.size());
  std::vector<std::vector<Point3>> corners(mesh.triangles.size());
  HangingSurface hanging;
  hanging.grown_by_triangle.assign(mesh.triangles.size(), 0.0);
  const auto look = [&](std::size_t i) {
    std::array<Point3, 3> corner;
    for (std::size_t side = 0; side < 3; ++side) corner[side] = mesh.vertices[mesh.triangles[i][side]];
    const Point3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    const auto hang = [&](const std::array<Point3, 3>& part, double area) {
      hanging.grown_by_triangle[i] += area;
      corners[i].insert(corners[i].end(), part.begin(), part.end());
    };
    visitParts(corner, cells.frame().voxel_mm, [&](const auto& part, const Point3& place, double area) {
      if (place.z() <= question.above_mm) return;
      sums[i].surface += area;
      if (-normal.z() > sine) sums[i].level += area;
      const std::uint32_t node = nodeBelow(cells, place, normal);
      if (node == CellGraph::kNone) return;
      if (!isGrown(lattice.samples()[node])) return hang(part, area);
      const GrowthSample sample = sampleThere(cells, lattice, place, node);
      if (-normal.dot(sample.gradient) > sine * sample.gradient.norm()) hang(part, area);
    });
  };
  const auto lookAtBlock = [&](std::size_t block) {
    const std::size_t end = std::min(mesh.triangles.size(), (block + 1) * kBlockOfTriangles);
    for (std::size_t i = block * kBlockOfTriangles; i < end; ++i) look(i);
  };
  parallelFor((mesh.triangles.size() + kBlockOfTriangles - 1) / kBlockOfTriangles, lookAtBlock, progress,
              "measure");
  for (std::size_t i = 0; i < sums.size(); ++i) {
    hanging.surface_mm2 += sums[i].surface;
    hanging.level_mm2 += sums[i].level;
    hanging.grown_mm2 += hanging.grown_by_triangle[i];
    for (std::size_t c = 0; c < corners[i].size(); c += 3) {
      const auto first = static_cast<std::uint32_t>(hanging.grown.vertices.size());
      hanging.grown.vertices.insert(hanging.grown.vertices.end(), &corners[i][c], &corners[i][c] + 3);
      hanging.grown.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return hanging;
}

GrownThickness grownThickness(const CellGraph& cells, const GrowthLattice& lattice, double max_thickness) {
  GrownThickness thickness;
  double looked_at = 0.0;
  double beyond = 0.0;
  double farthest = 0.0;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) {
    const GrowthSample& sample = lattice.samples()[node];
    if (!isGrown(sample)) continue;
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    Point3 right = Point3::Zero();
    bool do_fronts_meet = false;
    for (const std::uint32_t near : cells.links(node)) {
      const GrowthSample& other = lattice.samples()[near];
      if (!isGrown(other)) continue;
      if (sample.gradient.dot(other.gradient) < kMeeting * sample.steepness * other.steepness)
        do_fronts_meet = true;
      const Point3 way = other.at - sample.at;
      square += way * way.transpose() / way.squaredNorm();
      right += way * (other.growth_mm - sample.growth_mm) / way.squaredNorm();
    }
    if (do_fronts_meet || square.determinant() < 1e-3) continue;
    const double value = 1.0 / square.ldlt().solve(right).norm();
    looked_at += cells.volume(node);
    thickness.least = std::min(thickness.least, value);
    thickness.greatest = std::max(thickness.greatest, value);
    if (value < 1.0 - kBeyond || value > max_thickness * (1.0 + kBeyond)) beyond += cells.volume(node);
    const double past = std::max(1.0 / value, value / max_thickness);
    if (past > farthest) thickness.farthest = cells.middle(node);
    farthest = std::max(farthest, past);
  }
  if (looked_at > 0.0) thickness.beyond = beyond / looked_at;
  return thickness;
}

std::size_t growthMinima(const CellGraph& cells, const GrowthLattice& lattice, double bed_mm) {
  std::size_t minima = 0;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) {
    const GrowthSample& sample = lattice.samples()[node];
    if (!isGrown(sample) || cells.corner(node).z() < bed_mm + cells.frame().voxel_mm) continue;
    const NumberRange links = cells.links(node);
    if (std::none_of(links.begin(), links.end(), [&](std::uint32_t near) {
          return lattice.samples()[near].growth_mm < sample.growth_mm;
        }))
      ++minima;
  }
  return minima;
}

RestingShare restingShare(const LayerSurface& layer, const CellGraph& cells, double bed_mm,
                          double carried_mm2) {
  RestingShare share;
  for (const LayerSurface& piece : connectedPieces(layer)) {
    double area = 0.0;
    double resting = 0.0;
    for (const Triangle& corner : piece.middle.triangles) {
      const std::vector<Point3>& at = piece.middle.vertices;
      const double part = 0.5 * (at[corner[1]] - at[corner[0]]).cross(at[corner[2]] - at[corner[0]]).norm();
      Point3 below = Point3::Zero();
      for (const std::uint32_t vertex : corner)
        below += (at[vertex] - piece.height_mm[vertex] * piece.normal[vertex]) / 3.0;
      area += part;
      const std::uint32_t vertex = corner[0];
      if (below.z() <= bed_mm || isOnPart(cells, below, piece.normal[vertex], piece.height_mm[vertex]))
        resting += part;
    }
    share.area_mm2 += area;
    share.resting_mm2 += resting;
    ++share.pieces;
    if (area - resting <= carried_mm2 || resting >= share.least * area) continue;
    share.least = resting / area;
    share.least_at = piece.middle.vertices.front();
  }
  return share;
}

}  // namespace lamina
