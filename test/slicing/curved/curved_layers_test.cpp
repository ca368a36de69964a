// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/curved_layers.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/curved_parts.hpp"

namespace lamina {
namespace {

const double kRise = 10.0 / (2.0 + std::sqrt(2.0));

CurvedLayers curved(const Mesh& mesh, double height = 0.2) {
  NoProgress progress;
  return curvedLayers(mesh, pairHalfEdges(mesh), {}, height, progress);
}

/// How far a place is from the lower planes of the octagon solid moved inwards, whichever is nearest.
double besideMovedPlanes(const Point3& p, double offset) {
  const double along = std::max(std::abs(p.x()), std::abs(p.y()));
  const double slope = (5.0 - kRise + p.z() - along) / std::sqrt(2.0);
  return std::min(p.z(), slope) - offset;
}

// The tetradecahedron of [Guacheta2021, table 5-3]; listing A.7 takes 15 shells.
TEST(CurvedLayers, OfTheOctagonSolidHaveFifteenShellsASideAndTwentyLevelLayers) {
  const CurvedLayers layers = curved(test::octagonSolid());
  EXPECT_EQ(layers.scheme, CurvedScheme::BothSides);
  ASSERT_EQ(layers.lower.size(), 15U);
  ASSERT_EQ(layers.upper.size(), 15U);
  ASSERT_EQ(layers.middle.size(), 20U);
  // From half a layer above the slopes to half a layer below the upper ones, evenly.
  EXPECT_NEAR(layers.middle.front().bounds.cut(), kRise + 0.1, 5e-5);
  EXPECT_NEAR(layers.middle.back().bounds.cut(), 10.0 - kRise - 0.1, 5e-5);
  EXPECT_NEAR(layers.middle[1].bounds.cut() - layers.middle[0].bounds.cut(), (9.8 - 2.0 * kRise) / 19.0,
              5e-5);
  // A square prism and two frusta of pyramids.
  const double base = 10.0 - 2.0 * kRise;
  const double frustum = kRise / 3.0 * (100.0 + 10.0 * base + base * base);
  EXPECT_NEAR(layers.volumes.part_mm3, 100.0 * base + 2.0 * frustum, 0.001);
  EXPECT_LT(std::abs(layers.volumes.gap()), 0.002);
}

TEST(CurvedLayers, OfTheOctagonSolidMoveEachPlaneByTheOffset) {
  const CurvedLayers layers = curved(test::octagonSolid());
  for (std::size_t i = 0; i < layers.lower.size(); ++i) {
    const double offset = 0.1 + 0.2 * static_cast<double>(i);
    const Box3 box = boundingBox(layers.lower[i].middle);
    EXPECT_NEAR(box.low.z(), offset, 1e-9);
    EXPECT_NEAR(box.high.z(), kRise, 1e-9);
    for (const Point3& p : layers.lower[i].middle.vertices)
      ASSERT_NEAR(besideMovedPlanes(p, offset), 0.0, 1e-9);
  }
}

TEST(CurvedLayers, TipsAreHalfALayerFartherByTheSamePlanes) {
  const CurvedLayers layers = curved(test::octagonSolid());
  const LayerSurface& first = layers.lower.front();
  for (const Point3& p : first.tip) ASSERT_NEAR(besideMovedPlanes(p, 0.2), 0.0, 1e-9);
  // Upper shells are deposited towards the outside: the last one's tips are on the surface itself.
  const LayerSurface& last = layers.upper.back();
  for (const Point3& p : last.tip)
    ASSERT_NEAR(besideMovedPlanes({p.x(), p.y(), 10.0 - p.z()}, 0.0), 0.0, 1e-9);
}

TEST(CurvedLayers, AreSeenFromTheNozzleAndGrowUpwards) {
  const CurvedLayers layers = curved(test::octagonSolid());
  for (const auto* shells : {&layers.lower, &layers.upper})
    for (const LayerSurface& shell : *shells)
      for (const Triangle& corner : shell.middle.triangles) {
        const Point3& a = shell.middle.vertices[corner[0]];
        const Point3 doubled =
            (shell.middle.vertices[corner[1]] - a).cross(shell.middle.vertices[corner[2]] - a);
        ASSERT_GT(doubled.z(), 0.0);
        for (const std::uint32_t vertex : corner) {
          ASSERT_NEAR(shell.normal[vertex].norm(), 1.0, 1e-9);
          ASSERT_GT(shell.normal[vertex].dot(doubled), 0.0);
        }
      }
  EXPECT_LT(boundingBox(layers.upper.front().middle).high.z(),
            boundingBox(layers.upper.back().middle).high.z());
}

/// A sphere of so many meridians and half as many zones, between which it is a frustum of a pyramid.
double volumeOfFacets(double radius, int meridians) {
  const double section = 0.5 * meridians * std::sin(2.0 * M_PI / meridians);
  double sum = 0.0;
  for (int i = 0; i < meridians / 2; ++i) {
    const double low = 2.0 * M_PI * i / meridians;
    const double high = 2.0 * M_PI * (i + 1) / meridians;
    const double a = std::sin(low);
    const double b = std::sin(high);
    sum += section * (std::cos(low) - std::cos(high)) / 3.0 * (a * a + a * b + b * b);
  }
  return sum * radius * radius * radius;
}

// The sphere of [Guacheta2021, table 5-3]
TEST(CurvedLayers, OfASphereAreThirtyFiveShellsAHalf) {
  const CurvedLayers layers = curved(makePart("sphere", {{"radius_mm", "7"}, {"segments", "32"}}));
  ASSERT_EQ(layers.lower.size(), 35U);
  ASSERT_EQ(layers.upper.size(), 35U);
  EXPECT_TRUE(layers.middle.empty());
  for (std::size_t i = 0; i < 35; ++i) {
    const double radius = 6.9 - 0.2 * static_cast<double>(i);
    // Facets of the mesh lie up to 0.07 mm inside the sphere.
    for (const Point3& p : layers.lower[i].middle.vertices)
      ASSERT_NEAR((p - Point3(0.0, 0.0, 7.0)).norm(), radius, 0.075);
  }
  EXPECT_NEAR(layers.volumes.part_mm3, volumeOfFacets(7.0, 32), 0.01);
  EXPECT_LT(std::abs(layers.volumes.gap()), 0.001);
  EXPECT_NEAR(layers.lower_ends.front().offset_mm, 7.0, 0.05);
}

// The orthohedron of [Guacheta2021, table 5-3]
TEST(CurvedLayers, OfABoxAreLevelLayers) {
  const CurvedLayers layers = curved(makePart("box", {{"x_mm", "20"}, {"y_mm", "40"}, {"z_mm", "20"}}));
  EXPECT_TRUE(layers.lower.empty());
  EXPECT_TRUE(layers.upper.empty());
  EXPECT_EQ(layers.middle.size(), 100U);
  EXPECT_NEAR(layers.volumes.middle_mm3, 16000.0, 1e-6);
}

TEST(CurvedLayers, OfAConeFollowItsSlope) {
  const CurvedLayers layers = curved(makePart("cone", {{"segments", "32"}}), 0.5);
  EXPECT_TRUE(layers.lower.empty());
  EXPECT_EQ(layers.upper.size(), 18U);  // of 20 sin(atan(1/2)) = 8.94 mm
  // Facets of 32 lie 10 cos(pi / 32) mm from the axis; corners stand out by 10 mm.
  const double least_z = std::cos(M_PI / 32.0) / std::hypot(2.0, std::cos(M_PI / 32.0));
  for (const LayerSurface& shell : layers.upper)
    for (std::size_t i = 0; i < shell.normal.size(); ++i) {
      if (shell.middle.vertices[i].head<2>().norm() < 1.0) continue;  // near the tip
      EXPECT_GE(shell.normal[i].z(), least_z - 1e-6);
      EXPECT_LE(shell.normal[i].z(), 1.0 / std::sqrt(5.0) + 0.01);
    }
  EXPECT_LT(std::abs(layers.volumes.gap()), 0.002);
}

TEST(CurvedLayers, OfABentPlateFollowItsLowerSideUpToItsUpperOne) {
  const CurvedLayers layers = curved(test::bentPlate());
  EXPECT_EQ(layers.scheme, CurvedScheme::LowerOnly);
  ASSERT_EQ(layers.lower.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    const double radius = 20.1 + 0.2 * static_cast<double>(i);
    for (const Point3& p : layers.lower[i].middle.vertices)
      ASSERT_NEAR(std::hypot(p.x(), p.z()), radius, 0.04);
    EXPECT_NEAR(boundingBox(layers.lower[i].middle).high.x(), 10.0, 2e-3);
  }
  EXPECT_LT(std::abs(layers.volumes.gap()), 0.01);
}

TEST(CurvedLayers, APartWhoseSurfacesDoNotReachAllOfItIsRefusedWithTheRegion) {
  const Mesh blade = makePart("blade", {{"points", "24"}, {"sections", "12"}});
  try {
    curved(blade, 0.5);
    FAIL() << "was not refused";
  } catch (const Unsliceable& refusal) {
    EXPECT_FALSE(refusal.region().triangles.empty());
    EXPECT_LT(surfaceArea(refusal.region()), surfaceArea(blade));
    EXPECT_NE(std::string(refusal.what()).find("curved.largest_gap_percent"), std::string::npos);
  }
}

TEST(CurvedLayers, OfADomeOnItsFlatSideFollowItsRoundOne) {
  const CurvedLayers layers = curved(test::dome(), 0.4);
  EXPECT_TRUE(layers.lower.empty());
  EXPECT_TRUE(layers.middle.empty());
  EXPECT_EQ(layers.upper.size(), 25U);
  for (std::size_t i = 0; i < 25; ++i)
    for (const Point3& p : layers.upper[i].middle.vertices) ASSERT_NEAR(p.norm(), 0.2 + 0.4 * double(i), 0.1);
  EXPECT_LT(layers.coverage.open, 0.01);
  EXPECT_LT(layers.coverage.twice, 0.01);
}

/// A sphere whose upper and lower surface are parted by a zigzag.
Mesh leaningSphere() {
  Mesh sphere = makePart("sphere", {{"radius_mm", "5"}, {"segments", "32"}});
  const Eigen::AngleAxisd turn(0.15, Point3(1.0, 0.3, 0.0).normalized());
  for (Point3& vertex : sphere.vertices) vertex = turn * (vertex - Point3(0.0, 0.0, 5.0));
  return sphere;
}

TEST(CurvedLayers, SurfacesThatOverlapInHeightMeetHalfWay) {
  const CurvedLayers layers = curved(leaningSphere());
  EXPECT_EQ(layers.scheme, CurvedScheme::Halves);
  EXPECT_FALSE(layers.lower.empty());
  EXPECT_FALSE(layers.upper.empty());
  EXPECT_LT(layers.coverage.open + layers.coverage.twice, 0.05);
}

TEST(CurvedLayers, AreTheSameOnAnyNumberOfThreads) {
  const Mesh part = leaningSphere();
  const CurvedLayers many = curved(part);
  const ThreadLimit one(1);
  const CurvedLayers few = curved(part);
  ASSERT_EQ(many.lower.size(), few.lower.size());
  ASSERT_EQ(many.upper.size(), few.upper.size());
  for (std::size_t i = 0; i < many.lower.size(); ++i) {
    EXPECT_EQ(many.lower[i].middle.vertices, few.lower[i].middle.vertices);
    EXPECT_EQ(many.lower[i].middle.triangles, few.lower[i].middle.triangles);
    EXPECT_EQ(many.lower[i].tip, few.lower[i].tip);
  }
  EXPECT_EQ(many.coverage.open, few.coverage.open);
}

/// What is between two words of a message.
double numberBetween(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos || text.find(after, begin) == std::string::npos) return -1.0;
  return std::stod(text.substr(begin + before.size()));
}

TEST(CurvedLayers, OneVoidRefusesThePartWithItsPlaceItsVolumeAndTheLimit) {
  const Mesh part = leaningSphere();
  CurvedSettings settings;
  settings.largest_gap_percent = 50.0;
  settings.largest_void_mm3 = 1e9;
  NoProgress progress;
  const CurvedLayers whole = curvedLayers(part, pairHalfEdges(part), settings, 1.5, progress);
  const double open_mm3 = whole.coverage.open * volume(part);
  settings.largest_void_mm3 = 0.5;
  try {
    curvedLayers(part, pairHalfEdges(part), settings, 1.5, progress);
    FAIL() << "not refused, with " << open_mm3 << " mm3 open in all";
  } catch (const Unsliceable& refusal) {
    const std::string message = refusal.what();
    const double void_mm3 = numberBetween(message, "a void of about ", " mm3 would be left open around (");
    EXPECT_GT(void_mm3, 0.5) << message;
    EXPECT_LE(void_mm3, open_mm3 + 0.5) << message;
    EXPECT_NE(message.find("expected at most 0.5 mm3 (curved.largest_void_mm3)"), std::string::npos);
    const double x = numberBetween(message, "open around (", ") mm;");
    EXPECT_GT(x, boundingBox(part).low.x()) << message;
    EXPECT_LT(x, boundingBox(part).high.x()) << message;
    EXPECT_FALSE(refusal.region().triangles.empty());
  }
}

TEST(CurvedLayers, CanBeCancelled) {
  class Stopped final : public Progress {
   public:
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return true; }
  } stopped;
  const Mesh part = test::dome();
  EXPECT_THROW(curvedLayers(part, pairHalfEdges(part), {}, 0.2, stopped), Cancelled);
}

TEST(CurvedLayers, AnOpenMeshIsRefused) {
  Mesh open = makePart("box");
  open.triangles.pop_back();
  EXPECT_THROW(curved(open), InvalidMesh);
}

TEST(CurvedLayers, ALayerHeightThatIsNotPositiveIsRefused) {
  EXPECT_THROW(curved(makePart("box"), 0.0), InvalidConfig);
}

TEST(CurvedLayers, InLittleRoomLevelLayersAreOneOrTwo) {
  EXPECT_TRUE(middleBounds(1.0, 1.09, 0.2).empty());
  EXPECT_EQ(middleBounds(1.0, 1.25, 0.2).size(), 1U);
  EXPECT_EQ(middleBounds(1.0, 1.35, 0.2).size(), 2U);
  EXPECT_NEAR(middleBounds(1.0, 1.35, 0.2).back().cut(), 1.2625, 1e-12);
  // [Guacheta2021, listing A.7] would take two of 0.39 mm for this plate, and five of 0.2475 mm for the next.
  for (const double room : {0.59, 0.79, 1.19}) {
    const std::vector<LayerBounds> layer_bounds = middleBounds(0.0, room, 0.2);
    EXPECT_NEAR(layer_bounds.front().bottom_mm, 0.0, 1e-12);
    EXPECT_NEAR(layer_bounds.back().top_mm, room, 1e-12);
    EXPECT_NEAR(layer_bounds.front().height(), 0.2, 0.01);
  }
}

}  // namespace
}  // namespace lamina
