// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/joint_braking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {

double brakeTime(const JointValues& velocity, const std::vector<DrivenJoint>& joints, double brake_s) {
  double time_s = 0.0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double speed = velocity[static_cast<Eigen::Index>(j)];
    if (speed != 0.0) time_s = std::max(time_s, brake_s * std::abs(speed) / joints[j].max_speed);
  }
  return time_s;
}

double brakeRoom(const JointValues& position, const JointValues& velocity,
                 const std::vector<DrivenJoint>& joints) {
  double time_s = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double speed = velocity[i];
    if (speed == 0.0) continue;
    const double room = speed > 0.0 ? joints[j].high - position[i] : position[i] - joints[j].low;
    time_s = std::min(time_s, 2.0 * std::max(0.0, room) / std::abs(speed));
  }
  return time_s;
}

}  // namespace lamina
