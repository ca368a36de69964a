// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/csv/coordinate_matrix.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

Toolpath loop() {
  Path path;
  path.role = PathRole::InnerWall;
  path.is_closed = true;
  path.points = {{102, 52, 0.3}, {141.5, 52, 0.3}, {141.5, 56.5, 0.3}, {102, 56.5, 0.3}};
  path.bead = Bead{0.4968, 0.3};
  path.feed_mm_s = 30.0;
  Toolpath toolpath;
  toolpath.layers = {{0.3, 0.3, {path}}};
  return toolpath;
}

TEST(CoordinateMatrix, RowsOfALoopAreThoseOfTheDocument) {
  const std::vector<CoordinateRow> rows = coordinateMatrix(loop(), 1.75);
  ASSERT_EQ(rows.size(), 5U);
  // [Vega2023, figure 22]: filament in mm, of a loop of 88 mm; its coordinates are rounded to 0.1 mm.
  const double filament_mm[] = {0.0, 2.1294, 2.3729, 4.5023, 4.7459};
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_NEAR(rows[i].filament_mm, filament_mm[i], 2e-3) << i;
  EXPECT_EQ(rows.front().point, rows.back().point);
}

TEST(CoordinateMatrix, CsvHasMetresFlagsAndFilament) {
  const std::string csv = toCsv(coordinateMatrix(loop(), 1.75));
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "x_m,y_m,z_m,flag,e_mm");
  EXPECT_NE(csv.find("\n0.0020000,0.0020000,0.0003000,0,0.00000\n"), std::string::npos);
  EXPECT_NE(csv.find("\n0.0415000,0.0065000,0.0003000,1,2.37"), std::string::npos);
}

TEST(CoordinateMatrix, IsEmptyOfWhatLaysNothing) {
  EXPECT_TRUE(coordinateMatrix({}, 1.75).empty());
  EXPECT_THROW(coordinateMatrix(loop(), 0.0), InvalidInput);
}

TEST(ExtrusionWidth, InvertsTheStadium) {
  EXPECT_NEAR(extrusionWidth(4.7459, 88.0, 0.3, 1.75), 0.4968, 5e-5);
  EXPECT_NEAR(extrusionWidth(4.5618, 88.0, 0.3, 1.75), 0.4800, 5e-5);
  EXPECT_THROW(extrusionWidth(1.0, 0.0, 0.3, 1.75), InvalidInput);
}

TEST(ExtrusionWidth, CrossSectionsGiveTheRatesSlicersTell) {
  EXPECT_NEAR(crossSection({0.48, 0.30}), 0.124686, 5e-7);
  EXPECT_NEAR(crossSection({0.44, 0.30}), 0.112686, 5e-7);
  const double rates_mm3_s[][2] = {{30.0, 3.74}, {15.0, 1.87}, {20.0, 2.49}};
  for (const auto& [feed_mm_s, rate] : rates_mm3_s)
    EXPECT_NEAR(crossSection({0.48, 0.30}) * feed_mm_s, rate, 0.005);
}

}  // namespace
}  // namespace lamina
