// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/orientation/wall_following.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The orientation of one run and what happened on the way to it.
struct RunOrientation {
  AlongPath<Eigen::Quaterniond> orientation;
  std::vector<LimitHit> limits_hit;  ///< `worst` without layer and path
  std::size_t waypoints_without_wall = 0;
};

/// @param walls  of the part, in mode wall; null otherwise
RunOrientation runOrientation(const Path& run, const OrientationSettings& settings, const WallNormals* walls);

}  // namespace lamina
