// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "lamina/servo/cyclic_sink.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina::test {

/// Six rotary joints between -3 and 3 rad, of 2 rad/s at most.
inline std::vector<DrivenJoint> sixJoints() {
  std::vector<DrivenJoint> joints;
  for (int j = 1; j <= 6; ++j)
    joints.push_back({"joint_" + std::to_string(j), JointKind::Rotary, -3.0, 3.0, 2.0});
  return joints;
}

inline JointValues sixValues(double first, double second = 0.0) {
  JointValues values = JointValues::Zero(6);
  values.head<2>() << first, second;
  return values;
}

inline JointState jointPoint(double time_s, const JointValues& position, const JointValues& velocity) {
  JointState state;
  state.time_s = time_s;
  state.position = position;
  state.velocity = velocity;
  return state;
}

/// Points of a motion at even steps from one time to another, both of them.
inline TrajectoryChunk sampledChunk(const std::function<JointState(double)>& motion, double begin_s,
                                    double end_s, double step_s) {
  TrajectoryChunk chunk;
  const auto steps = static_cast<int>(std::lround((end_s - begin_s) / step_s));
  for (int i = 0; i <= steps; ++i) chunk.points.push_back(motion(begin_s + i * step_s));
  return chunk;
}

/// The first joint goes steadily by 1 rad/s, and is at 0 at time 0.
inline JointState steadily(double time_s) { return jointPoint(time_s, sixValues(time_s), sixValues(1.0)); }

/// The first two joints go round a circle of 0.5 rad about 0, once in 2 pi s.
inline JointState round(double time_s) {
  const double c = 0.5 * std::cos(time_s);
  const double s = 0.5 * std::sin(time_s);
  return jointPoint(time_s, sixValues(c, s), sixValues(-s, c));
}

}  // namespace lamina::test
