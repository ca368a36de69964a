// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/trajectory/nozzle_motion.hpp"

namespace lamina {

/// What a table of the nozzle over time holds.
struct NozzleTable {
  double rate_hz = 100.0;            ///< within `kNozzleRates`
  std::vector<ProcessLevel> levels;  ///< a column of each
};

/// The process values that a toolpath states anywhere, in the order of `kAllProcessLevels`.
std::vector<ProcessLevel> levelsIn(const Toolpath& toolpath);

/// @throws InvalidConfig naming the rate if it is out of `kNozzleRates`
void requireNozzleRate(double rate_hz);

/// Writes where the nozzle is at even steps from 0 to the end, and at the end, a row for each, whole or not
/// at all. Columns: t [s]; x, y, z of the tip over the bed [mm]; qw, qx, qy, qz, bed_from_nozzle, without
/// jumps to the negative; v, the speed of the tip over the bed [mm/s]; flow_mm3_s; laser, wire, powder and
/// gas, 1 while on; the levels by their names, empty where none is stated.
/// @throws InvalidConfig as `requireNozzleRate`
/// @throws FileError as `AtomicFile`
void writeNozzleCsv(const std::string& file, const JointTrajectory& trajectory, const KinematicModel& model,
                    const NozzleTable& table);

}  // namespace lamina
