// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Differences between the speeds of a program and those of its toolpath, as its language writes few digits.
struct SpeedRounding {
  std::size_t motions = 0;    ///< number of motions whose speed is off by more than 0.01 %
  double greatest_share = 0;  ///< greatest difference, as a share of the speed
  double feed_mm_s = 0.0;     ///< speed in the toolpath where that difference occurs
  double written_mm_s = 0.0;  ///< speed that is written there
};

/// The rounding of Fanuc's listings and INFORM. For KRL and URScript, which resolve um/s, all zero.
/// @throws InvalidInput if a feed cannot be written within 2 %
SpeedRounding speedRounding(const Toolpath& toolpath, RobotLanguage language,
                            const RobotProgramSettings& settings);

}  // namespace lamina
