// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/chart.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr Colour kChartRed{1.0, 0.0, 0.0};

int pixelsOf(const Colour& colour, const Chart& chart) {
  const test::ScratchFolder folder;
  writeFile(folder.file("chart.png"), chartPng(chart, 600, 400));
  const test::PngImage image(folder.file("chart.png"));
  EXPECT_EQ(image.width(), 600);
  EXPECT_EQ(image.height(), 400);
  int count = 0;
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column) {
      const Colour found = image.at(column, row);
      if (std::abs(found.red - colour.red) + std::abs(found.green - colour.green) +
              std::abs(found.blue - colour.blue) <
          0.01)
        ++count;
    }
  return count;
}

TEST(Chart, DrawsDotsOfTheirSize) {
  const Chart chart{"t", "x", "y", {{"", {{0, 0}, {1, 1}, {0.5, 0.2}}, kChartRed, 10.0, 0.0}}};
  EXPECT_NEAR(pixelsOf(kChartRed, chart), 3 * M_PI * 100.0, 150.0);
}

TEST(Chart, LeavesOutWhatIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  const Chart chart{"t", "x", "y", {{"", {{none, 0}, {1, 1}, {2, endless}}, kChartRed, 10.0, 2.0}}};
  EXPECT_NEAR(pixelsOf(kChartRed, chart), M_PI * 100.0, 50.0);
}

TEST(Chart, ShowsNothingAndOnePlace) {
  EXPECT_EQ(pixelsOf(kChartRed, {"empty", "x", "y", {}}), 0);
  EXPECT_GT(pixelsOf(kChartRed, {"one", "x", "y", {{"a", {{7, 7}, {7, 7}}, kChartRed, 4.0, 0.0}}}), 20);
  EXPECT_THROW(chartPng({}, 100, 400), InvalidInput);
}

RC_GTEST_PROP(RoundTicks, LieWithinAndAreEvenlySpaced, ()) {
  const double low = 1e-3 * *rc::gen::inRange(-1000000, 1000000);
  const double size = std::pow(10.0, 0.01 * *rc::gen::inRange(-600, 600));
  RC_PRE(low + size > low);
  const std::vector<double> ticks = roundTicks(low, low + size, 8);
  RC_ASSERT(ticks.size() >= 2U);
  RC_ASSERT(ticks.size() <= 10U);
  // A tick is n steps, n at least low / step but for the rounding of that; n steps are rounded once more.
  // Each rounds by half an epsilon at most. What would come out above the interval is left out.
  const double rounding = std::numeric_limits<double>::epsilon() * std::abs(low);
  for (const double tick : ticks) {
    RC_ASSERT(tick >= low - rounding);
    RC_ASSERT(tick <= low + size);
  }
}

}  // namespace
}  // namespace lamina
