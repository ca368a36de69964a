// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "conversions.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/planning/scan_pass.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

constexpr double kLayer = 1.5;    // mm
constexpr double kLength = 24.0;  // mm: in one swath of the sensor
constexpr double kSpeed = 20.0;   // mm/s

/// A wall of one bead a layer on the Cartesian gantry, each layer scanned once it is deposited.
inline MachineToolpath scannedWall(std::size_t layers) {
  Toolpath wall;
  wall.part_name = "wall";
  for (std::size_t k = 0; k < layers; ++k) {
    const double z = kLayer * static_cast<double>(k + 1);
    Path bead;
    bead.role = PathRole::OuterWall;
    bead.bead = Bead{3.0, kLayer};
    bead.feed_mm_s = kSpeed;
    bead.points = {{0, 0, z}, {kLength, 0, z}};
    Path travel;
    travel.role = PathRole::Travel;
    travel.feed_mm_s = 100.0;
    if (k > 0) travel.points = {wall.layers.back().paths.back().lastPoint(), bead.points.front()};
    wall.layers.push_back({z, kLayer, {}});
    if (k > 0) wall.layers.back().paths.push_back(travel);
    wall.layers.back().paths.push_back(bead);
  }
  const BuildSpace space = buildSpaceByName("cartesian_gantry");
  ScanSettings scan;
  scan.every_layers = 1;
  scan.feed_mm_s = 40.0;
  MachineToolpath placed;
  placed.machine = space.name;
  placed.toolpath = withScanPasses(wall, scan, {sensorOffset(space), Point2::Zero()});
  placed.bed_from_part = Eigen::Translation3d(90.0, 110.0, 0.0);
  placed.id = toolpathId(placed.toolpath);
  return placed;
}

}  // namespace lamina::test
