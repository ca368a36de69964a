// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/program/robot/robot_program_settings.hpp"

namespace lamina {

/// A unit in which a language writes speeds, with a fixed number of decimals.
struct SpeedUnit {
  std::string name;       ///< as written: "mm/sec"
  double mm_s = 1.0;      ///< speed of one such unit
  double step = 1.0;      ///< value of the last decimal, in this unit
  double greatest = 0.0;  ///< greatest value that a controller accepts, in this unit
};

/// A speed as a language writes it.
struct RoundedSpeed {
  SpeedUnit unit;
  double value = 0.0;  ///< in that unit
};

/// The units in which a language writes speeds with few digits, those for beads first; empty if the language
/// writes enough digits for any speed.
std::vector<SpeedUnit> speedUnits(RobotLanguage language, const RobotProgramSettings& settings);

/// A speed in the unit with the least rounding error; of several, the first.
/// @param units  not empty
/// @throws InvalidInput naming the nearest speed if none is within 2 %
RoundedSpeed roundedSpeed(double feed_mm_s, const std::vector<SpeedUnit>& units);

}  // namespace lamina
