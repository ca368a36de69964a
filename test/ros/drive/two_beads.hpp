// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "lamina/toolpath/toolpath.hpp"
#include "ros/drive/drive_cell.hpp"

namespace lamina::test {

constexpr double kHeight = 0.5;  // mm
constexpr double kHalf = 20.0;   // mm: beads go from -20 to 20 along x
constexpr double kLag = 0.5;     // mm that joints trail by, or a report is old

inline Path straight(PathRole role, const Point3& from, const Point3& to) {
  Path path;
  path.role = role;
  path.points = {from, to};
  path.feed_mm_s = 30.0;
  path.orientation = Eigen::AngleAxisd(0.15, Point3(1, 1, 0).normalized()) * nozzleDown();
  if (role != PathRole::Travel) path.bead = Bead{1.0, kHeight};
  return path;
}

/// Two beads with the tool axis leaning, at a height, and the travel between them.
inline Toolpath twoBeads(double z = kHeight) {
  const Point3 ends[] = {{-kHalf, 5, z}, {kHalf, 5, z}, {kHalf, 35, z}, {-kHalf, 35, z}};
  return {"beads",
          {{z,
            kHeight,
            {straight(PathRole::OuterWall, ends[0], ends[1]), straight(PathRole::Travel, ends[1], ends[2]),
             straight(PathRole::OuterWall, ends[2], ends[3])}}}};
}

inline bool isOnBead(const Point3& tip, double within) {
  const double off = std::min(std::abs(tip.y() - 5.0), std::abs(tip.y() - 35.0));
  return off < kLag && std::abs(tip.z() - kHeight) < kLag && std::abs(tip.x()) < kHalf + within;
}

/// What the tip did while material flowed, of some reports.
struct Deposit {
  double fastest_mm_s = 0.0;
  double greatest_flow = 0.0;
};

inline Deposit depositOf(const DriveCell& cell, std::size_t from, std::size_t to) {
  Deposit deposit;
  for (std::size_t i = from + 1; i < to; ++i) {
    const DriveCell::Report& before = cell.reports[i - 1];
    const DriveCell::Report& now = cell.reports[i];
    if (now.process.flow == 0.0 || before.process.flow == 0.0) continue;
    const double passed_s = (now.process.header.stamp - before.process.header.stamp).toSec();
    deposit.fastest_mm_s =
        std::max(deposit.fastest_mm_s, (cell.tip(now) - cell.tip(before)).norm() / passed_s);
    deposit.greatest_flow = std::max<double>(deposit.greatest_flow, now.process.flow);
  }
  return deposit;
}

}  // namespace lamina::test
