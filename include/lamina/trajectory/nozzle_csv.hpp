// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/trajectory/nozzle_motion.hpp"

namespace lamina {

/// Contents of a table of the nozzle's motion over time.
struct NozzleTable {
  double rate_hz = 100.0;            ///< rows per second, within `kNozzleRates`
  std::vector<ProcessLevel> levels;  ///< process values that have a column each
};

/// The process values that at least one path of a toolpath states, in the order of `kAllProcessLevels`.
std::vector<ProcessLevel> levelsIn(const Toolpath& toolpath);

/// Checks a rate.
/// @throws InvalidConfig naming the rate if it is out of `kNozzleRates`
void requireNozzleRate(double rate_hz);

/// Writes a CSV file of the nozzle's motion, with a row for each step from time 0 on and one for the end. The
/// file is written as a whole or not at all. Columns: t [s]; x, y, z, position of the tip [mm, bed frame];
/// qw, qx, qy, qz, quaternion bed_from_nozzle, with signs chosen so that it is continuous; v, speed of the
/// tip [mm/s]; flow_mm3_s; laser, wire, powder and gas, 1 while on, else 0; the levels by their names, empty
/// where none is stated.
/// @throws InvalidConfig as `requireNozzleRate`
/// @throws FileError as `AtomicFile`
void writeNozzleCsv(const std::string& file, const JointTrajectory& trajectory, const KinematicModel& model,
                    const NozzleTable& table);

}  // namespace lamina
