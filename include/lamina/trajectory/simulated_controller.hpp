// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/joint_servo.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {

/// How the joints of a simulated controller follow what they are asked.
struct ServoSettings {
  double rate_hz = 250.0;
  double lag_s = 0.01;   ///< time constant of each joint; 0 follows at once
  double damping = 0.0;  ///< 0 for a lag of first order; else damping of one of second order, up to 10
  double brake_s = 0.2;  ///< in which a joint at its greatest speed comes to rest; 0 stops dead
};

/// Adds the keys servo.*.
void describe(SettingsSchema& schema, ServoSettings& settings);

/// What goes wrong in a simulated controller.
struct ControllerFaults {
  std::optional<std::size_t> late_chunk;  ///< index of the chunk that is late, and all behind it, from 0
  double late_s = 0.0;
  std::optional<double> stop_s;  ///< when the joints stop dead and follow no more
};

/// How well a simulated controller was fed, and has followed.
struct TrackingReport {
  std::size_t cycles = 0;
  JointValues greatest;  ///< of each joint, asked less actual [mm, rad]
  JointValues rms;
  double tip_greatest_mm = 0.0;
  double tip_rms_mm = 0.0;
  std::size_t starvations = 0;  ///< times there was nothing to follow while moving
  double least_queue_s = 0.0;   ///< least motion waiting while more was to come; infinite if never
  bool is_stopped = false;      ///< by a fault
};

/// A controller that interpolates queued points by cubics through positions and velocities, at its rate, with
/// joints that lag behind. With nothing left to follow while moving, it brakes, and dead at a joint's limit.
/// Deterministic: time is that of the clock, and what happens at a cycle depends on
/// what has been accepted before `advance` reaches it.
class SimulatedController {
 public:
  /// Clock and kinematic model must outlive it. It starts at the clock's time, at rest at `start`.
  /// @throws InvalidConfig naming key, value and bound
  SimulatedController(const Clock& clock, const KinematicModel& model, const ServoSettings& settings,
                      const JointValues& start, const ControllerFaults& faults = {});

  /// Takes points; those it has at or after the first of them are dropped.
  void accept(const TrajectoryChunk& chunk);
  /// Drops what it has, and brakes from where the joints are to be in the last cycle.
  void brake();
  /// Runs all cycles up to the clock's time.
  void advance();

  /// Where the joints are to be, in the last cycle.
  const JointValues& wanted() const { return wanted_; }
  const JointValues& position() const { return servo_.position(); }
  const JointValues& velocity() const { return servo_.velocity(); }
  /// Of the point that is followed; safe when starved or stopped.
  const ProcessSignals& process() const { return process_; }
  /// Motion that is waiting [s].
  double queued() const;
  /// When it will have nothing left to follow while moving [s]; nothing if what it has ends at rest.
  std::optional<double> runsOutAt() const;
  TrackingReport report() const;

 private:
  struct Late {
    double arrival_s = 0.0;
    TrajectoryChunk chunk;
  };
  void enqueue(const TrajectoryChunk& chunk);
  void receiveLate(double time_s);
  void cycle(double time_s);
  JointValues asked(double time_s);
  void pass(double time_s);
  void brakeFrom(JointState moving);
  void measure(const JointValues& asked);

  const Clock& clock_;
  const KinematicModel& model_;
  ServoSettings settings_;
  ControllerFaults faults_;
  std::deque<JointState> points_;  ///< the first is the last one passed
  std::vector<Late> late_;
  double start_s_;
  std::size_t cycles_ = 0;
  std::size_t accepted_ = 0;
  JointValues wanted_;
  JointServo servo_;
  ProcessSignals process_;
  TrackingReport report_;
  JointValues squares_;
  double tip_squares_ = 0.0;
};

}  // namespace lamina
