// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Commanded positions and velocities of the joints at one instant.
struct JointTarget {
  JointValues position;  ///< [mm, rad]
  JointValues velocity;  ///< [mm/s, rad/s]
};

/// What a controller gets in a cycle.
struct CyclicTarget {
  std::int64_t cycle = 0;  ///< number of the cycle, from 1; a gap in the numbers means missed cycles
  JointTarget now;         ///< for this cycle
  JointTarget ahead;       ///< planned for the time `CyclicSink::ahead` later
};

/// Interface of a controller that needs a target of the joints each cycle, and stops if none arrives.
class CyclicSink {
 public:
  virtual ~CyclicSink() = default;

  virtual double cycle() const = 0;  ///< duration of a cycle [s]
  /// Lead time of `CyclicTarget::ahead` [s], for which the controller can bridge late or lost targets.
  virtual double ahead() const = 0;
  /// Sends a target. Never blocks, and allocates no memory.
  virtual void send(const CyclicTarget& target) = 0;
  /// States that no more targets come; the controller then brakes by itself.
  virtual void stop() = 0;
};

}  // namespace lamina
