// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/approach.hpp"

#include <limits>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"
#include "trajectory/straight_lift.hpp"
#include "trajectory/timed_motion.hpp"

namespace lamina {
namespace {

void requireWithinLimits(const JointValues& values, const KinematicModel& model, const std::string& what) {
  const std::size_t joints = model.joints().size();
  if (values.size() != static_cast<Eigen::Index>(joints) || !values.allFinite())
    throw InvalidInput(what + " is not given by " + std::to_string(joints) + " finite joint values");
  if (const auto fault = limitFault(values, model)) throw Unreachable(what + ": " + *fault);
}

class Way {
 public:
  Way(const JointValues& start, const KinematicModel& model) : model_(model) { add(start, JointStation()); }

  /// The nozzle tip goes on straight.
  void goStraight(const JointValues& to, double speed_mm_s, double acceleration_mm_s2) {
    JointStation station;
    station.length_mm =
        (model_.bedFromNozzle(to).translation() - stations_.each.back().pose.translation()).norm();
    station.feed_mm_s = speed_mm_s;
    station.acceleration_mm_s2 = acceleration_mm_s2;
    station.is_smooth = true;
    add(to, station);
  }

  /// The joints go on in proportion, whatever the tip does.
  void goSteadily(const JointValues& to, double share_of_speed) {
    JointStation station;
    station.feed_mm_s = share_of_speed;  // of a parameter that is the joints' time
    station.acceleration_mm_s2 = std::numeric_limits<double>::infinity();
    add(to, station);
  }

  JointStations take() { return std::move(stations_); }

 private:
  void add(const JointValues& values, JointStation station) {
    station.values = values;
    station.pose = model_.bedFromNozzle(values);
    stations_.of_path.push_back(stations_.each.size());
    stations_.each.push_back(std::move(station));
  }

  const KinematicModel& model_;
  JointStations stations_;
};

}  // namespace

void describe(SettingsSchema& schema, ApproachSettings& settings) {
  schema.number(
      "approach.lift_mm", settings.lift_mm, {0.0, 1e3},
      "How far the nozzle is lifted where the machine stands, and comes down on the start of a job.");
  schema.number("approach.lift_mm_s", settings.lift_mm_s, Bounds::above(0.0, 1e3), "Speed of that.");
  schema.number("approach.joint_speed", settings.joint_speed, Bounds::above(0.0, 1.0),
                "Speed of the joints in between, of their greatest speeds.");
}

Approach approach(const JointValues& from, const JointValues& to, const KinematicModel& model,
                  const ApproachSettings& settings, const TimingSettings& timing) {
  ApproachSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  validate(timing);
  requireWithinLimits(from, model, "where the machine stands");
  requireWithinLimits(to, model, "where the job begins");
  if (from == to) throw InvalidInput("the machine stands where the job begins; expected a way to go");

  const std::vector<JointValues> up = straightLift(from, settings.lift_mm, model, timing.trajectory).values;
  const std::vector<JointValues> down = straightLift(to, settings.lift_mm, model, timing.trajectory).values;
  Way way(from, model);
  const double acceleration = timing.motion.travel_acceleration_mm_s2;
  for (std::size_t i = 1; i < up.size(); ++i) way.goStraight(up[i], settings.lift_mm_s, acceleration);
  if (up.back() != down.back()) way.goSteadily(down.back(), settings.joint_speed);
  for (std::size_t i = down.size() - 1; i-- > 0;) way.goStraight(down[i], settings.lift_mm_s, acceleration);

  Approach approach;
  JointStations stations = way.take();
  for (const JointStation& station : stations.each) approach.stations.push_back(station.values);
  TimingSettings off = timing;
  off.process = {};
  approach.motion =
      std::make_unique<TimedPath>(std::make_shared<const TimedMotion>(std::move(stations), model, off));
  return approach;
}

}  // namespace lamina
