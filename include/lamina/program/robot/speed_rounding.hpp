// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How far the speeds of a program are off those of its toolpath, because its language writes few digits.
struct SpeedRounding {
  std::size_t motions = 0;    ///< whose speed is off by more than 0.01 %
  double greatest_share = 0;  ///< of a speed
  double feed_mm_s = 0.0;     ///< that it is of
  double written_mm_s = 0.0;  ///< what stands in its place
};

/// Of Fanuc's listings and INFORM. KRL and URScript write um/s, and round nothing that counts.
/// @throws InvalidInput if a feed cannot be written within 2 %
SpeedRounding speedRounding(const Toolpath& toolpath, RobotLanguage language,
                            const RobotProgramSettings& settings);

}  // namespace lamina
