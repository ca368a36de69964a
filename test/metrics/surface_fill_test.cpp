// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/surface_fill.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kSide = 10.0;  // mm

/// A square at z = 0 facing up.
Mesh levelFace() {
  return {{{0, 0, 0}, {kSide, 0, 0}, {kSide, kSide, 0}, {0, kSide, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// The same at y = 0 facing -y.
Mesh uprightFace() {
  return {{{0, 0, 0}, {kSide, 0, 0}, {kSide, 0, kSide}, {0, 0, kSide}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// Lines along x from end to end of the level face, their beads 0.2 mm high right below it.
Toolpath linesEvery(double pitch_mm, double first_mm) {
  Toolpath toolpath{"lines", {{0.0, 0.2, {}}}};
  for (double y = first_mm; y < kSide; y += pitch_mm)
    toolpath.layers[0].paths.push_back(test::straightPath({0, y, 0}, {kSide, y, 0}));
  return toolpath;
}

/// Lines one above the other behind the upright face.
Toolpath layersEvery(double pitch_mm) {
  Toolpath toolpath{"layers", {}};
  for (double z = pitch_mm; z < kSide + 1e-6; z += pitch_mm)
    toolpath.layers.push_back({z, 0.2, {test::straightPath({0, 0.2, z}, {kSide, 0.2, z})}});
  return toolpath;
}

SurfaceFill fill(const Toolpath& toolpath, const Mesh& part, const SurfaceFillSettings& settings = {},
                 const Eigen::Isometry3d& bed_from_part = Eigen::Isometry3d::Identity()) {
  NoProgress nobody;
  return measureSurfaceFill(toolpath, part, bed_from_part, settings, nobody);
}

/// Bands of 0.2 to 0.4 mm, whatever the bead.
SurfaceFillSettings byCode() {
  SurfaceFillSettings settings;
  settings.depth_mm = 0.25;
  settings.width = SurfaceWidth::Code;
  return settings;
}

SurfaceFillSettings asTheSource() {
  SurfaceFillSettings settings = byCode();
  settings.pieces = FacePieces::Within;
  settings.overlaps = Overlaps::All;
  settings.uncovered = UncoveredFaces::Skip;
  return settings;
}

TEST(SurfaceFill, OfParallelLinesIsTheirGaps) {
  // Bands of 0.4 mm every 0.5 mm leave 20 gaps of 0.1 mm.
  // The round ends of [Guacheta2021, algorithm 4-1] leave little corners open where the diagonal cuts lines
  // off.
  for (const SurfaceFillSettings& settings : {byCode(), asTheSource()}) {
    const double little = settings.pieces == FacePieces::Near ? 0.01 : 0.3;
    EXPECT_NEAR(fill(linesEvery(0.5, 0.25), levelFace(), settings).under_fill_mm2, 20.0, 0.3);
    EXPECT_NEAR(fill(linesEvery(0.4, 0.2), levelFace(), settings).under_fill_mm2, 0.0, little);
    EXPECT_NEAR(fill(linesEvery(0.35, 0.175), levelFace(), settings).under_fill_mm2, 0.0, little);
  }
}

TEST(SurfaceFill, OfLinesTooNearIsTheirOverlap) {
  // 29 lines overlap in 28 strips of 0.05 mm.
  EXPECT_NEAR(fill(linesEvery(0.5, 0.25), levelFace(), byCode()).over_fill_mm2, 0.0, 1e-6);
  EXPECT_NEAR(fill(linesEvery(0.4, 0.2), levelFace(), byCode()).over_fill_mm2, 0.0, 1e-6);
  EXPECT_NEAR(fill(linesEvery(0.35, 0.175), levelFace(), byCode()).over_fill_mm2, 28 * 0.05 * kSide, 0.05);
}

TEST(SurfaceFill, JoinedSegmentsOverlapAsInTheSourceOrNotAtAll) {
  // Round a right angle two bands of 0.4 mm share a square of 0.2 mm and three quarters of a disc.
  Path corner = test::straightPath({2, 1, 0}, {6, 1, 0});
  corner.points.emplace_back(6, 4, 0);
  const Toolpath toolpath{"corner", {{0.0, 0.2, {corner}}}};
  EXPECT_NEAR(fill(toolpath, levelFace()).over_fill_mm2, 0.0, 1e-9);
  EXPECT_NEAR(fill(toolpath, levelFace(), asTheSource()).over_fill_mm2, 0.04 * (1.0 + 0.75 * M_PI), 0.002);
}

TEST(SurfaceFill, OnUprightFacesABeadIsAsWideAsItIsHigh) {
  EXPECT_NEAR(fill(layersEvery(0.2), uprightFace()).under_fill_mm2, 0.0, 0.01);
  EXPECT_NEAR(fill(layersEvery(0.4), uprightFace()).under_fill_mm2, 50.0, 0.3);
}

TEST(SurfaceFill, WidthsAreThoseOfTheSourcesCodeItsTextOrTheBead) {
  const Toolpath lines = linesEvery(0.5, 0.25);
  SurfaceFillSettings settings = byCode();
  settings.width = SurfaceWidth::Text;
  EXPECT_NEAR(fill(lines, levelFace(), settings).under_fill_mm2, 20 * 0.15 * kSide, 0.2);
  settings.width = SurfaceWidth::Bead;
  const Bead bead = lines.layers[0].paths[0].bead.at(0);
  EXPECT_NEAR(fill(lines, levelFace(), settings).under_fill_mm2, 20 * (0.5 - planWidth(bead)) * kSide, 0.2);
  EXPECT_NEAR(fill(layersEvery(0.4), uprightFace(), settings).under_fill_mm2,
              25 * (0.4 - bead.height_mm) * kSide, 0.3);
}

TEST(SurfaceFill, ABeadRoundACornerCoversTheUprightFacesToTheirEdges) {
  // Loops half a plan width inside a block, as walls run.
  Toolpath loops{"loops", {}};
  for (double z = 0.2; z < kSide + 1e-6; z += 0.2) {
    Path loop = test::straightPath({0, 0, z}, {0, 0, z});
    const double inset = 0.5 * planWidth(loop.bead.at(0));
    loop.points = {
        {inset, inset, z}, {kSide - inset, inset, z}, {kSide - inset, kSide, z}, {inset, kSide, z}};
    loop.is_closed = true;
    loops.layers.push_back({z, 0.2, {loop}});
  }
  // What is left open are the corners of the bands' round ends, two of each layer.
  const double round_ends = 2 * 50 * (0.2 * 0.1 - 0.5 * M_PI * 0.01);
  const double short_ends = 2 * (0.5 * planWidth({0.4, 0.2}) - 0.1) * kSide;
  EXPECT_NEAR(fill(loops, uprightFace()).under_fill_mm2, round_ends, 0.02);
  EXPECT_NEAR(fill(loops, uprightFace(), byCode()).under_fill_mm2, round_ends + short_ends, 0.02);
}

TEST(SurfaceFill, OnlyWhatLiesWithinTheDepthCounts) {
  Toolpath deep = linesEvery(0.4, 0.2);
  for (Path& path : deep.layers[0].paths)
    for (Point3& point : path.points) point.z() = -0.16;  // its middle 0.26 mm below the face
  EXPECT_NEAR(fill(deep, levelFace(), byCode()).under_fill_mm2, kSide * kSide, 1e-9);
  EXPECT_FALSE(fill(deep, levelFace(), byCode()).faces[0].has_path);
  SurfaceFillSettings deeper = byCode();
  deeper.depth_mm = 0.27;
  EXPECT_NEAR(fill(deep, levelFace(), deeper).under_fill_mm2, 0.0, 0.01);
}

TEST(SurfaceFill, WhatLiesAboveTheFaceIsNotOnIt) {
  Toolpath above = linesEvery(0.4, 0.2);
  for (Path& path : above.layers[0].paths)
    for (Point3& point : path.points) point.z() = 0.11;
  EXPECT_NEAR(fill(above, levelFace()).under_fill_mm2, kSide * kSide, 1e-9);
}

TEST(SurfaceFill, FacesWithoutAPathCountOrAreSkipped) {
  Mesh part = levelFace();
  for (const Point3& vertex : levelFace().vertices) part.vertices.emplace_back(vertex + Point3(50, 0, 0));
  part.triangles.push_back({4, 5, 6});
  const SurfaceFill counted = fill(linesEvery(0.4, 0.2), part, byCode());
  EXPECT_NEAR(counted.under_fill_mm2, 50.0, 0.01);
  EXPECT_NEAR(counted.faces[2].under_fill_mm2, 50.0, 1e-9);
  SurfaceFillSettings settings = byCode();
  settings.uncovered = UncoveredFaces::Skip;
  EXPECT_NEAR(fill(linesEvery(0.4, 0.2), part, settings).under_fill_mm2, 0.0, 0.01);
}

TEST(SurfaceFill, TravelsCoverNothing) {
  Toolpath travels = linesEvery(0.4, 0.2);
  for (Path& path : travels.layers[0].paths) path.role = PathRole::Travel;
  EXPECT_NEAR(fill(travels, levelFace()).under_fill_mm2, kSide * kSide, 1e-9);
}

TEST(SurfaceFill, DropsCoverDiscs) {
  Path drops = test::straightPath({2.05, 1.1, 0}, {7.05, 1.1, 0});
  drops.deposit = Deposit::Drops;
  const SurfaceFill filled = fill({"drops", {{0.0, 0.2, {drops}}}}, levelFace());
  EXPECT_NEAR(filled.under_fill_mm2, kSide * kSide - 2 * M_PI * 0.04, 0.002);
}

TEST(SurfaceFill, DoesNotDependOnHowAFaceIsDivided) {
  Mesh fine;
  const int parts = 20;
  for (int j = 0; j <= parts; ++j)
    for (int i = 0; i <= parts; ++i) fine.vertices.emplace_back(kSide * i / parts, kSide * j / parts, 0.0);
  for (std::uint32_t j = 0; j < parts; ++j)
    for (std::uint32_t i = 0; i < parts; ++i) {
      const std::uint32_t at = j * (parts + 1) + i;
      fine.triangles.push_back({at, at + 1, at + parts + 2});
      fine.triangles.push_back({at, at + parts + 2, at + parts + 1});
    }
  for (const double pitch : {0.33, 0.47}) {
    const SurfaceFill coarse = fill(linesEvery(pitch, 0.1), levelFace());
    const SurfaceFill divided = fill(linesEvery(pitch, 0.1), fine);
    EXPECT_NEAR(divided.under_fill_mm2, coarse.under_fill_mm2, 0.1);
    EXPECT_NEAR(divided.over_fill_mm2, coarse.over_fill_mm2, 0.1);
  }
}

TEST(SurfaceFill, SegmentsOfALineAreTheLine) {
  Toolpath whole = linesEvery(0.35, 0.175);
  Toolpath divided = whole;
  for (Path& path : divided.layers[0].paths) {
    const double y = path.points[0].y();
    path.points.clear();
    for (int i = 0; i <= 100; ++i) path.points.emplace_back(kSide * i / 100, y, 0.0);
  }
  for (const SurfaceFillSettings& settings : {SurfaceFillSettings(), asTheSource()}) {
    const SurfaceFill expected = fill(whole, levelFace(), settings);
    const SurfaceFill found = fill(divided, levelFace(), settings);
    EXPECT_NEAR(found.under_fill_mm2, expected.under_fill_mm2, 1e-6);
    EXPECT_NEAR(found.over_fill_mm2, expected.over_fill_mm2, 1e-6);
  }
}

/// A run of beads at random places right below the upper face of a box.
Toolpath scribble(std::uint64_t seed) {
  Random random(seed);
  Path path = test::straightPath({0, 0, 0}, {1, 0, 0});
  path.points.clear();
  for (int i = 0; i < 40; ++i)
    path.points.emplace_back(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(9.7, 10.0));
  return {"scribble", {{10.0, 0.2, {path}}}};
}

Mesh box() { return makePart("box", {{"x_mm", "10"}, {"y_mm", "10"}, {"z_mm", "10"}}); }

TEST(SurfaceFill, IsTheSameInAnyFrame) {
  EXPECT_TRUE(rc::check("turning and moving part and toolpath together changes nothing", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    Random random(seed);
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    moved.linear() = (Eigen::AngleAxisd(random.uniform(-3, 3), Point3::UnitX()) *
                      Eigen::AngleAxisd(random.uniform(-3, 3), Point3::UnitZ()))
                         .toRotationMatrix();
    moved.translation() = Point3(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50));
    Mesh part = box();
    for (Point3& vertex : part.vertices) vertex = moved * vertex;
    const SurfaceFill before = fill(scribble(seed), box());
    const SurfaceFill after = fill(placed(scribble(seed), moved), part, {}, moved.inverse());
    RC_ASSERT(std::abs(before.under_fill_mm2 - after.under_fill_mm2) < 1e-3);
    RC_ASSERT(std::abs(before.over_fill_mm2 - after.over_fill_mm2) < 1e-3);
  }));
}

TEST(SurfaceFill, MoreBeadsNeverLeaveMoreOpen) {
  EXPECT_TRUE(rc::check("adding a run takes nothing from what is covered", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    Toolpath more = scribble(seed);
    more.layers.push_back(scribble(seed + 1ULL).layers[0]);
    const SurfaceFill less = fill(scribble(seed), box());
    const SurfaceFill all = fill(more, box());
    RC_ASSERT(all.under_fill_mm2 <= less.under_fill_mm2 + 1e-9);
    RC_ASSERT(all.over_fill_mm2 >= less.over_fill_mm2 - 1e-9);
    for (const FaceFill& face : all.faces) {
      RC_ASSERT(face.under_fill_mm2 >= -1e-9 && face.under_fill_mm2 <= face.area_mm2 + 1e-9);
      RC_ASSERT(face.over_fill_mm2 >= 0.0);
    }
  }));
}

TEST(SurfaceFill, IsTheSameOnOneThread) {
  const SurfaceFill many = fill(scribble(7), box());
  const ThreadLimit limit(1);
  const SurfaceFill one = fill(scribble(7), box());
  EXPECT_EQ(one.under_fill_mm2, many.under_fill_mm2);
  EXPECT_EQ(one.over_fill_mm2, many.over_fill_mm2);
}

}  // namespace
}  // namespace lamina
