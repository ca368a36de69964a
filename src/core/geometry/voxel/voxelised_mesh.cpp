// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/voxelised_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr double kOnFace = 1e-9;  // of a voxel: a box of whole voxels gains none by rounding

/// Where a row along x passes a triangle, and whether into (1) or out of (-1) what it encloses.
struct Crossing {
  int row = 0;
  double x = 0.0;
  int turn = 0;

  friend bool operator<(const Crossing& a, const Crossing& b) {
    return std::tie(a.row, a.x, a.turn) < std::tie(b.row, b.x, b.turn);
  }
};

/// Solid voxels of a row: [begin, end).
struct Span {
  int row = 0;
  int begin = 0;
  int end = 0;
};

/// On which side of the line from `a` to `b`, seen along x, the point lies: 1 left, -1 right, never 0. Both
/// triangles of an edge get opposite answers: it is computed in one direction, and a point on the line counts
/// as on its left.
int sideOf(const Point3& a, const Point3& b, double y, double z) {
  const bool is_turned = std::make_pair(b.y(), b.z()) < std::make_pair(a.y(), a.z());
  const Point3& from = is_turned ? b : a;
  const Point3& to = is_turned ? a : b;
  const double cross = (to.y() - from.y()) * (z - from.z()) - (to.z() - from.z()) * (y - from.y());
  const int side = cross >= 0.0 ? 1 : -1;
  return is_turned ? -side : side;
}

/// Middles of voxels between two heights: indices [begin, end).
std::array<int, 2> middlesBetween(double low, double high, double corner, double voxel_mm, int count) {
  const double begin = std::ceil((low - corner) / voxel_mm - 0.5);
  const double end = std::floor((high - corner) / voxel_mm - 0.5) + 1.0;
  return {static_cast<int>(std::clamp(begin, 0.0, double(count))),
          static_cast<int>(std::clamp(end, 0.0, double(count)))};
}

/// The rows through the middles of the voxels of a layer.
class LayerRows {
 public:
  LayerRows(const Mesh& mesh, const VoxelFrame& frame, int k)
      : mesh_(mesh), frame_(frame), z_(frame.centre(0, 0, k).z()) {}

  void cross(const Triangle& triangle) {
    const Point3& a = mesh_.vertices[triangle[0]];
    const Point3& b = mesh_.vertices[triangle[1]];
    const Point3& c = mesh_.vertices[triangle[2]];
    const auto [low, high] = std::minmax({a.y(), b.y(), c.y()});
    const auto rows = middlesBetween(low, high, frame_.corner.y(), frame_.voxel_mm, frame_.count[1]);
    for (int j = rows[0]; j < rows[1]; ++j) {
      const double y = frame_.centre(0, j, 0).y();
      const int side = sideOf(a, b, y, z_);
      if (sideOf(b, c, y, z_) != side || sideOf(c, a, y, z_) != side) continue;
      const Point3 normal = (b - a).cross(c - a);
      if (normal.x() == 0.0) continue;
      const double x = a.x() - (normal.y() * (y - a.y()) + normal.z() * (z_ - a.z())) / normal.x();
      crossings_.push_back({j, x, -side});
    }
  }

  /// @throws InvalidMesh if a row ends inside
  std::vector<Span> spans() {
    std::sort(crossings_.begin(), crossings_.end());
    std::vector<Span> spans;
    int depth = 0;
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      const Crossing& crossing = crossings_[i];
      depth += crossing.turn;
      const bool is_last = i + 1 == crossings_.size() || crossings_[i + 1].row != crossing.row;
      if (is_last && depth != 0)
        throw InvalidMesh("mesh is open: the line along x at y " +
                          numberText(frame_.centre(0, crossing.row, 0).y()) + " mm, z " + numberText(z_) +
                          " mm does not leave it as often as it enters; it must be closed");
      if (depth == 0) continue;
      const auto voxels = middlesBetween(crossing.x, std::nextafter(crossings_[i + 1].x, crossing.x),
                                         frame_.corner.x(), frame_.voxel_mm, frame_.count[0]);
      if (voxels[0] < voxels[1]) spans.push_back({crossing.row, voxels[0], voxels[1]});
    }
    return spans;
  }

 private:
  const Mesh& mesh_;
  const VoxelFrame& frame_;
  double z_;
  std::vector<Crossing> crossings_;
};

VoxelFrame frameAround(const Box3& box, double voxel_mm) {
  VoxelFrame frame = voxelFrame(box, voxel_mm);
  frame.corner = box.low;
  for (std::size_t axis = 0; axis < 3; ++axis)
    frame.count[axis] =
        std::max(1, static_cast<int>(std::ceil(box.size()[Eigen::Index(axis)] / voxel_mm - kOnFace)));
  return frame;
}

/// Per layer, the triangles that its middle passes.
std::vector<std::vector<std::uint32_t>> trianglesOfLayers(const Mesh& mesh, const VoxelFrame& frame) {
  std::vector<std::vector<std::uint32_t>> layers(static_cast<std::size_t>(frame.count[2]));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const auto [low, high] = std::minmax(
        {mesh.vertices[triangle[0]].z(), mesh.vertices[triangle[1]].z(), mesh.vertices[triangle[2]].z()});
    const auto passed = middlesBetween(low, high, frame.corner.z(), frame.voxel_mm, frame.count[2]);
    for (int k = passed[0]; k < passed[1]; ++k)
      layers[static_cast<std::size_t>(k)].push_back(static_cast<std::uint32_t>(t));
  }
  return layers;
}

void fillSpan(VoxelGrid& grid, const Span& span, int k) {
  for (int w = span.begin / VoxelGrid::kWord; w * VoxelGrid::kWord < span.end; ++w) {
    const int first = std::max(0, span.begin - w * VoxelGrid::kWord);
    const int last = std::min(VoxelGrid::kWord, span.end - w * VoxelGrid::kWord);
    grid.fillWord(w, span.row, k, ~std::uint64_t{0} >> (VoxelGrid::kWord - (last - first)) << first);
  }
}

}  // namespace

VoxelGrid voxelisedMesh(const Mesh& mesh, double voxel_mm, Progress& progress) {
  if (mesh.triangles.empty()) throw InvalidMesh("mesh has no triangle; must enclose something");
  const VoxelFrame frame = frameAround(boundingBox(mesh), voxel_mm);
  const auto layers = trianglesOfLayers(mesh, frame);
  std::vector<std::vector<Span>> spans(layers.size());
  parallelFor(
      layers.size(),
      [&](std::size_t k) {
        LayerRows rows(mesh, frame, static_cast<int>(k));
        for (const std::uint32_t t : layers[k]) rows.cross(mesh.triangles[t]);
        spans[k] = rows.spans();
      },
      progress, "voxelise");
  VoxelGrid grid(frame);
  for (std::size_t k = 0; k < spans.size(); ++k)
    for (const Span& span : spans[k]) fillSpan(grid, span, static_cast<int>(k));
  return grid;
}

}  // namespace lamina
