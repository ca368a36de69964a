// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/border_connection.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

const Regions kBorderConnectionSquare = {{test::rectangle(0, 0, 10, 10), {}}};
const BorderConnection kConnection{0.1, 0.5, 15.0, 100.0};

FillPath run(const Polyline& points) {
  FillPath path;
  path.points = points;
  path.width_mm.assign(points.size(), 0.4);
  return path;
}

TEST(BorderConnection, RunsAlongTheOutlineAsAThinBead) {
  const auto connected = connectAlongBorder({run({{5, 5}, {5, 0.3}}), run({{9.7, 5}, {6, 5}})},
                                            kBorderConnectionSquare, kConnection);
  ASSERT_EQ(connected.size(), 1U);
  EXPECT_EQ(connected[0].points, (Polyline{{5, 5}, {5, 0.3}, {5, 0}, {10, 0}, {10, 5}, {9.7, 5}, {6, 5}}));
  EXPECT_EQ(connected[0].width_mm, (std::vector<double>{0.4, 0.4, 0.1, 0.1, 0.1, 0.1, 0.4}));
}

TEST(BorderConnection, TakesTheShorterWayRound) {
  const auto connected = connectAlongBorder({run({{5, 5}, {0.2, 2}}), run({{2, 0.2}, {6, 5}})},
                                            kBorderConnectionSquare, kConnection);
  ASSERT_EQ(connected.size(), 1U);
  EXPECT_EQ(connected[0].points, (Polyline{{5, 5}, {0.2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 0.2}, {6, 5}}));
}

TEST(BorderConnection, StaysOnOneEdgeWhereBothEndsAre) {
  const auto connected = connectAlongBorder({run({{7, 5}, {7, 0.2}}), run({{3, 0.2}, {3, 5}})},
                                            kBorderConnectionSquare, kConnection);
  ASSERT_EQ(connected.size(), 1U);
  EXPECT_EQ(connected[0].points, (Polyline{{7, 5}, {7, 0.2}, {7, 0}, {3, 0}, {3, 0.2}, {3, 5}}));
}

TEST(BorderConnection, IsNotLongerThanAllowed) {
  BorderConnection shorter = kConnection;
  shorter.longest_mm = 9.9;
  EXPECT_EQ(
      connectAlongBorder({run({{5, 5}, {5, 0.3}}), run({{9.7, 5}, {6, 5}})}, kBorderConnectionSquare, shorter)
          .size(),
      2U);
}

TEST(BorderConnection, CoversNoMoreThanAllowed) {
  BorderConnection scarce = kConnection;
  // 10 mm along the border, and 0.3 mm from the end of each run to it.
  scarce.most_mm2 = 0.1 * 10.6 + 1e-9;
  const std::vector<FillPath> runs = {run({{5, 5}, {5, 0.3}}), run({{9.7, 5}, {6, 5}})};
  EXPECT_EQ(connectAlongBorder(runs, kBorderConnectionSquare, scarce).size(), 1U);
  scarce.most_mm2 = 0.1 * 10.5;
  EXPECT_EQ(connectAlongBorder(runs, kBorderConnectionSquare, scarce).size(), 2U);
}

TEST(BorderConnection, GoesToTheNearestEndAndTurnsItsRunRound) {
  const auto connected =
      connectAlongBorder({run({{5, 5}, {5, 0.2}}), run({{9, 9.8}, {9, 6}}), run({{4, 5}, {4, 0.2}})},
                         kBorderConnectionSquare, kConnection);
  ASSERT_EQ(connected.size(), 2U);
  EXPECT_EQ(connected[0].points, (Polyline{{5, 5}, {5, 0.2}, {5, 0}, {4, 0}, {4, 0.2}, {4, 5}}));
}

TEST(BorderConnection, IsNotMadeFromFarInside) {
  EXPECT_EQ(connectAlongBorder({run({{5, 5}, {5, 1}}), run({{9.7, 5}, {6, 5}})}, kBorderConnectionSquare,
                               kConnection)
                .size(),
            2U);
}

TEST(BorderConnection, IsNotMadeBetweenTwoOutlines) {
  const Regions ring = {{test::rectangle(0, 0, 10, 10), {test::reversed(test::rectangle(4, 4, 6, 6))}}};
  EXPECT_EQ(connectAlongBorder({run({{5, 1}, {5, 0.1}}), run({{5, 3.9}, {5, 3}})}, ring, kConnection).size(),
            2U);
}

TEST(BorderConnection, LeavesClosedRunsAlone) {
  FillPath loop = run({{1, 1}, {9, 1}, {9, 9}, {1, 9}});
  loop.is_closed = true;
  EXPECT_EQ(
      connectAlongBorder({loop, run({{5, 0.2}, {5, 5}})}, kBorderConnectionSquare, {0.1, 2.0, 50.0, 100.0})
          .size(),
      2U);
}

}  // namespace
}  // namespace lamina
