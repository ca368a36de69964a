// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/cell_findings.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <variant>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const Eigen::Isometry3d kAnywhere = Eigen::Isometry3d::Identity();

std::string whyRefused(const std::function<void()>& find) {
  try {
    find();
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(CellFindings, NameTheMethodsThatThereAre) {
  const std::string time = whyRefused([] { findTime({}, "bob", kAnywhere, {}, ""); });
  EXPECT_NE(time.find("'bob'; expected one of bobbing, edge, overlap"), std::string::npos) << time;
  const std::string place = whyRefused([] { sensorTarget("pairs", {}, {}); });
  EXPECT_NE(place.find("'pairs'; expected one of cross, bed, plane, pyramid"), std::string::npos) << place;
}

TEST(CellFindings, AreOverTheCrossWithoutAMethod) {
  EXPECT_TRUE(std::holds_alternative<CrossTarget>(sensorTarget("", {}, {})));
  EXPECT_TRUE(std::get<PlaneTarget>(sensorTarget("bed", {}, {})).is_bed);
  EXPECT_FALSE(std::get<PlaneTarget>(sensorTarget("plane", {}, {})).is_bed);
}

TEST(CellFindings, TakeAPyramidAsFarAsItIsKnown) {
  const auto unknown = std::get<PyramidTarget>(sensorTarget("pyramid", {}, {}));
  EXPECT_FALSE(unknown.is_place_known);
  EXPECT_FALSE(unknown.is_top_known);
  const KnownPyramid known{{30.0, 12.0, 8.0}, {90.0, 80.0}, {9.5}};
  const auto target = std::get<PyramidTarget>(sensorTarget("pyramid", known, {}));
  EXPECT_EQ(target.base_mm, 30.0);
  EXPECT_TRUE(target.is_place_known && target.is_top_known);
  EXPECT_EQ(target.bed_from_pyramid.translation(), Point3(90.0, 80.0, 1.5));
}

TEST(CellFindings, RefuseAPyramidThatIsNone) {
  const KnownPyramid flawed[] = {
      {{30.0, 12.0}, {}, {}}, {{12.0, 30.0, 8.0}, {}, {}}, {{}, {90.0}, {}}, {{}, {}, {1.0, 2.0}}};
  for (const KnownPyramid& pyramid : flawed)
    EXPECT_THROW(sensorTarget("pyramid", pyramid, {}), InvalidConfig);
}

}  // namespace
}  // namespace lamina
