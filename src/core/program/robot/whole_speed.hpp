// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/program/robot/robot_program_settings.hpp"

namespace lamina {

/// A unit in which a language writes speeds with a fixed number of decimals.
struct SpeedUnit {
  std::string name;       ///< as written: "mm/sec"
  double mm_s = 1.0;      ///< that one of it is
  double step = 1.0;      ///< of its last decimal
  double greatest = 0.0;  ///< that a controller takes
};

/// A speed as a language writes it.
struct RoundedSpeed {
  SpeedUnit unit;
  double value = 0.0;  ///< in it
};

/// The units in which a language states speeds with few digits, those of beads first; none if it has digits
/// enough.
std::vector<SpeedUnit> speedUnits(RobotLanguage language, const RobotProgramSettings& settings);

/// A speed in the unit of least error; of several, the first.
/// @param units  one at least
/// @throws InvalidInput if none is within 2 %, naming the nearest
RoundedSpeed roundedSpeed(double feed_mm_s, const std::vector<SpeedUnit>& units);

}  // namespace lamina
