// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Where joints are to be at one instant, and how fast.
struct JointTarget {
  JointValues position;  ///< [mm, rad]
  JointValues velocity;  ///< [mm/s, rad/s]
};

/// What a controller is given in a cycle.
struct CyclicTarget {
  std::int64_t cycle = 0;  ///< counted from 1; one that is left out was missed
  JointTarget now;
  JointTarget ahead;  ///< what is planned for `CyclicSink::ahead` later
};

/// A controller that takes a target of the joints each cycle, and stops when none comes.
class CyclicSink {
 public:
  virtual ~CyclicSink() = default;

  virtual double cycle() const = 0;  ///< [s]
  /// How far ahead it is given the plan, to follow it where targets are late or lost [s].
  virtual double ahead() const = 0;
  /// Never waits, and takes no memory from the heap.
  virtual void send(const CyclicTarget& target) = 0;
  /// No target comes any more: the controller brakes by itself.
  virtual void stop() = 0;
};

}  // namespace lamina
