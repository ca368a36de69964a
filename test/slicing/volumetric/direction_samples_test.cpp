// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/direction_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::vector<DirectionSample> samplesOf(const std::string& text) {
  const test::ScratchFolder folder;
  writeFile(folder.file("given.csv"), text);
  return readDirectionSamples(folder.file("given.csv"));
}

std::string refusalOfTable(const std::string& text) {
  try {
    samplesOf(text);
  } catch (const InvalidInput& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(DirectionSamples, AreReadWithDirectionsOfUnitLength) {
  const std::vector<DirectionSample> samples =
      samplesOf("# a bend\nx,y,z,nx,ny,nz\n1,2,3,0,3,4\n-1.5,0,2e1,0,0,0.01\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].place, Point3(1, 2, 3));
  EXPECT_LT((samples[0].direction - Point3(0, 0.6, 0.8)).norm(), 1e-12);
  EXPECT_EQ(samples[1].place, Point3(-1.5, 0, 20));
  EXPECT_LT((samples[1].direction - Point3::UnitZ()).norm(), 1e-12);
}

TEST(DirectionSamples, MayStandInAnyOrderOfColumns) {
  const std::vector<DirectionSample> samples = samplesOf("nz,nx,ny,z,y,x,stress\n1,0,0,3,2,1,7\n");
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples[0].place, Point3(1, 2, 3));
  EXPECT_EQ(samples[0].direction, Point3::UnitZ());
}

TEST(DirectionSamples, AreRefusedWhereTheySayNothing) {
  EXPECT_NE(refusalOfTable("x,y,z,nx,ny,nz\n").find("0 rows"), std::string::npos);
  for (const char* const number : {"nan", "inf", "-inf", "", "up", "1e999"}) {
    const std::string refusal =
        refusalOfTable("x,y,z,nx,ny,nz\n0,0,0,0,0,1\n0,0,1,0," + std::string(number) + ",1\n");
    EXPECT_NE(refusal.find("line 3: ny is '" + std::string(number) + "'"), std::string::npos) << refusal;
  }
  const std::string zero = refusalOfTable("x,y,z,nx,ny,nz\n0,0,0,0,0,0\n");
  EXPECT_NE(zero.find("line 2"), std::string::npos) << zero;
  EXPECT_NE(refusalOfTable("x,y,z,nx,ny\n0,0,0,0,1\n"), "");
}

// A plane that leans by 45 deg leans by atan(1 / 2) once it is twice as high, and its normal stays across it.
TEST(DirectionSamples, StayAcrossTheLayersOfAScaledPart) {
  Eigen::Affine3d taller = Eigen::Affine3d::Identity();
  taller.linear() = Point3(1, 1, 2).asDiagonal();
  taller.translation() = Point3(10, 0, -1);
  const std::vector<DirectionSample> moved =
      transformed({{Point3(1, 2, 3), Point3(std::sqrt(0.5), 0, std::sqrt(0.5))}}, taller);
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_LT((moved[0].place - Point3(11, 2, 5)).norm(), 1e-12);
  EXPECT_LT((moved[0].direction - Point3(2, 0, 1) / std::sqrt(5.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace lamina
