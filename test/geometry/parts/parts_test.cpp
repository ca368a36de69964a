// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/parts/parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {
namespace {

/// Area of the polygon with n corners on a circle.
double polygonArea(double radius, int n) { return 0.5 * n * radius * radius * std::sin(2.0 * M_PI / n); }

class EveryPart : public testing::TestWithParam<std::string> {};

TEST_P(EveryPart, IsClosedAndFacesOutwards) {
  const Mesh mesh = makePart(GetParam());
  EXPECT_FALSE(pairHalfEdges(mesh).has_border);
  EXPECT_GT(volume(mesh), 0.0);
}

TEST_P(EveryPart, StandsOnThePlate) { EXPECT_NEAR(boundingBox(makePart(GetParam())).low.z(), 0.0, 1e-12); }

TEST_P(EveryPart, HasNoTriangleWithoutArea) {
  const Mesh mesh = makePart(GetParam());
  for (const Triangle& t : mesh.triangles) EXPECT_GT(surfaceArea({mesh.vertices, {t}}), 1e-9);
}

TEST_P(EveryPart, TakesItsOwnDefaults) {
  std::vector<SettingText> values;
  for (const PartParameter& parameter : partParameters(GetParam()))
    values.push_back({parameter.key, parameter.default_value});
  EXPECT_FALSE(values.empty());
  EXPECT_EQ(makePart(GetParam(), values).vertices, makePart(GetParam()).vertices);
}

/// The corners of a part with one parameter changed; none if that is refused.
std::vector<Point3> changedCorners(const std::string& name, const std::string& key, double value) {
  try {
    return makePart(name, {{key, std::to_string(std::lround(value))}}).vertices;
  } catch (const InvalidConfig&) {
    return {};
  }
}

TEST_P(EveryPart, ChangesWithEachParameter) {
  const std::vector<Point3> usual = makePart(GetParam()).vertices;
  for (const PartParameter& parameter : partParameters(GetParam())) {
    const double value = std::stod(parameter.default_value);
    std::vector<Point3> changed = changedCorners(GetParam(), parameter.key, 2.0 * value + 1.0);
    // Where bounds, or another parameter, leave no room above.
    if (changed.empty()) changed = changedCorners(GetParam(), parameter.key, 0.5 * value);
    EXPECT_FALSE(changed.empty()) << parameter.key;
    EXPECT_NE(changed, usual) << parameter.key;
  }
}

TEST_P(EveryPart, NamesItsParametersWhenAskedForAnother) {
  try {
    makePart(GetParam(), {{"colour", "3"}});
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find(partParameters(GetParam()).front().key), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, EveryPart, testing::ValuesIn(partNames()));

struct Truth {
  std::string name;
  std::vector<SettingText> parameters;
  double volume;
  double area;
};

class KnownPart : public testing::TestWithParam<Truth> {};

TEST_P(KnownPart, HasItsVolumeAndArea) {
  const Mesh mesh = makePart(GetParam().name, GetParam().parameters);
  EXPECT_NEAR(volume(mesh), GetParam().volume, 1e-9 * GetParam().volume);
  EXPECT_NEAR(surfaceArea(mesh), GetParam().area, 1e-9 * GetParam().area);
}

/// Perimeter of the polygon with n corners on a circle.
double polygonPerimeter(double radius, int n) { return 2.0 * n * radius * std::sin(M_PI / n); }

std::vector<Truth> truths() {
  const double ring = polygonArea(10, 60) - polygonArea(4, 60);
  const double hole = polygonArea(5, 40);
  // A side face of a cone over n corners is as high as its apothem and the height make it.
  const double slant = std::hypot(20.0, 10.0 * std::cos(M_PI / 60));
  const double edge = 10.0 * (std::sqrt(2.0) - 1.0);
  const double bevel = 5.0 - 0.5 * edge;
  return {
      // Two sides of a portal, and 20 mm along its outline.
      {"bridge",
       {},
       2 * 10.0 * 10 * 20 + 40.0 * 20 * 4,
       2 * (200.0 + 160) + 20 * (40 + 2 * 14 + 2 * 10 + 2 * 10 + 20.0)},
      // 723.85 mm3 and 434.31 mm2 [Guacheta2021, table 5-3].
      {"bevelled_cube",
       {},
       100.0 * edge + 2.0 / 3.0 * bevel * (100.0 + 10.0 * edge + edge * edge),
       2.0 * edge * edge + 4.0 * 10.0 * edge + 4.0 * (10.0 + edge) * edge},
      {"box", {{"x_mm", "2"}, {"y_mm", "3"}, {"z_mm", "4"}}, 24.0, 52.0},
      {"flat_wall", {{"length_mm", "10"}, {"thickness_mm", "1"}, {"height_mm", "5"}}, 50.0, 130.0},
      {"pyramid", {{"width_mm", "6"}, {"depth_mm", "6"}, {"height_mm", "4"}}, 48.0, 36.0 + 4 * 15.0},
      // Both sides, and 12 mm along the outline.
      {"tee",
       {},
       12.0 * (12.0 * 40 + 76.0 * 10),
       2 * (12.0 * 40 + 76.0 * 10) + 12.0 * (12 + 2 * 40 + (76 - 12) + 2 * 10 + 76.0)},
      {"tetradecahedron", {{"edge_mm", "2"}}, 64.0 * std::sqrt(2.0), 4.0 * (6.0 + 12.0 * std::sqrt(3.0))},
      {"cylinder",
       {{"radius_mm", "10"}, {"height_mm", "7"}, {"segments", "60"}},
       7.0 * polygonArea(10, 60),
       2.0 * polygonArea(10, 60) + 7.0 * polygonPerimeter(10, 60)},
      {"cone",
       {{"segments", "60"}},
       20.0 / 3.0 * polygonArea(10, 60),
       polygonArea(10, 60) + 0.5 * slant * polygonPerimeter(10, 60)},
      {"tube",
       {{"inner_radius_mm", "4"}, {"segments", "60"}},
       20.0 * ring,
       2.0 * ring + 20.0 * (polygonPerimeter(10, 60) + polygonPerimeter(4, 60))},
      {"semi_cone",
       {{"segments", "30"}},
       10.0 / 3.0 * polygonArea(10, 60),
       0.5 * polygonArea(10, 60) + 0.25 * slant * polygonPerimeter(10, 60) + 200.0},
      {"through_hole_plate",
       {{"hole_radius_mm", "5"}, {"segments", "40"}, {"x_mm", "50"}},
       10.0 * (1500.0 - hole),
       2.0 * (1500.0 - hole) + 1600.0 + 10.0 * polygonPerimeter(5, 40)},
      {"blind_hole_plate",
       {{"hole_radius_mm", "5"}, {"segments", "40"}, {"hole_depth_mm", "4"}},
       9000.0 - 4.0 * hole,
       1800.0 + 1200.0 + 4.0 * polygonPerimeter(5, 40)},
  };
}

std::vector<Truth> truthsOfTrials() {
  return {// 40, 30, 20 and 10 mm wide, 4 mm high each; from above and below a square of 40 mm.
          {"stepped_pyramid", {}, 4.0 * (1600 + 900 + 400 + 100), 2 * 1600.0 + 16.0 * (40 + 30 + 20 + 10)},
          {"pillar_field",
           {{"count", "3"}, {"segments", "60"}},
           9 * 10.0 * polygonArea(1, 60),
           9 * (2.0 * polygonArea(1, 60) + 10.0 * polygonPerimeter(1, 60))},
          // 30 x 30 mm less 10 x 20 mm, 160 mm round.
          {"u_channel", {}, 10.0 * 700, 2 * 700 + 10.0 * 160},
          {"two_towers", {}, 2 * 3000.0, 2 * (200 + 1200.0)},
          // What the niche takes from the side, its end has; its own sides are 2 (10 + 8) mm round.
          {"roof_niche", {}, 8000.0 - 10 * 10 * 8, 2400.0 + 10.0 * 36},
          // Voids of 12 x 12 mm, 11.8 mm high in all.
          {"thin_roof", {}, 8000.0 - 144 * 11.8, 2400.0 + 4 * 144 + 48 * 11.8}};
}

INSTANTIATE_TEST_SUITE_P(Parts, KnownPart, testing::ValuesIn(truths()),
                         [](const auto& truth) { return truth.param.name; });

INSTANTIATE_TEST_SUITE_P(Trials, KnownPart, testing::ValuesIn(truthsOfTrials()),
                         [](const auto& truth) { return truth.param.name; });

TEST(Parts, ASphereNearsItsVolumeWithTheSquareOfTheSegments) {
  const double truth = 4000.0 / 3.0 * M_PI;
  const double coarse = truth - volume(makePart("sphere", {{"segments", "40"}}));
  const double fine = truth - volume(makePart("sphere", {{"segments", "80"}}));
  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(coarse / fine, 4.0, 0.05);
}

TEST(Parts, ADomeIsHalfOfASphere) {
  const Mesh mesh = makePart("dome", {{"segments", "400"}});
  const double truth = 2.0 / 3.0 * M_PI * 8000.0;
  EXPECT_NEAR(volume(mesh), truth, 2e-4 * truth);
  EXPECT_NEAR(boundingBox(mesh).high.z(), 20.0, 1e-9);
  for (const Point3& vertex : mesh.vertices) EXPECT_NEAR(vertex.norm(), 20.0, 1e-9);
}

/// 30, 45, 60 and 75 deg: radii of 3 mm more than 5 mm times their tangents, 5 mm apart.
TEST(Parts, ConesOfAnArrayLeanByEqualSteps) {
  const Mesh mesh = makePart("cone_array", {{"segments", "96"}});
  double width = 15.0;
  double truth = 0.0;
  for (const double degrees : {30.0, 45.0, 60.0, 75.0}) {
    const double top = 3.0 + 5.0 * std::tan(degrees * M_PI / 180.0);
    width += 2.0 * top;
    truth +=
        5.0 / 3.0 *
        (polygonArea(3, 96) + polygonArea(top, 96) + std::sqrt(polygonArea(3, 96) * polygonArea(top, 96)));
  }
  EXPECT_NEAR(volume(mesh), truth, 1e-9 * truth);
  EXPECT_NEAR(boundingBox(mesh).high.x(), 0.5 * width, 1e-9);
  EXPECT_NEAR(boundingBox(mesh).low.x(), -0.5 * width, 1e-9);
}

TEST(Parts, ACurvedWallHasTheVolumeOfItsArc) {
  const double truth = 0.5 * M_PI * 30.0 * 2.0 * 20.0;
  EXPECT_NEAR(volume(makePart("curved_wall", {{"segments", "500"}})), truth, 1e-5 * truth);
}

// After Pappus: the section times the way of its middle.
TEST(Parts, AnElbowHasTheVolumeOfItsWay) {
  const double truth = M_PI * 64.0 * (6.0 + 0.5 * M_PI * 20.0);
  const Mesh mesh = makePart("elbow", {{"segments", "400"}});
  EXPECT_NEAR(volume(mesh), truth, 2e-4 * truth);
  const Box3 box = boundingBox(mesh);
  EXPECT_NEAR(box.high.x(), 20.0, 1e-9);
  EXPECT_NEAR(box.high.z(), 6.0 + 20.0 + 8.0, 1e-9);
}

// The integral of pi r² dz along the arc, r = R + a (1 - cos l), z = a sin l.
TEST(Parts, AFlareHasTheVolumeUnderItsArcAndLeansAtItsTopAsAsked) {
  const double lean = M_PI / 4.0;
  const double a = 24.0 / std::sin(lean);
  const double b = 50.0 + a;
  const double truth = M_PI * a *
                       (b * b * std::sin(lean) - 2.0 * b * a * (0.5 * lean + 0.25 * std::sin(2.0 * lean)) +
                        a * a * (std::sin(lean) - std::pow(std::sin(lean), 3) / 3.0));
  const Mesh mesh = makePart("flare", {{"segments", "400"}});
  EXPECT_NEAR(volume(mesh), truth, 2e-4 * truth);
  const Box3 box = boundingBox(mesh);
  EXPECT_NEAR(box.high.z(), 24.0, 1e-9);
  EXPECT_NEAR(box.high.x(), 50.0 + a * (1.0 - std::cos(lean)), 1e-9);
}

TEST(Parts, ABladeKeepsItsVolumeWhenItLeans) {
  const auto lean = [](const char* degrees) {
    return volume(makePart("blade", {{"lean_deg", degrees}, {"twist_deg", "0"}}));
  };
  EXPECT_NEAR(lean("0"), lean("30"), 1e-9 * lean("0"));
}

TEST(Parts, RefusesAnUnknownNameNamingTheOthers) {
  const auto refusal = [](const std::string& name) -> std::string {
    try {
      makePart(name);
    } catch (const InvalidConfig& error) {
      return error.what();
    }
    return "";
  };
  const std::string known = "; expected one of " + listed(partNames());
  EXPECT_NE(known.find("blade, blind_hole_plate, box"), std::string::npos);
  EXPECT_EQ(refusal("xyzzy"), "there is no part 'xyzzy'" + known);
  EXPECT_EQ(refusal("balde"), "there is no part 'balde'" + known + "; did you mean 'blade'?");
}

TEST(Parts, RefusesAnUnknownParameterNamingTheOneThatIsLikeIt) {
  const auto refusal = [](const std::string& key) -> std::string {
    try {
      makePart("sphere", {{key, "3"}});
    } catch (const InvalidConfig& error) {
      return error.what();
    }
    return "";
  };
  const std::string known = "; it has radius_mm, segments";
  EXPECT_EQ(refusal("radius"),
            "part 'sphere' has no parameter 'radius'" + known + "; did you mean 'radius_mm'?");
  EXPECT_EQ(refusal("segmets"),
            "part 'sphere' has no parameter 'segmets'" + known + "; did you mean 'segments'?");
  EXPECT_EQ(refusal("x_mm"), "part 'sphere' has no parameter 'x_mm'" + known);
}

TEST(Parts, RefusesParametersThatContradictEachOther) {
  EXPECT_THROW(makePart("tube", {{"inner_radius_mm", "10"}}), InvalidConfig);
  EXPECT_THROW(makePart("tee", {{"stem_mm", "76"}}), InvalidConfig);
  EXPECT_THROW(makePart("elbow", {{"bend_radius_mm", "8"}}), InvalidConfig);
  EXPECT_THROW(makePart("through_hole_plate", {{"hole_radius_mm", "15"}}), InvalidConfig);
  EXPECT_THROW(makePart("through_hole_plate", {{"segments", "42"}}), InvalidConfig);
  EXPECT_THROW(makePart("blind_hole_plate", {{"hole_depth_mm", "10"}}), InvalidConfig);
  EXPECT_THROW(makePart("curved_wall", {{"thickness_mm", "60"}}), InvalidConfig);
  EXPECT_THROW(makePart("blade", {{"thickness_mm", "30"}}), InvalidConfig);
  EXPECT_THROW(makePart("box", {{"x_mm", "0"}}), InvalidConfig);
}

}  // namespace
}  // namespace lamina
