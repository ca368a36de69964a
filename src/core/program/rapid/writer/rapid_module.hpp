// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/program/rapid/rapid_settings.hpp"
#include "program/rapid/writer/rapid_speeds.hpp"

namespace lamina {

/// What the head of a program's main module reports.
struct RapidHead {
  std::string part_name;
  std::string frame_comments;                                       ///< as `frameComments`
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of the start point, bed_from_nozzle
  std::vector<std::string> modules;                                 ///< besides main
  std::vector<std::string> procedures;
};

/// The declarations and the procedures besides those of the points.
std::string rapidHead(const RapidHead& head, const RapidSpeeds& speeds, const RapidSettings& settings);

}  // namespace lamina
