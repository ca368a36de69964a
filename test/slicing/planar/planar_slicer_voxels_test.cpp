// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sets of cubes glued together: many edges and vertices at which cubes only touch, and all areas whole
// numbers.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>

#include "lamina/base/random.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr int kPlanarSlicerVoxelsSide = 4;

/// Unit cubes on a grid.
class Cubes {
 public:
  explicit Cubes(std::uint64_t seed) {
    Random random(seed);
    for (bool& is_filled : is_filled_) is_filled = random.below(2) == 0;
  }

  bool at(int x, int y, int z) const {
    const auto isInside = [](int i) { return i >= 0 && i < kPlanarSlicerVoxelsSide; };
    if (!isInside(x) || !isInside(y) || !isInside(z)) return false;
    return is_filled_[(static_cast<std::size_t>(z) * kPlanarSlicerVoxelsSide + static_cast<std::size_t>(y)) *
                          kPlanarSlicerVoxelsSide +
                      static_cast<std::size_t>(x)];
  }

  int countInLayer(int z) const {
    int count = 0;
    for (int y = 0; y < kPlanarSlicerVoxelsSide; ++y)
      for (int x = 0; x < kPlanarSlicerVoxelsSide; ++x) count += at(x, y, z) ? 1 : 0;
    return count;
  }

  /// Whether exactly two cubes of the layer meet at this corner, diagonally.
  bool isPinched(const Point2& corner, int z) const {
    const auto x = static_cast<int>(corner.x());
    const auto y = static_cast<int>(corner.y());
    if (corner != Point2(x, y)) return false;
    return at(x, y, z) == at(x - 1, y - 1, z) && at(x - 1, y, z) == at(x, y - 1, z) &&
           at(x, y, z) != at(x - 1, y, z);
  }

  /// The faces between full and empty, corners shared.
  Mesh surface() const {
    Mesh mesh;
    for (int z = 0; z < kPlanarSlicerVoxelsSide; ++z)
      for (int y = 0; y < kPlanarSlicerVoxelsSide; ++y)
        for (int x = 0; x < kPlanarSlicerVoxelsSide; ++x)
          if (at(x, y, z)) addCube(mesh, x, y, z);
    return test::welded(mesh);
  }

 private:
  void addCube(Mesh& mesh, int x, int y, int z) const {
    const Mesh cube = test::boxBetween(Point3(x, y, z), Point3(x + 1, y + 1, z + 1));
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), cube.vertices.begin(), cube.vertices.end());
    // Two triangles a face, in the order of boxBetween.
    constexpr std::array<std::array<int, 3>, 6> kFaces = {
        {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}};
    for (std::size_t f = 0; f < 6; ++f) {
      if (at(x + kFaces[f][0], y + kFaces[f][1], z + kFaces[f][2])) continue;
      for (const Triangle& t : {cube.triangles[2 * f], cube.triangles[2 * f + 1]})
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
  }

  std::array<bool, std::size_t{kPlanarSlicerVoxelsSide} * kPlanarSlicerVoxelsSide * kPlanarSlicerVoxelsSide>
      is_filled_{};
};

std::vector<Section> planarSlicerVoxelsSlice(const Mesh& mesh, const std::vector<double>& heights) {
  NoProgress progress;
  return sliceMesh(mesh, heights, progress);
}

TEST(PlanarSlicerVoxels, EveryHalfEdgeHasAnOpposite) {
  EXPECT_TRUE(
      rc::check([](std::uint64_t seed) { RC_ASSERT(!pairHalfEdges(Cubes(seed).surface()).has_border); }));
}

TEST(PlanarSlicerVoxels, AreasCountTheCubes) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Cubes cubes(seed);
    // Through the middles of the cubes, and through their faces, where what lies above counts.
    const auto sections =
        planarSlicerVoxelsSlice(cubes.surface(), {-0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0});
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const int layer = i == 0 ? -1 : static_cast<int>(i - 1) / 2;
      RC_ASSERT(sections[i].open_contours.empty());
      RC_ASSERT(std::abs(signedArea(sections[i].contours) - cubes.countInLayer(layer)) < 1e-12);
    }
  }));
}

TEST(PlanarSlicerVoxels, ContoursTouchWithoutCrossing) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    const Cubes cubes(seed);
    const Section section = planarSlicerVoxelsSlice(cubes.surface(), {1.5}).front();
    for (const Polygon& contour : section.contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Point2& point = contour[i];
        if (!cubes.isPinched(point, 1)) continue;
        const Point2 in = point - contour[(i + contour.size() - 1) % contour.size()];
        const Point2 out = contour[(i + 1) % contour.size()] - point;
        // Turning left stays with the same cube; anything else would cross the other contour or join the
        // cubes.
        RC_ASSERT(in.x() * out.y() - in.y() * out.x() > 0.0);
      }
    }
  }));
}

}  // namespace
}  // namespace lamina
