// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/volumetric_layers.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "support/grown_parts.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

VolumetricRequest usualRequest(double cell_mm = 0.5) {
  VolumetricRequest request;
  request.settings.cell_mm = cell_mm;
  return request;
}

VolumetricLayers grownLayers(const Mesh& mesh, const VolumetricRequest& request = usualRequest()) {
  NoProgress progress;
  return volumetricLayers(mesh, pairHalfEdges(mesh), request, progress);
}

double volumeFilledBy(const std::vector<VolumetricLayer>& layers) {
  double sum = 0.0;
  for (const VolumetricLayer& layer : layers)
    sum += layer.isLevel() ? signedArea(layer.plane.section.contours) * layer.plane.bounds.height()
                           : volume(layer.surface);
  return sum;
}

// A rod that bends over by 70 deg: layers across it tilt nearly as much, those that only support less.
TEST(VolumetricLayers, LieAcrossABentRodIfAskedTo) {
  const Mesh rod = makePart(
      "elbow", {{"radius_mm", "5"}, {"bend_radius_mm", "24"}, {"foot_mm", "4"}, {"angle_deg", "70"}});
  VolumetricRequest request = usualRequest();
  EXPECT_LT(grownLayers(rod, request).measures.tilt_deg, 40.0);
  request.settings.target = GrowthTarget::Tangent;
  const VolumetricLayers across = grownLayers(rod, request);
  EXPECT_EQ(across.measures.fitted, 1.0) << across.measures.fit_loss;
  EXPECT_NEAR(across.measures.tilt_deg, 68.0, 3.0);
  EXPECT_LT(across.measures.unsupported_mm2, 1e-3 * across.measures.surface_mm2);
  EXPECT_NEAR(volumeFilledBy(across.layers), volume(rod), 0.02 * volume(rod));
}

// Of a cylinder that leans, on its elliptic foot: no surface overhangs them.
TEST(VolumetricLayers, LieAcrossALeaningCylinderFromItsFootOnIfTheFootIsFree) {
  Mesh cylinder = makePart("cylinder", {{"radius_mm", "6"}, {"height_mm", "8"}, {"segments", "128"}});
  for (Point3& vertex : cylinder.vertices) vertex.x() += vertex.z();
  VolumetricRequest request = usualRequest();
  request.settings.target = GrowthTarget::Given;
  request.settings.foot = GrowthFoot::Free;
  request.directions = {{Point3::Zero(), Point3(1.0, 0.0, 1.0).normalized()}};
  const VolumetricLayers across = grownLayers(cylinder, request);
  EXPECT_EQ(across.measures.fitted, 1.0) << across.measures.fit_loss;
  EXPECT_NEAR(across.measures.tilt_deg, 45.0, 0.5);
  EXPECT_LT(across.measures.unsupported_mm2, 1e-3 * across.measures.surface_mm2);
  EXPECT_NEAR(volumeFilledBy(across.layers), volume(cylinder), 0.02 * volume(cylinder));
}

// The cube root of 216 mm³ over half a million is far less.
TEST(VolumetricLayers, OfASmallPartGrowInCellsOfTwoThirdsOfABead) {
  VolumetricRequest request = usualRequest(0.0);
  request.bead_mm = 0.9;
  EXPECT_NEAR(grownLayers(test::boxBetween({0, 0, 0}, {6, 6, 6}), request).measures.cell_mm, 0.6, 1e-12);
}

TEST(VolumetricLayers, HaveNoFreeFootWhereNothingIsFitted) {
  VolumetricSettings settings;
  settings.foot = GrowthFoot::Free;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings.target = GrowthTarget::Smooth;
  EXPECT_NO_THROW(requireConsistent(settings));
}

// Layers across a bend of 2 mm about a rod of 4 mm would be far thicker outside than inside.
TEST(VolumetricLayers, SayWhyAFitIsNotTaken) {
  const Mesh rod =
      makePart("elbow", {{"radius_mm", "4"}, {"bend_radius_mm", "5"}, {"foot_mm", "4"}, {"angle_deg", "60"}});
  VolumetricRequest request = usualRequest();
  request.settings.target = GrowthTarget::Tangent;
  const VolumetricMeasures measures = grownLayers(rod, request).measures;
  EXPECT_LT(measures.fitted, 1.0);
  EXPECT_NE(measures.fit_loss.find("beyond the bounds of thickness"), std::string::npos) << measures.fit_loss;
}

// A part that needs none of it gets what `planar` gives.
TEST(VolumetricLayers, OfABoxAreExactlyLevel) {
  const Mesh box = test::boxBetween({-5, -4, 0}, {5, 4, 6.1});
  const VolumetricLayers layers = grownLayers(box);
  const std::vector<LayerBounds> planar = stackLayers(0.0, 6.1, {});
  ASSERT_EQ(layers.layers.size(), planar.size());
  for (std::size_t i = 0; i < planar.size(); ++i) {
    EXPECT_TRUE(layers.layers[i].isLevel());
    EXPECT_EQ(layers.layers[i].plane.bounds.bottom_mm, planar[i].bottom_mm);
    EXPECT_EQ(layers.layers[i].plane.bounds.top_mm, planar[i].top_mm);
    EXPECT_NEAR(signedArea(layers.layers[i].plane.section.contours), 80.0, 1e-9);
  }
  EXPECT_EQ(layers.measures.level_layers, planar.size());
  EXPECT_EQ(layers.measures.unsupported_mm2, 0.0);
  EXPECT_EQ(layers.measures.tilt_deg, 0.0);
}

TEST(VolumetricLayers, OfAnOpeningFrustumLeaveNoOverhang) {
  const VolumetricLayers layers = grownLayers(test::openingFrustum(60.0, 8.0));
  const VolumetricMeasures& measures = layers.measures;
  // The wall as a whole hangs over level layers; some of it next to the rim may over these.
  EXPECT_GT(measures.unsupported_level_mm2, 0.3 * measures.surface_mm2);
  EXPECT_LT(measures.unsupported_mm2, 0.005 * measures.surface_mm2);
  EXPECT_NEAR(measures.tilt_deg, 35.0, 2.0);
  EXPECT_EQ(measures.minima, 0U);
  EXPECT_EQ(measures.pendant_mm3, 0.0);
  EXPECT_LT(measures.open, 0.02);
  EXPECT_LT(measures.twice, 0.01);
  EXPECT_GT(measures.least_resting, 0.9);
}

// Level layers that end half way up leave a triangle of half a height by what the wall leans on it. Of 20 000
// samples 97 are in one, by chance 10 more or fewer.
TEST(VolumetricLayers, SayWhatLevelLayersLeaveOpen) {
  const double lean = std::tan(toRadians(60.0));
  const Mesh frustum = test::openingFrustum(60.0, 8.0);
  const double triangle_mm2 = 0.5 * 0.1 * 0.1 * lean;
  const double around_mm = 2.0 * M_PI * (10.0 + 4.0 * lean);
  const double expected = 40.0 * triangle_mm2 * around_mm / volume(frustum);
  EXPECT_NEAR(grownLayers(frustum).measures.open_level, expected, 0.0015);
}

TEST(VolumetricLayers, FillThePart) {
  const Mesh part = test::tShape();
  const VolumetricLayers layers = grownLayers(part);
  EXPECT_NEAR(volumeFilledBy(layers.layers), volume(part), 0.015 * volume(part));
  EXPECT_LT(layers.measures.open, 0.02);
  EXPECT_LT(layers.measures.twice, 0.01);
}

// About the edge of the stem: layer k in the arms is where s / r of the lean is k heights.
TEST(VolumetricLayers, OfATFanOutAboutItsEdges) {
  const VolumetricLayers layers = grownLayers(test::tShape());
  std::size_t bent = 0;
  for (const VolumetricLayer& layer : layers.layers) {
    if (layer.isLevel()) {
      EXPECT_LT(layer.plane.bounds.top_mm, 20.7);
      continue;
    }
    ++bent;
    const LayerSurface& surface = layer.surface;
    for (std::size_t i = 0; i < surface.middle.vertices.size(); ++i) {
      const Point3& place = surface.middle.vertices[i];
      EXPECT_NEAR(surface.normal[i].norm(), 1.0, 1e-9);
      EXPECT_GT(surface.height_mm[i], 0.2 - 1e-9);
      EXPECT_LT(surface.height_mm[i], 0.4 + 1e-9);
      const double beyond = std::abs(place.x()) - 6.0;
      if (beyond < 3.0 || place.z() < 20.0) continue;
      const double lean_deg = toDegrees(std::atan2(beyond, place.z() - 20.0));
      const double tilt_deg = toDegrees(std::acos(surface.normal[i].z()));
      EXPECT_NEAR(tilt_deg, std::max(0.0, lean_deg - 25.0), 8.0);
    }
  }
  EXPECT_GT(bent, 20U);
}

TEST(VolumetricLayers, FaceTheNozzle) {
  const VolumetricLayers layers = grownLayers(test::openingFrustum(60.0, 6.0));
  ASSERT_FALSE(layers.layers.empty());
  for (const VolumetricLayer& layer : layers.layers)
    for (const Triangle& corner : layer.surface.middle.triangles) {
      const std::vector<Point3>& at = layer.surface.middle.vertices;
      const Point3 across = (at[corner[1]] - at[corner[0]]).cross(at[corner[2]] - at[corner[0]]);
      if (across.norm() < 1e-4) continue;
      EXPECT_GT(across.normalized().dot(layer.surface.normal[corner[0]]), 0.5);
    }
}

TEST(VolumetricLayers, AreTheSameForAnyNumberOfThreads) {
  const Mesh part = test::tShape();
  const VolumetricLayers many = grownLayers(part);
  const ThreadLimit limit(1);
  const VolumetricLayers one = grownLayers(part);
  ASSERT_EQ(many.layers.size(), one.layers.size());
  for (std::size_t i = 0; i < one.layers.size(); ++i) {
    EXPECT_EQ(many.layers[i].surface.middle.vertices, one.layers[i].surface.middle.vertices);
    EXPECT_EQ(many.layers[i].surface.middle.triangles, one.layers[i].surface.middle.triangles);
    EXPECT_EQ(many.layers[i].surface.height_mm, one.layers[i].surface.height_mm);
  }
}

/// Two feet 6 mm wide and 20 mm apart, and 10 mm of lintel on them, 8 mm above the bed.
Mesh portal() {
  return test::lyingPrism(
      {{{-16, 0}, {-10, 0}, {-10, 8}, {10, 8}, {10, 0}, {16, 0}, {16, 18}, {-16, 18}}, {}}, 8.0);
}

/// A nozzle whose shaft fills a cone of 31 deg, and a head above it.
std::vector<HeadStage> usualHead() { return {{0.0, 25.0, 3.0}, {25.0, 100.0, 30.0}}; }

// Fronts that are tilted by 65 deg leave a valley of 50 deg, into which no cone of 62 deg goes.
TEST(VolumetricLayers, UseMoreOverhangWhereTheHeadHasNoRoomBetweenFronts) {
  VolumetricRequest request = usualRequest(0.6);
  EXPECT_NEAR(grownLayers(portal(), request).measures.overhang_used_deg, 25.0, 1e-9) << "there is no head";
  request.head = usualHead();
  const VolumetricMeasures suited = grownLayers(portal(), request).measures;
  request.settings.overhang_used_deg = 25.0;
  const VolumetricMeasures asked = grownLayers(portal(), request).measures;
  EXPECT_NEAR(asked.overhang_used_deg, 25.0, 1e-9);
  EXPECT_GT(asked.shut, 0.01);
  EXPECT_GE(suited.overhang_used_deg, 27.5 - 1e-9);
  EXPECT_LE(suited.shut, 0.006);
  EXPECT_LE(suited.unsupported_mm2, 0.05 * suited.surface_mm2);
}

// Cells of 2 mm cost so much in angle that the undersides of the bar are not supported.
TEST(VolumetricLayers, UseLessOverhangWhereMuchIsLeftUnsupported) {
  VolumetricRequest request = usualRequest(2.0);
  const VolumetricMeasures suited = grownLayers(test::tShape(), request).measures;
  request.settings.overhang_used_deg = 25.0;
  const VolumetricMeasures asked = grownLayers(test::tShape(), request).measures;
  EXPECT_GT(asked.unsupported_mm2, 0.02 * asked.surface_mm2);
  EXPECT_LT(suited.overhang_used_deg, 25.0);
  EXPECT_LT(suited.unsupported_mm2, asked.unsupported_mm2);
}

/// The message of the refusal of a part, or nothing.
std::string refusalOf(const Mesh& mesh, const VolumetricRequest& request = usualRequest()) {
  try {
    grownLayers(mesh, request);
  } catch (const Unsliceable& refusal) {
    EXPECT_FALSE(refusal.region().triangles.empty());
    return refusal.what();
  }
  return "";
}

/// That a refusal names a place in a frustum that opens by 60 deg, 6 mm high.
void expectInFrustum(const std::string& refusal, const std::string& before) {
  const std::size_t at = refusal.find(before);
  ASSERT_NE(at, std::string::npos) << refusal;
  double x = 0.0, y = 0.0, z = 0.0;
  ASSERT_EQ(std::sscanf(refusal.c_str() + at + before.size(), "%lf, %lf, %lf) mm", &x, &y, &z), 3) << refusal;
  EXPECT_GE(z, 0.0) << refusal;
  EXPECT_LE(z, 6.0) << refusal;
  EXPECT_LE(std::hypot(x, y), 10.0 + z * std::sqrt(3.0) + 0.1) << refusal;
}

TEST(VolumetricLayers, RefuseWhatDoesNotStand) {
  // A tip on the bed.
  const std::string refusal =
      refusalOf(makePart("cone", {{"radius_mm", "0.01"}, {"top_radius_mm", "8"}, {"height_mm", "8"}}));
  EXPECT_NE(refusal.find("touches the bed"), std::string::npos) << refusal;
  VolumetricRequest sunk = usualRequest();
  sunk.settings.sink_mm = 2.0;
  sunk.settings.max_overhang_deg = 60.0;
  EXPECT_EQ(
      refusalOf(makePart("cone", {{"radius_mm", "0.01"}, {"top_radius_mm", "8"}, {"height_mm", "8"}}), sunk),
      "");
}

Mesh hook() {
  return test::lyingPrism({{{0, 0}, {8, 0}, {8, 20}, {18, 20}, {18, 8}, {24, 8}, {24, 26}, {0, 26}}, {}},
                          6.0);
}

TEST(VolumetricLayers, RefuseWhatHangsLowerThanGrowthComes) {
  const std::string refusal = refusalOf(hook());
  EXPECT_NE(refusal.find("hang lower than growth comes"), std::string::npos) << refusal;
  // The tip of the hook: 6 x 6 x 12 mm of it look down at z = 8, from x = 18 to 24.
  EXPECT_NE(refusal.find("volumetric.largest_pendant_percent"), std::string::npos) << refusal;
  double x = 0.0, z = 0.0;
  const std::size_t at = refusal.find("the lowest at (");
  ASSERT_NE(at, std::string::npos) << refusal;
  ASSERT_EQ(std::sscanf(refusal.c_str() + at, "the lowest at (%lf, %*f, %lf) mm", &x, &z), 2) << refusal;
  EXPECT_GT(x, 18.0);
  EXPECT_LT(x, 24.0);
  EXPECT_NEAR(z, 8.0, 0.5);
}

TEST(VolumetricLayers, RefuseWhatStaysUnsupported) {
  VolumetricRequest request = usualRequest();
  request.settings.max_overhang_deg = 20.0;
  request.settings.overhang_used_deg = 20.0;
  request.settings.max_tilt_deg = 5.0;
  request.settings.largest_pendant_percent = 100.0;
  request.settings.largest_unsupported_percent = 1.0;
  const std::string refusal = refusalOf(test::openingFrustum(50.0, 6.0), request);
  EXPECT_NE(refusal.find("overhang by more than 20 deg"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("most of it at ("), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("expected at most 1 %"), std::string::npos) << refusal;
}

// With one thickness allowed, rounding to bits and bends at the foot's edge leave some of it thicker or
// thinner.
TEST(VolumetricLayers, RefuseThicknessBeyondItsBounds) {
  VolumetricRequest request = usualRequest();
  request.settings.max_thickness = 1.0;
  const std::string refusal = refusalOf(test::openingFrustum(60.0, 6.0), request);
  EXPECT_NE(refusal.find("outside 0.200 to 0.200 mm in "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("expected at most 0.5 % (volumetric.largest_uneven_percent)"), std::string::npos)
      << refusal;
  expectInFrustum(refusal, "farthest at (");
  request.settings.largest_uneven_percent = 5.0;
  EXPECT_EQ(refusalOf(test::openingFrustum(60.0, 6.0), request), "");
}

// Layers in coarse cells end in the air before the wall.
TEST(VolumetricLayers, RefuseWhatLayersLeaveOpen) {
  VolumetricRequest request = usualRequest(0.8);
  request.settings.largest_uncovered_percent = 1.0;
  const std::string refusal = refusalOf(test::openingFrustum(60.0, 6.0), request);
  EXPECT_NE(refusal.find("(0.52 % in none of level layers)"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("expected at most 1 % beyond level layers (volumetric.largest_uncovered_percent)"),
            std::string::npos)
      << refusal;
  expectInFrustum(refusal, "most of it around (");
  EXPECT_EQ(refusalOf(test::openingFrustum(60.0, 6.0), usualRequest(0.8)), "");
}

// What hangs from the hook is in no layer, as allowed; the place is where layers leave open what they reach.
TEST(VolumetricLayers, ThePlaceLeftOpenIsNotThatOfAPendant) {
  VolumetricRequest request = usualRequest(0.8);
  request.settings.largest_pendant_percent = 100.0;
  request.settings.largest_unsupported_percent = 100.0;
  request.settings.largest_uneven_percent = 100.0;
  request.settings.largest_uncovered_percent = 0.0;
  const std::string refusal = refusalOf(hook(), request);
  double x = 0.0, z = 0.0, pendant = 0.0;
  const std::size_t hanging = refusal.find("level layers, ");
  ASSERT_NE(hanging, std::string::npos) << refusal;
  ASSERT_EQ(std::sscanf(refusal.c_str() + hanging, "level layers, %lf %% hang", &pendant), 1) << refusal;
  // Of 376 mm² of its outline 6 x 12 hang, of which growth reaches what is above a line 20 deg down from the
  // inner edge.
  EXPECT_NEAR(pendant, 100.0 * (72.0 - 18.0 * std::tan(toRadians(20.0))) / 376.0, 1.0);
  const std::size_t at = refusal.find("most of it around (");
  ASSERT_NE(at, std::string::npos) << refusal;
  ASSERT_EQ(std::sscanf(refusal.c_str() + at, "most of it around (%lf, %*f, %lf) mm", &x, &z), 2) << refusal;
  EXPECT_TRUE(x < 18.0 || z > 14.0) << refusal;
}

// A bar of 0.6 mm over a stem, in layers that tilt by 30 deg and are twice as thick as 0.4 mm there: the
// piece of a layer in the bar is 1.2 mm long, and hangs beyond the one before over more than half of it.
TEST(VolumetricLayers, RefuseAPieceThatRestsByLessThanHalf) {
  VolumetricRequest request = usualRequest(0.2);
  request.slicing.layer_height_mm = 0.4;
  request.slicing.first_layer_height_mm = 0.4;
  request.bead_mm = 0.2;
  request.settings.max_overhang_deg = 60.0;
  request.settings.overhang_used_deg = 60.0;
  request.settings.max_thickness = 4.0;
  request.settings.largest_pendant_percent = 100.0;
  request.settings.largest_unsupported_percent = 100.0;
  request.settings.largest_uneven_percent = 100.0;
  const Mesh bar = test::lyingPrism(
      {{{-2, 0}, {2, 0}, {2, 6}, {12, 6}, {12, 6.6}, {-12, 6.6}, {-12, 6}, {-2, 6}}, {}}, 6.0);
  const std::string refusal = refusalOf(bar, request);
  EXPECT_NE(refusal.find("rests on what is deposited before it by "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("expected at least 50 %"), std::string::npos) << refusal;
  double x = 0.0, z = 0.0, percent = 0.0;
  const std::size_t at = refusal.find(" at (");
  ASSERT_NE(at, std::string::npos) << refusal;
  ASSERT_EQ(
      std::sscanf(refusal.c_str() + at, " at (%lf, %*f, %lf) mm rests on what is deposited before it by %lf",
                  &x, &z, &percent),
      3)
      << refusal;
  EXPECT_LT(percent, 50.0);
  EXPECT_GT(std::abs(x), 2.0) << "in the bar";
  EXPECT_GE(z, 5.9) << "in the bar";
}

// Four pins that stand on 2 mm² in all, across which each layer has four pieces of 0.36 mm²: less than a
// bead's square each.
TEST(VolumetricLayers, RefuseAPartInWhichNoLayerHasRoomForABead) {
  Mesh pins;
  for (const double y : {0.0, 4.0, 8.0, 12.0}) {
    Mesh pin = makePart("cylinder", {{"radius_mm", "0.4"}, {"height_mm", "3"}, {"segments", "32"}});
    for (Point3& vertex : pin.vertices) vertex += Point3(vertex.z(), y, 0.0);
    pins = joined(std::move(pins), pin);
  }
  VolumetricRequest request = usualRequest(0.2);
  request.bead_mm = 0.9;
  request.settings.largest_uncovered_percent = 100.0;
  request.settings.target = GrowthTarget::Given;
  request.settings.foot = GrowthFoot::Free;
  request.directions = {{Point3::Zero(), Point3(1.0, 0.0, 1.0).normalized()}};
  try {
    grownLayers(pins, request);
    FAIL() << "no refusal";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "no layer of the part has room for a bead");
  }
}

TEST(VolumetricLayers, RefuseMeshesThatHoldNothing) {
  try {
    grownLayers(test::turnedInsideOut(test::boxBetween({0, 0, 0}, {4, 4, 4})));
    FAIL() << "no refusal";
  } catch (const InvalidMesh& error) {
    EXPECT_STREQ(error.what(), "the mesh holds -64 mm³; expected a positive volume");
  }
}

TEST(VolumetricLayers, RefuseMoreCellsThanMemoryHas) {
  try {
    grownLayers(test::boxBetween({0, 0, 0}, {100, 100, 100}), usualRequest(0.05));
    FAIL() << "no refusal";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("fill the part's box by 8000000000; expected at most"),
              std::string::npos)
        << error.what();
  }
}

TEST(VolumetricLayers, RefusePartsWithoutRoomForABead) {
  VolumetricRequest request = usualRequest(0.05);
  request.bead_mm = 2.0;
  EXPECT_NE(
      refusalOf(test::boxBetween({0, 0, 0}, {1, 1, 4}), request).find("expected at least a bead's square, 4"),
      std::string::npos);
}

TEST(VolumetricLayers, RefuseOpenMeshes) {
  Mesh box = test::boxBetween({0, 0, 0}, {4, 4, 4});
  box.triangles.pop_back();
  EXPECT_THROW(grownLayers(box), InvalidMesh);
}

}  // namespace
}  // namespace lamina
