// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/given_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

CellGraph boxCells() {
  NoProgress progress;
  return {test::boxBetween({0, 0, 0}, {12, 8, 10}), 1.0, 0.0, progress};
}

std::vector<Point3> directionsIn(const CellGraph& cells, const std::vector<DirectionSample>& samples) {
  NoProgress progress;
  return directionsAtNodes(cells, samples, progress);
}

/// Along circles about the line x = 30 mm, z = 0.
Point3 tangentAt(const Point3& place) {
  return Point3::UnitY().cross(place - Point3(30.0, place.y(), 0.0)).normalized();
}

/// Samples every 2 mm up to a height.
std::vector<DirectionSample> bentSamples(int top_mm) {
  std::vector<DirectionSample> samples;
  for (int x = 0; x <= 12; x += 2)
    for (int y = 0; y <= 8; y += 2)
      for (int z = 0; z <= top_mm; z += 2) {
        const Point3 place(x, y, z);
        samples.push_back({place, tangentAt(place)});
      }
  return samples;
}

TEST(GivenDirections, FollowABend) {
  const CellGraph cells = boxCells();
  const std::vector<Point3> directions = directionsIn(cells, bentSamples(10));
  ASSERT_EQ(directions.size(), cells.nodeCount());
  double sum_deg = 0.0;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) {
    EXPECT_NEAR(directions[node].norm(), 1.0, 1e-12);
    const double cosine = directions[node].dot(tangentAt(cells.middle(node)));
    const double off_deg = toDegrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    EXPECT_LT(off_deg, 4.0) << cells.middle(node).transpose();
    sum_deg += off_deg;
  }
  EXPECT_LT(sum_deg / cells.nodeCount(), 1.0);
}

TEST(GivenDirections, AreThatOfASingleSampleEverywhere) {
  const Point3 tilted(std::sin(0.3), 0.0, std::cos(0.3));
  const CellGraph cells = boxCells();
  for (const Point3& direction : directionsIn(cells, {{Point3(500, 0, 0), tilted}}))
    EXPECT_LT((direction - tilted).norm(), 1e-12);
}

// They lie 2 mm apart, and 9.5 mm up the part may be 6 mm from the nearest.
TEST(GivenDirections, AreRefusedWhereTheyDoNotReachThePart) {
  const CellGraph cells = boxCells();
  EXPECT_NO_THROW(directionsIn(cells, bentSamples(6)));
  try {
    directionsIn(cells, bentSamples(2));
    FAIL() << "expected a refusal";
  } catch (const InvalidInput& refusal) {
    const std::string text = refusal.what();
    EXPECT_NE(text.find("from the nearest given direction; expected at most 6 mm"), std::string::npos)
        << text;
  }
  EXPECT_THROW(directionsIn(cells, {}), InvalidInput);
}

TEST(GivenDirections, AreRefusedWhereTheyCancelOut) {
  NoProgress progress;
  const CellGraph cells(test::boxBetween({0, 0, 0}, {2, 2, 2}), 1.0, 0.0, progress);
  const Point3 middle(1, 1, 1);
  EXPECT_THROW(directionsIn(cells, {{middle, Point3::UnitX()}, {middle, -Point3::UnitX()}}), InvalidInput);
}

}  // namespace
}  // namespace lamina
