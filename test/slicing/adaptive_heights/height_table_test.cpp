// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adaptive_heights/height_table.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class HeightTable : public testing::Test {
 protected:
  std::vector<LayerBounds> read(const std::string& rows, double bottom_mm, double top_mm) const {
    writeFile(path_, "z_mm,height_mm\n" + rows);
    return readHeightTable(path_, bottom_mm, top_mm);
  }

  std::string refusal(const std::string& rows, double top_mm) const {
    try {
      read(rows, 0.0, top_mm);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("heights.csv");
};

TEST_F(HeightTable, CountsFromTheLowestPointOfThePart) {
  const auto bounds = read("0.3,0.3\n0.5,0.2\n", 7.0, 7.5);
  ASSERT_EQ(bounds.size(), 2U);
  EXPECT_DOUBLE_EQ(bounds[0].bottom_mm, 7.0);
  EXPECT_DOUBLE_EQ(bounds[0].top_mm, 7.3);
  EXPECT_DOUBLE_EQ(bounds[1].top_mm, 7.5);
}

TEST_F(HeightTable, ReadsBackWhatIsWritten) {
  const std::vector<LayerBounds> bounds = {{2.0, 2.1}, {2.1, 2.1 + 1.0 / 7.0}, {2.1 + 1.0 / 7.0, 3.0}};
  writeFile(path_, heightTable(bounds));
  const auto again = readHeightTable(path_, 2.0, 3.0);
  ASSERT_EQ(again.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(again[i].bottom_mm, bounds[i].bottom_mm, 1e-11);
    EXPECT_NEAR(again[i].top_mm, bounds[i].top_mm, 1e-11);
  }
}

TEST_F(HeightTable, LeavesOutLayersAboveThePart) {
  EXPECT_EQ(read("0.3,0.3\n0.6,0.3\n0.9,0.3\n", 0.0, 0.5).size(), 2U);
}

TEST_F(HeightTable, RefusesGapsAndWhatIsNoHeight) {
  EXPECT_NE(refusal("0.3,0.3\n0.7,0.3\n", 0.7).find("line 3"), std::string::npos);
  EXPECT_NE(refusal("0.3,0.3\n0.3,0\n", 0.3).find("must be positive"), std::string::npos);
  EXPECT_NE(refusal("0.3,high\n", 0.3).find("'high'; must be a number"), std::string::npos);
}

TEST_F(HeightTable, RefusesATableThatEndsBelowThePart) {
  EXPECT_NE(refusal("0.3,0.3\n", 5.0).find("5 mm high"), std::string::npos);
  EXPECT_NE(refusal("", 5.0), "");
}

}  // namespace
}  // namespace lamina
