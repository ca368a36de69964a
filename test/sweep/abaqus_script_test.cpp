// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/abaqus_script.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "sweep/specimen.hpp"

namespace lamina {
namespace {

TEST(AbaqusScript, PlacesTheProfileAcrossTheFirstLine) {
  // [Vega2023, eq. 2]
  const SketchTransform expected = {0, 1, 0, 0, 0, 1, 1, 0, 0, 8.962, 2.482, 0};
  const SketchTransform placed = profileTransform({8.962, 2.482}, {4.664, 2.482}, 0.0);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(placed[i], expected[i], 1e-12) << i;
}

TEST(AbaqusScript, OrientsSketchesByTheFirstLine) {
  EXPECT_TRUE(isSketchRight({2, 2}, {9, 2}));
  EXPECT_FALSE(isSketchRight({9, 2}, {2, 2}));
  EXPECT_TRUE(isSketchRight({2, 9}, {2, 2}));
  EXPECT_FALSE(isSketchRight({2, 2}, {2, 9}));
  EXPECT_TRUE(isSketchRight({2, 9}, {9, 2}));
  EXPECT_FALSE(isSketchRight({9, 2}, {2, 9}));
  // Towards -x and -y: the line meets the x axis at x = 4 or at x = -4.
  EXPECT_TRUE(isSketchRight({8, 4}, {6, 2}));
  EXPECT_FALSE(isSketchRight({2, 6}, {1, 5}));
  // Towards +x and +y: the other way about.
  EXPECT_FALSE(isSketchRight({6, 2}, {8, 4}));
  EXPECT_TRUE(isSketchRight({1, 5}, {2, 6}));
}

std::vector<Sweep> twoLayers() {
  SweepSettings settings;
  return sweepsOf(test::layered({0.35, 0.65},
                                [](std::size_t, double z, double h) {
                                  return std::vector<Path>{
                                      test::bead({{106.962, 50, z}, {102.664, 50, z}}, {0.48, h}),
                                      test::bead({{102.664, 50.5, z}, {106.962, 50.5, z}}, {0.48, h})};
                                }),
                  settings);
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(AbaqusScript, SweepsEveryProfileOnItsPlane) {
  const std::string script = abaqusScript(twoLayers());
  EXPECT_EQ(script.rfind("from part import *\nfrom material import *\n", 0), 0U);
  EXPECT_TRUE(holds(script, "from connectorBehavior import *\n"));
  EXPECT_TRUE(holds(script, "['__sweep__'].Line(point1=(6.298, 2.000), point2=(2.000, 2.000))"));
  EXPECT_TRUE(
      holds(script,
            "transform=(0.000000, 1.000000, 0.000000, 0.000000, 0.000000, 1.000000, 1.000000, 0.000000, "
            "0.000000, 6.298, 2.000, 0.000))"));
  EXPECT_TRUE(holds(script, "Line(point1=(-0.065, 0.350), point2=(0.065, 0.350))"));
  EXPECT_TRUE(holds(script, "point1=(0.065, 0.000), point2=(0.065, 0.350), vector=(1.0, 0.0)"));
  for (const char* offset : {"offset=0.000,", "offset=0.350,", "offset=0.650,"})
    EXPECT_TRUE(holds(script, offset));
  EXPECT_TRUE(holds(script, "datums[5], sketchPlaneSide=SIDE1"));
  EXPECT_TRUE(holds(script, "origin=(0.0, 0.0, 0.350)"));
  EXPECT_TRUE(holds(script, "sketchOrientation=RIGHT"));
  std::size_t count = 0;
  for (std::size_t at = script.find(".SolidSweep("); at != std::string::npos;
       at = script.find(".SolidSweep(", at + 1))
    ++count;
  EXPECT_EQ(count, 3U);
}

TEST(AbaqusScript, RefusesWhatIsNotLevel) {
  EXPECT_THROW(abaqusScript({}), InvalidInput);
  std::vector<Sweep> sweeps = twoLayers();
  sweeps[1].points[1].z() += 0.1;
  EXPECT_THROW(abaqusScript(sweeps), InvalidInput);
}

}  // namespace
}  // namespace lamina
