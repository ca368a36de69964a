// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/stiffness/calculix_deck.hpp"
#include "lamina/stiffness/stiffness_vtk.hpp"
#include "lamina/stiffness/surface_points.hpp"
#include "support/scratch_folder.hpp"
#include "support/voxel_shapes.hpp"

namespace lamina {
namespace {

StiffnessResult compressedBox() {
  NoProgress progress;
  return solveStiffness(test::solidBox({3, 3, 4}, 0.5), {}, progress);
}

std::size_t linesWith(const std::string& text, const std::string& part) {
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.find(part) != std::string::npos ? 1 : 0;
  return count;
}

TEST(StiffnessVtk, HoldsEveryNodeAndElement) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("box.vtk");
  writeVtk(compressedBox(), path);
  const std::string file = readFile(path);
  EXPECT_EQ(file.rfind("# vtk DataFile Version 3.0\n", 0), 0U);
  const std::size_t points = file.find("POINTS 80 float\n");
  const std::size_t cells = file.find("\nCELLS 36 324\n");
  ASSERT_NE(points, std::string::npos);
  ASSERT_NE(cells, std::string::npos);
  EXPECT_EQ(cells - points, std::string("POINTS 80 float\n").size() + std::size_t{80} * 12);
  EXPECT_NE(file.find("VECTORS displacement_mm float\n"), std::string::npos);
  EXPECT_NE(file.find("stress_mpa 6 36 float\n"), std::string::npos);
  // Float -1.0 of the corner (1, 2, 3) begins with 3F 80 00 00, most significant byte first.
  EXPECT_EQ(file.substr(points + 16, 4), std::string("\x3F\x80\x00\x00", 4));
}

TEST(CalculixDeck, HoldsEveryNodeElementAndGivenDisplacement) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("box.inp");
  const StiffnessResult result = compressedBox();
  writeCalculixDeck(result, {3861.0, 0.35}, path);
  const std::string deck = readFile(path);
  EXPECT_EQ(linesWith(deck, ", -0.2"), 16U);
  EXPECT_EQ(linesWith(deck, ", 3, 3, 0"), 16U);
  EXPECT_EQ(linesWith(deck, ", 1, 1, 0") + linesWith(deck, ", 2, 2, 0"), 3U);
  EXPECT_NE(deck.find("36, 59, 60, 64, 63, 75, 76, 80, 79\n"), std::string::npos);
  EXPECT_NE(deck.find("*ELASTIC\n3861, 0.35\n"), std::string::npos);
}

TEST(SurfacePoints, LeaveOutNodesWithin) {
  const SurfacePoints points = surfacePoints(compressedBox());
  ASSERT_EQ(points.place.size(), 80U - 2U * 2U * 3U);
  EXPECT_EQ(points.place.front(), Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_NEAR(points.displacement.back().z(), -0.2F, 1e-6F);
  for (const float stress : points.von_mises) EXPECT_NEAR(stress, 386.1F, 0.1F);
}

}  // namespace
}  // namespace lamina
