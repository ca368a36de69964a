// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/mesh_repair.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/parts/parts.hpp"

namespace lamina {
namespace {

Mesh without(Mesh mesh, std::size_t first, std::size_t last) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                       mesh.triangles.begin() + static_cast<std::ptrdiff_t>(last));
  return mesh;
}

Mesh together(Mesh a, const Mesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

Mesh insideOut(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh moved(Mesh mesh, const Point3& shift) {
  for (Point3& vertex : mesh.vertices) vertex += shift;
  return mesh;
}

/// Every triangle with vertices of its own.
Mesh soup(const Mesh& mesh) {
  Mesh apart;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t v : t) apart.vertices.push_back(mesh.vertices[v]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

Mesh cube(const char* side) { return makePart("box", {{"x_mm", side}, {"y_mm", side}, {"z_mm", side}}); }

std::string changesOf(const RepairResult& result) {
  std::string text;
  for (const RepairChange& change : result.changes) text += toText(change) + "\n";
  return text;
}

void expectSolid(const Mesh& mesh, double expected_volume, double tolerance) {
  const RepairResult result = repairMesh(mesh);
  EXPECT_FALSE(pairHalfEdges(result.mesh).has_border) << changesOf(result);
  EXPECT_NEAR(volume(result.mesh), expected_volume, tolerance) << changesOf(result);
  EXPECT_FALSE(result.changes.empty());
  EXPECT_NO_THROW(requireSound(result.mesh));
  EXPECT_THROW(requireSound(mesh), InvalidMesh);
}

class EverySoundPart : public testing::TestWithParam<std::string> {};

TEST_P(EverySoundPart, PassesUnchanged) {
  const Mesh mesh = makePart(GetParam());
  const RepairResult result = repairMesh(mesh);
  EXPECT_EQ(result.mesh.vertices, mesh.vertices);
  EXPECT_EQ(result.mesh.triangles, mesh.triangles);
  EXPECT_TRUE(result.changes.empty()) << changesOf(result);
  EXPECT_EQ(result.topology.opposite, pairHalfEdges(mesh).opposite);
}

TEST_P(EverySoundPart, IsTurnedBackWhenInsideOut) {
  const Mesh mesh = makePart(GetParam());
  expectSolid(insideOut(mesh), volume(mesh), 1e-9 * volume(mesh));
}

TEST_P(EverySoundPart, IsWeldedFromSeparateTriangles) {
  const Mesh mesh = makePart(GetParam());
  expectSolid(soup(mesh), volume(mesh), 1e-9 * volume(mesh));
}

INSTANTIATE_TEST_SUITE_P(Parts, EverySoundPart, testing::ValuesIn(partNames()));

TEST(MeshRepair, SaysWhatBecameOfTrianglesOfWhichNoneIsLeft) {
  const Mesh needles{{{0, 0, 0}, {1, 1, 1}}, {{0, 1, 1}, {1, 0, 0}, {0, 0, 1}}};
  const Mesh sheet{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  const auto refusalOf = [](const Mesh& mesh) -> std::string {
    try {
      repairMesh(mesh);
    } catch (const InvalidMesh& error) {
      return error.what();
    }
    return "repaired";
  };
  EXPECT_NE(refusalOf(needles).find("of 3 triangles none is left, 3 degenerate triangles dropped near"),
            std::string::npos)
      << refusalOf(needles);
  EXPECT_NE(refusalOf(sheet).find("of 2 triangles none is left"), std::string::npos) << refusalOf(sheet);
  EXPECT_NE(refusalOf(sheet).find("expected faces around a volume"), std::string::npos);
}

TEST(MeshRepair, ClosesAMissingSideOfABox) { expectSolid(without(cube("10"), 0, 2), 1000.0, 1e-9); }

TEST(MeshRepair, ClosesALargePlanarHole) {
  // 512 edges: beyond the small holes.
  const Mesh whole = makePart("cylinder", {{"segments", "512"}});
  Mesh open = whole;
  const auto is_bottom = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return whole.vertices[v].z() == 0.0; });
  };
  open.triangles.erase(std::remove_if(open.triangles.begin(), open.triangles.end(), is_bottom),
                       open.triangles.end());
  expectSolid(open, volume(whole), 1e-9 * volume(whole));
}

TEST(MeshRepair, ClosesAHoleInACurvedSide) {
  const Mesh sphere = makePart("sphere");
  expectSolid(without(sphere, 4000, 4012), volume(sphere), 0.001 * volume(sphere));
}

TEST(MeshRepair, StitchesACrackWithinTheTolerance) {
  Mesh cracked = soup(cube("10"));
  Random random(5);
  for (Point3& vertex : cracked.vertices)
    for (double& x : vertex) x += random.uniform(-0.0005, 0.0005);
  expectSolid(cracked, 1000.0, 0.5);
}

/// Each side of the large cube is a piece of its own, and encloses nothing.
TEST(MeshRepair, SaysWhatVolumeATornSurfaceLoses) {
  Mesh torn = soup(cube("20"));
  for (const Triangle& t : torn.triangles) {
    const Point3 first = torn.vertices[t[0]];
    const Point3 b = torn.vertices[t[1]] - first;
    const Point3 c = torn.vertices[t[2]] - first;
    for (const std::uint32_t v : t) torn.vertices[v] += 0.1 * b.cross(c).normalized();
  }
  const RepairResult result = repairMesh(together(torn, moved(cube("4"), {40, 0, 0})));
  EXPECT_NEAR(volume(result.mesh), 64.0, 1e-9);
  // 64 of 64 and 20 x 20 x 20.2 mm³.
  EXPECT_EQ(result.changes.back().what, "% of the enclosed volume lost with torn pieces")
      << changesOf(result);
  EXPECT_EQ(result.changes.back().count, 99U);
}

TEST(MeshRepair, SplitsAnEdgeAtAVertexOnIt) {
  // One bottom triangle of the box is cut in two at the middle of an edge; its neighbour is not.
  Mesh mesh = cube("10");
  const Triangle t = mesh.triangles[0];
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]));
  mesh.triangles[0] = {t[0], middle, t[2]};
  mesh.triangles.push_back({middle, t[1], t[2]});
  expectSolid(mesh, 1000.0, 1e-9);
  EXPECT_EQ(repairMesh(mesh).changes.size(), 1u);
}

TEST(MeshRepair, DropsDegenerateAndRepeatedTriangles) {
  Mesh mesh = cube("10");
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({mesh.triangles[3][1], mesh.triangles[3][2], mesh.triangles[3][0]});
  const RepairResult result = repairMesh(mesh);
  EXPECT_EQ(result.mesh.triangles, cube("10").triangles);
  ASSERT_EQ(result.changes.size(), 2u);
  EXPECT_EQ(result.changes[0].what, "degenerate triangles dropped");
  EXPECT_EQ(result.changes[1].what, "repeated triangles dropped");
}

TEST(MeshRepair, TakesADoubledSurfaceForOne) {
  const Mesh mesh = cube("10");
  Mesh doubled = mesh;
  for (const Triangle& t : mesh.triangles) doubled.triangles.push_back({t[0], t[2], t[1]});
  expectSolid(doubled, 1000.0, 1e-9);
}

TEST(MeshRepair, KeepsACavity) {
  const Mesh hollow = together(cube("10"), insideOut(moved(cube("4"), {0, 0, 3})));
  EXPECT_TRUE(repairMesh(hollow).changes.empty());
  EXPECT_NEAR(volume(hollow), 936.0, 1e-9);
  expectSolid(insideOut(hollow), 936.0, 1e-9);
}

TEST(MeshRepair, TurnsOneOfTwoBodies) {
  expectSolid(together(cube("10"), insideOut(moved(cube("4"), {20, 0, 0}))), 1064.0, 1e-9);
}

TEST(MeshRepair, LeavesBodiesThatTouchAlongAnEdgeAlone) {
  // Welded: four triangles meet along the common edge.
  Mesh mesh = together(cube("10"), moved(cube("10"), {10, 10, 0}));
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      for (std::uint32_t first = 0; first < v; ++first)
        if (mesh.vertices[first] == mesh.vertices[v]) v = first;
  EXPECT_TRUE(repairMesh(mesh).changes.empty());
}

TEST(MeshRepair, DropsALooseSheet) {
  Mesh mesh = cube("10");
  mesh.vertices.insert(mesh.vertices.end(), {{30, 0, 0}, {40, 0, 0}, {30, 10, 0}});
  mesh.triangles.push_back({8, 9, 10});
  const RepairResult result = repairMesh(mesh);
  EXPECT_EQ(result.mesh.triangles, cube("10").triangles);
  EXPECT_EQ(result.mesh.vertices.size(), 8u);
}

TEST(MeshRepair, RefusesWhatEnclosesNothing) {
  EXPECT_THROW(repairMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), InvalidMesh);
  EXPECT_THROW(repairMesh({}), InvalidMesh);
}

TEST(MeshRepair, NamesTheDefectAndItsPlace) {
  try {
    requireSound(without(cube("10"), 0, 1));
    FAIL();
  } catch (const InvalidMesh& error) {
    EXPECT_NE(std::string(error.what()).find("not closed"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(") mm"), std::string::npos);
  }
}

TEST(MeshRepair, MendsRandomDamage) {
  const std::vector<std::string> names = partNames();
  EXPECT_TRUE(rc::check("damaged parts become solids of nearly the same volume", [&] {
    const std::string name = *rc::gen::elementOf(names);
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Mesh whole = makePart(name);
    Mesh damaged = whole;
    // At most a fortieth of the triangles is lost, a third turned, a fifth of the corners cut loose.
    const std::size_t lost = whole.triangles.size() / 40;
    for (std::size_t i = 0; i < lost; ++i)
      damaged.triangles.erase(damaged.triangles.begin() +
                              static_cast<std::ptrdiff_t>(random.below(damaged.triangles.size())));
    for (Triangle& t : damaged.triangles) {
      if (random.uniform(0, 1) < 0.3) std::swap(t[0], t[1]);
      if (random.uniform(0, 1) > 0.2) continue;
      damaged.vertices.push_back(damaged.vertices[t[2]]);
      t[2] = static_cast<std::uint32_t>(damaged.vertices.size() - 1);
    }
    const RepairResult result = repairMesh(damaged);
    RC_ASSERT(!pairHalfEdges(result.mesh).has_border);
    RC_LOG() << name << " " << volume(result.mesh) << " of " << volume(whole) << "\n" << changesOf(result);
    RC_ASSERT(std::abs(volume(result.mesh) - volume(whole)) < 0.05 * volume(whole));
  }));
}

}  // namespace
}  // namespace lamina
