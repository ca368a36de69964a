// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/conformal/conformal_layers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/curved_parts.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

ConformalLayers coat(const Mesh& mesh, const ConformalSettings& settings, double height) {
  NoProgress progress;
  return coatingLayers(mesh, settings, height, progress);
}

Mesh raised(Mesh mesh, double by_mm) {
  for (Point3& vertex : mesh.vertices) vertex.z() += by_mm;
  return mesh;
}

TEST(ConformalLayers, ACoatOnASphereIsOfEqualLayersOfTheThickness) {
  ConformalSettings settings;
  settings.thickness_mm = 1.0;
  const ConformalLayers layers = coat(makePart("sphere", {{"radius_mm", "7"}}), settings, 0.3);
  ASSERT_EQ(layers.layers.size(), 4U);
  EXPECT_NEAR(layers.layer_height_mm, 0.25, 1e-12);
  for (std::size_t i = 0; i < 4; ++i) {
    const double radius = 7.125 + 0.25 * static_cast<double>(i);
    for (const Point3& p : layers.layers[i].middle.vertices) {
      ASSERT_NEAR((p - Point3(0.0, 0.0, 7.0)).norm(), radius, 0.01);
      ASSERT_GT(p.z() - 7.0, radius * std::cos(63.0 * M_PI / 180.0));
    }
  }
}

TEST(ConformalLayers, ACoatLooksWhereItIsReportedTo) {
  ConformalSettings settings;
  settings.direction = {1.0, 0.0, 0.0};
  const ConformalLayers layers = coat(makePart("box"), settings, 0.5);
  ASSERT_EQ(layers.layers.size(), 2U);
  for (const Point3& p : layers.layers[0].middle.vertices) EXPECT_NEAR(p.x(), 10.25, 1e-9);
  for (const Point3& p : layers.layers[1].tip) EXPECT_NEAR(p.x(), 11.0, 1e-9);
  EXPECT_NEAR(layers.deposited_mm3, 400.0, 1e-6);
}

TEST(ConformalLayers, AreCancelledWhileFacesAreChosen) {
  class AlwaysCancelled final : public Progress {
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return true; }
  } stopped;
  try {
    coatingLayers(makePart("sphere"), {}, 0.3, stopped);
    FAIL() << "not cancelled";
  } catch (const Cancelled& cancelled) {
    EXPECT_STREQ(cancelled.what(), "cancelled during choose faces");
  }
}

TEST(ConformalLayers, WhatLiesBelowOtherMaterialGetsNoCoat) {
  ConformalSettings settings;
  // A plate over half of a block: of the block's top, half is open.
  const Mesh block = test::boxBetween({0, 0, 0}, {20, 10, 5});
  const ConformalLayers roofed = coat(joined(block, test::boxBetween({0, 0, 8}, {10, 10, 9})), settings, 0.5);
  const double across_mm2 = 10.0 * settings.longest_edge_mm;  // of faces across the plate's edge
  EXPECT_GE(roofed.hidden_mm2, 100.0 - 1e-6);
  EXPECT_LE(roofed.hidden_mm2, 100.0 + across_mm2);
  EXPECT_NEAR(roofed.deposited_mm3, 300.0 - roofed.hidden_mm2, 1e-6);
  // Bodies that overlap: the top of the lower one, within the higher one, is inside.
  const ConformalLayers overlapping =
      coat(joined(block, test::boxBetween({-5, 0, 0}, {10, 10, 9})), settings, 0.5);
  EXPECT_GE(overlapping.hidden_mm2, 100.0 - 1e-6);
  EXPECT_LE(overlapping.hidden_mm2, 100.0 + across_mm2);
  EXPECT_NEAR(overlapping.deposited_mm3, 350.0 - overlapping.hidden_mm2, 1e-6);
}

TEST(ConformalLayers, FacesThatAreHiddenInPartAreCoatedUpToThere) {
  ConformalSettings settings;
  settings.longest_edge_mm = 0.5;
  const Mesh table = joined(test::boxBetween({0, 0, 0}, {20, 10, 5}), test::boxBetween({3, 3, 8}, {7, 7, 9}));
  const ConformalLayers layers = coat(table, settings, 0.5);
  // 16 mm2 lie below the plate; of the faces across its edge, as wide as they are long, none is coated.
  EXPECT_GE(layers.hidden_mm2, 16.0);
  EXPECT_LE(layers.hidden_mm2, 16.0 + 4.0 * 5.0 * 0.5);
  EXPECT_NEAR(layers.deposited_mm3, 216.0 - layers.hidden_mm2, 1e-6);
}

TEST(ConformalLayers, APartWhoseFacesAreAllHiddenIsRefused) {
  ConformalSettings settings;
  settings.direction = {1.0, 0.0, 0.0};
  settings.max_tilt_deg = 10.0;
  Mesh wall = test::boxBetween({0, 0, 0}, {1, 10, 10});
  // Only the inner body's face looks that way when the outer one leans.
  Mesh hood = test::boxBetween({2, -5, -5}, {3, 15, 15});
  for (Point3& vertex : hood.vertices)
    if (vertex.x() > 2.5) vertex.x() += 0.5 * (vertex.z() + 5.0);
  EXPECT_THROW(coat(joined(wall, hood), settings, 0.5), Unsliceable);
}

TEST(ConformalLayers, WhereNoFaceLooksThatWayItIsRefused) {
  ConformalSettings settings;
  settings.max_tilt_deg = 10.0;
  settings.direction = {1.0, 0.0, 1.0};
  EXPECT_THROW(coat(makePart("box"), settings, 0.5), Unsliceable);
  settings.direction = {0.0, 0.0, 0.0};
  EXPECT_THROW(coat(makePart("box"), settings, 0.5), InvalidConfig);
}

TEST(ConformalLayers, APartOnALevelBaseIsCutAtItsOwnSurface) {
  NoProgress progress;
  const Mesh base = makePart("box", {{"x_mm", "40"}, {"y_mm", "40"}});
  const Mesh part = raised(makePart("cylinder", {{"radius_mm", "5"}, {"height_mm", "4"}}), 20.0);
  const ConformalLayers layers = layersOnBase(part, base, {}, 0.5, progress);
  ASSERT_EQ(layers.layers.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i)
    for (const Point3& p : layers.layers[i].middle.vertices) {
      EXPECT_NEAR(p.z(), 20.25 + 0.5 * static_cast<double>(i), 1e-9);
      EXPECT_LT(std::hypot(p.x(), p.y()), 5.03);
    }
  EXPECT_NEAR(layers.deposited_mm3, layers.part_mm3, 0.01 * layers.part_mm3);
}

TEST(ConformalLayers, APartOnACurvedBaseFollowsIt) {
  NoProgress progress;
  const Mesh base = test::gridSurface(60, [](double u, double v) {
    const double x = -12.0 + 24.0 * u;
    return Point3(x, -2.0 + 14.0 * v, std::sqrt(400.0 - x * x));
  });
  const ConformalLayers layers = layersOnBase(test::bentPlate(), base, {}, 0.2, progress);
  ASSERT_EQ(layers.layers.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i)
    for (const Point3& p : layers.layers[i].middle.vertices)
      ASSERT_NEAR(std::hypot(p.x(), p.z()), 20.1 + 0.2 * static_cast<double>(i), 0.02);
  EXPECT_NEAR(layers.deposited_mm3, layers.part_mm3, 0.01 * layers.part_mm3);
}

TEST(ConformalLayers, APartBeyondItsBaseIsRefusedWithTheRegion) {
  NoProgress progress;
  const Mesh base = makePart("box", {{"x_mm", "5"}, {"y_mm", "40"}});
  const Mesh part = raised(makePart("box", {{"x_mm", "20"}, {"z_mm", "4"}}), 20.0);
  try {
    layersOnBase(part, base, {}, 0.5, progress);
    FAIL() << "was not refused";
  } catch (const Unsliceable& refusal) {
    ASSERT_FALSE(refusal.region().triangles.empty());
    EXPECT_GT(boundingBox(refusal.region()).high.x(), boundingBox(base).high.x()) << refusal.what();
  }
}

}  // namespace
}  // namespace lamina
