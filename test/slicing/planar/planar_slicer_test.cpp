// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/planar/planar_slicer.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

using test::boxBetween;
using test::turnedInsideOut;
using test::welded;

Section cut(const Mesh& mesh, double height) {
  NoProgress progress;
  return sliceMesh(mesh, {height}, progress).front();
}

const Mesh kBox = boxBetween({0, 0, 0}, {4, 3, 2});

TEST(PlanarSlicer, CutsABoxIntoItsRectangle) {
  const Section section = cut(kBox, 1.0);
  ASSERT_EQ(section.contours.size(), 1U);
  EXPECT_TRUE(section.open_contours.empty());
  EXPECT_DOUBLE_EQ(signedArea(section.contours[0]), 12.0);
  EXPECT_DOUBLE_EQ(perimeter(section.contours[0]), 14.0);
}

TEST(PlanarSlicer, CutsATetrahedronIntoASmallerTriangle) {
  const Section section = cut(test::cornerTetrahedron(), 0.25);
  ASSERT_EQ(section.contours.size(), 1U);
  EXPECT_NEAR(signedArea(section.contours[0]), 0.5 * 0.75 * 0.75, 1e-15);
}

TEST(PlanarSlicer, WindsHolesClockwise) {
  const Mesh hollow = joined(kBox, turnedInsideOut(boxBetween({1, 1, 0.5}, {2, 2, 1.5})));
  const Section section = cut(hollow, 1.0);
  ASSERT_EQ(section.contours.size(), 2U);
  EXPECT_DOUBLE_EQ(signedArea(section.contours[0]), 12.0);
  EXPECT_DOUBLE_EQ(signedArea(section.contours[1]), -1.0);
}

TEST(PlanarSlicer, FindsAnIslandInAHole) {
  const Mesh hollow = joined(kBox, turnedInsideOut(boxBetween({1, 1, 0.5}, {3, 2, 1.5})));
  const Section section = cut(joined(hollow, boxBetween({1.25, 1.25, 0.75}, {1.75, 1.75, 1.25})), 1.0);
  ASSERT_EQ(section.contours.size(), 3U);
  EXPECT_DOUBLE_EQ(signedArea(section.contours), 12.0 - 2.0 + 0.25);
}

TEST(PlanarSlicer, AtTheBottomFaceGivesThatFace) {
  EXPECT_DOUBLE_EQ(signedArea(cut(kBox, 0.0).contours), 12.0);
}

TEST(PlanarSlicer, AtTheTopFaceGivesNothing) { EXPECT_TRUE(cut(kBox, 2.0).contours.empty()); }

TEST(PlanarSlicer, GivesNothingAboveAndBelowTheMesh) {
  EXPECT_TRUE(cut(kBox, -0.1).contours.empty());
  EXPECT_TRUE(cut(kBox, 2.1).contours.empty());
}

TEST(PlanarSlicer, AtTheLowestVertexLeavesNoTrace) {
  EXPECT_TRUE(cut(test::octahedron(), -1.0).contours.empty());
  EXPECT_TRUE(cut(test::octahedron(), 1.0).contours.empty());
}

TEST(PlanarSlicer, ThroughEdgesGivesEachVertexOnce) {
  const Section section = cut(test::octahedron(), 0.0);
  ASSERT_EQ(section.contours.size(), 1U);
  EXPECT_EQ(section.contours[0].size(), 4U);
  EXPECT_DOUBLE_EQ(signedArea(section.contours[0]), 2.0);
}

TEST(PlanarSlicer, ThroughAVertexInTheMiddleMeetsItExactly) {
  Mesh leaning = test::octahedron();
  leaning.vertices[0].z() = 0.25;
  const Section section = cut(leaning, 0.25);
  ASSERT_EQ(section.contours.size(), 1U);
  EXPECT_EQ(std::count(section.contours[0].begin(), section.contours[0].end(), Point2(1, 0)), 1);
}

TEST(PlanarSlicer, AtAStepTakesTheMaterialJustAboveThePlane) {
  // A wide block with a narrow one on top; the plane runs through the wide block's upper face.
  const Mesh steps = joined(boxBetween({0, 0, 0}, {4, 4, 1}), boxBetween({1, 1, 1}, {2, 2, 2}));
  EXPECT_DOUBLE_EQ(signedArea(cut(steps, 1.0).contours), 1.0);
}

TEST(PlanarSlicer, AtARidgeBelowThePlaneLeavesNoTrace) {
  const Mesh roof = {
      {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {0, 1, 1}, {4, 1, 1}},
      {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5}, {1, 2, 5}, {3, 0, 4}}};
  EXPECT_TRUE(cut(roof, 1.0).contours.empty());
  EXPECT_NEAR(signedArea(cut(roof, 0.5).contours), 4.0, 1e-12);
}

TEST(PlanarSlicer, KeepsBoxesApartThatShareAnEdge) {
  const Mesh touching = welded(joined(boxBetween({0, 0, 0}, {1, 1, 1}), boxBetween({1, 1, 0}, {2, 2, 1})));
  ASSERT_EQ(touching.vertices.size(), 14U);
  const Section section = cut(touching, 0.5);
  ASSERT_EQ(section.contours.size(), 2U);
  EXPECT_TRUE(section.open_contours.empty());
  for (const Polygon& contour : section.contours) EXPECT_DOUBLE_EQ(signedArea(contour), 1.0);
}

TEST(PlanarSlicer, KeepsBoxesApartThatShareAFace) {
  const Mesh touching = welded(joined(boxBetween({0, 0, 0}, {1, 1, 1}), boxBetween({1, 0, 0}, {2, 1, 1})));
  const Section section = cut(touching, 0.5);
  ASSERT_EQ(section.contours.size(), 2U);
  for (const Polygon& contour : section.contours) EXPECT_DOUBLE_EQ(signedArea(contour), 1.0);
}

TEST(PlanarSlicer, TurnsRoundTheMaterialBetweenCavitiesThatShareAnEdge) {
  const Mesh cavities =
      joined(boxBetween({0.5, 0.5, 0.2}, {1, 1, 0.8}), boxBetween({1, 1, 0.2}, {1.5, 1.5, 0.8}));
  const Section section =
      cut(welded(joined(boxBetween({0, 0, 0}, {2, 2, 1}), turnedInsideOut(cavities))), 0.5);
  EXPECT_TRUE(section.open_contours.empty());
  EXPECT_DOUBLE_EQ(signedArea(section.contours), 3.5);
}

TEST(PlanarSlicer, CutsAnOpenMeshIntoAnOpenLine) {
  Mesh open = kBox;
  open.triangles.erase(open.triangles.begin() + 10, open.triangles.end());  // the face x = 4
  const Section section = cut(open, 1.0);
  EXPECT_TRUE(section.contours.empty());
  ASSERT_EQ(section.open_contours.size(), 1U);
  const Polyline& line = section.open_contours[0];
  EXPECT_EQ(line.front(), Point2(4, 3));
  EXPECT_EQ(line.back(), Point2(4, 0));
  EXPECT_DOUBLE_EQ(length(line), 11.0);
}

TEST(PlanarSlicer, IgnoresTrianglesWithoutArea) {
  Mesh mesh = kBox;
  mesh.triangles.push_back({0, 0, 4});
  const Section section = cut(mesh, 1.0);
  ASSERT_EQ(section.contours.size(), 1U);
  EXPECT_DOUBLE_EQ(signedArea(section.contours[0]), 12.0);
}

TEST(PlanarSlicer, CutsAtUnevenAndRepeatedHeights) {
  NoProgress progress;
  const std::vector<double> heights = {-1.0, 0.0, 1e-9, 0.1, 0.1, 1.99, 2.0, 700.0};
  const auto sections = sliceMesh(kBox, heights, progress);
  const std::vector<double> areas = {0, 12, 12, 12, 12, 12, 0, 0};
  for (std::size_t i = 0; i < heights.size(); ++i)
    EXPECT_NEAR(signedArea(sections[i].contours), areas[i], 1e-12) << i;
}

TEST(PlanarSlicer, GivesNoSectionForNoPlane) {
  NoProgress progress;
  EXPECT_TRUE(sliceMesh(kBox, {}, progress).empty());
  EXPECT_TRUE(sliceMesh(Mesh{}, {1.0}, progress).front().contours.empty());
}

TEST(PlanarSlicer, StopsWhenCancelled) {
  class Cancelling final : public Progress {
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return true; }
  } progress;
  EXPECT_THROW(sliceMesh(kBox, {1.0}, progress), Cancelled);
}

}  // namespace
}  // namespace lamina
