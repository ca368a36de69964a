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

/// How the joints of a simulated controller follow their commanded positions.
struct ServoSettings {
  double rate_hz = 250.0;  ///< cycles per second
  double lag_s = 0.01;     ///< time constant of each joint; 0 for joints that follow at once
  /// 0 for a lag of first order; else the damping ratio of one of second order, up to 10.
  double damping = 0.0;
  double brake_s = 0.2;  ///< time in which a joint comes to rest from its greatest speed; 0 for at once
};

/// Adds the keys servo.*.
void describe(SettingsSchema& schema, ServoSettings& settings);

/// Faults of a simulated controller.
struct ControllerFaults {
  /// Index, from 0, of a chunk that is late; later chunks wait for it.
  std::optional<std::size_t> late_chunk;
  double late_s = 0.0;           ///< time by which it is late
  std::optional<double> stop_s;  ///< time at which the joints stop at once, for good
};

/// How well a simulated controller was supplied with points, and has followed them.
struct TrackingReport {
  std::size_t cycles = 0;
  JointValues greatest;          ///< greatest error of each joint, commanded less actual [mm, rad]
  JointValues rms;               ///< root mean square of that error
  double tip_greatest_mm = 0.0;  ///< greatest distance of the tip from its commanded position
  double tip_rms_mm = 0.0;       ///< root mean square of that distance
  std::size_t starvations = 0;   ///< times that points ran out in motion
  double least_queue_s = 0.0;    ///< least queued motion while more was to come; infinite if none ever was
  bool is_stopped = false;       ///< whether a fault has stopped the joints
};

/// Simulates a controller that interpolates queued points by cubic polynomials through their positions and
/// velocities, cycle by cycle, with joints that lag behind. If the points run out in motion it brakes, hard
/// enough that no joint passes its limits. Deterministic: time is that of the clock, and a cycle depends only
/// on the points that were accepted before `advance` reaches it.
class SimulatedController {
 public:
  /// Starts at the clock's present time, at rest at `start`. Clock and kinematic model must outlive it.
  /// @throws InvalidConfig naming key, value and bound
  SimulatedController(const Clock& clock, const KinematicModel& model, const ServoSettings& settings,
                      const JointValues& start, const ControllerFaults& faults = {});

  /// Queues points, which replace queued points from the time of the first new point on.
  void accept(const TrajectoryChunk& chunk);
  /// Discards the queue, and brakes from the commanded positions of the last cycle.
  void brake();
  /// Runs all cycles up to the clock's present time.
  void advance();

  /// Commanded positions of the joints in the last cycle.
  const JointValues& wanted() const { return wanted_; }
  const JointValues& position() const { return servo_.position(); }  ///< actual
  const JointValues& velocity() const { return servo_.velocity(); }  ///< actual
  /// Process signals of the point that is followed; those of `safeSignals` while it brakes or is stopped.
  const ProcessSignals& process() const { return process_; }
  /// Duration of the queued motion [s].
  double queued() const;
  /// Time at which the points will run out in motion [s]; nothing if they end at rest.
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
  std::deque<JointState> points_;  ///< the last point passed, and the queue
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
