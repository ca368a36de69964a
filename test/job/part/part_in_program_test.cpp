// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/part_in_program.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "support/solids.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// One bead of 0.4 x 0.2 mm that rises to 5 mm over 20 mm, about the axis y; and a skirt round it.
Toolpath ramp(double begins_mm = 0.2) {
  Path skirt = test::straightPath({-40, -40, 0.2}, {60, 40, 0.2});
  skirt.role = PathRole::Skirt;
  return {"ramp", {{5.0, 0.2, {skirt, test::straightPath({10, 7, begins_mm}, {30, 7, 5.0})}}}};
}

PartInProgram placeIn(const Toolpath& program, const Mesh& mesh, const std::optional<Point3>& given) {
  NoProgress nobody;
  return findPart(program, {"box.stl", mesh}, given, {}, nobody);
}

TEST(PartInProgram, OfLayersThatAreNotLevelIsFoundByItsBox) {
  const PartInProgram found = placeIn(ramp(), test::boxBetween({0, 0, 0}, {20.4, 0.4, 5}), std::nullopt);
  EXPECT_EQ(found.finding, PartFinding::Box);
  EXPECT_LT((found.program_from_part - Point3(9.8, 6.8, 0)).norm(), 1e-9);
}

TEST(PartInProgram, StandsOnTheBedThoughItsLowestBeadLiesALittleAboveIt) {
  // As curved layers of a sphere, which leave its very bottom open; half a bead are 0.1 mm.
  const Mesh standing = test::boxBetween({0, 0, 0}, {20.4, 0.4, 5});
  EXPECT_NEAR(placeIn(ramp(0.23), standing, std::nullopt).program_from_part.z(), 0.0, 1e-9);
  EXPECT_NEAR(placeIn(ramp(0.17), standing, std::nullopt).program_from_part.z(), 0.0, 1e-9);
  const Mesh raised = test::boxBetween({0, 0, 7}, {20.4, 0.4, 12});
  EXPECT_NEAR(placeIn(ramp(0.23), raised, std::nullopt).program_from_part.z(), -7.0, 1e-9);
  EXPECT_NEAR(placeIn(ramp(0.35), standing, std::nullopt).program_from_part.z(), 0.15, 1e-9) << "on a raft";
}

TEST(PartInProgram, IsLargerWhereThePartShrinks) {
  JobSettings settings;
  settings.compensation.shrink_xy = 0.2;
  settings.compensation.shrink_z = 0.5;
  const ComparedPart drawn{"box.stl", test::boxBetween({0, 0, 1}, {20, 10, 5})};
  const Box3 printed = boundingBox(asPrinted(drawn, settings).mesh);
  EXPECT_TRUE(printed.low.isApprox(Point3(-2.5, -1.25, 1)));
  EXPECT_TRUE(printed.high.isApprox(Point3(22.5, 11.25, 9)));
  EXPECT_EQ(boundingBox(asPrinted(drawn, {}).mesh).high, Point3(20, 10, 5));
}

TEST(PartInProgram, AProgramOfALargerPartIsRefusedWithBothSizes) {
  // 1.2 mm of three beads are less than 20.4 - 19.1 mm.
  EXPECT_NO_THROW(placeIn(ramp(), test::boxBetween({0, 0, 0}, {19.3, 0.4, 5}), std::nullopt));
  EXPECT_NO_THROW(placeIn(ramp(), test::boxBetween({0, 0, 0}, {90, 90, 90}), std::nullopt))
      << "it may end before the part does";
  const Mesh smaller = test::boxBetween({0, 0, 0}, {19.1, 0.4, 5});
  try {
    placeIn(ramp(), smaller, std::nullopt);
    FAIL() << "expected it to be refused";
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'ramp' is no program of the part 'box.stl'"), std::string::npos) << text;
    EXPECT_NE(text.find("20.4 x 0.4 x 5 mm"), std::string::npos) << text;
    EXPECT_NE(text.find("19.1 x 0.4 x 5 mm"), std::string::npos) << text;
  }
  EXPECT_EQ(placeIn(ramp(), smaller, Point3(1, 2, 3)).finding, PartFinding::Given);
}

}  // namespace
}  // namespace lamina
