// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/approach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "trajectory/pose_correction.hpp"
#include "trajectory/timed_motion.hpp"

namespace lamina {
namespace {

constexpr double kStep = 1.0;    // mm of a lift
constexpr double kSlack = 1e-6;  // mm, rad: what limits lose on their way through a controller

bool isWithin(const DrivenJoint& joint, double value) {
  return value >= joint.low - kSlack && value <= joint.high + kSlack;
}

void requireWithinLimits(const JointValues& values, const Mechanism& mechanism, const std::string& what) {
  const std::vector<DrivenJoint>& joints = mechanism.joints();
  if (values.size() != static_cast<Eigen::Index>(joints.size()) || !values.allFinite())
    throw InvalidInput(what + " is not given by " + std::to_string(joints.size()) + " finite joint values");
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    if (isWithin(joints[j], value)) continue;
    throw Unreachable("joint '" + joints[j].name + "' is at " + std::to_string(value) + " at " + what +
                      "; its limits are " + std::to_string(joints[j].low) + " and " +
                      std::to_string(joints[j].high));
  }
}

bool areWithinLimits(const JointValues& values, const Mechanism& mechanism) {
  for (std::size_t j = 0; j < mechanism.joints().size(); ++j)
    if (!isWithin(mechanism.joints()[j], values[static_cast<Eigen::Index>(j)])) return false;
  return true;
}

/// From `start` on against the jet, step by step as far as it goes.
std::vector<JointValues> lift(const JointValues& start, double height_mm, const Mechanism& mechanism,
                              const TrajectorySettings& settings) {
  const PoseCorrection correction(mechanism, settings);
  const Eigen::Isometry3d from = mechanism.bedFromNozzle(start);
  const auto steps = static_cast<int>(std::ceil(height_mm / kStep));
  std::vector<JointValues> values{start};
  for (int i = 1; i <= steps; ++i) {
    Eigen::Isometry3d asked = from;
    asked.translation() -= from.linear().col(2) * (height_mm * i / steps);
    const auto next = correction.near(values.back(), asked, PoseCorrection::Keep::TipAndJet);
    if (!next || !areWithinLimits(*next, mechanism)) break;
    values.push_back(*next);
  }
  return values;
}

class Way {
 public:
  Way(const JointValues& start, const Mechanism& mechanism) : mechanism_(mechanism) {
    add(start, JointStation());
  }

  /// The nozzle tip goes on straight.
  void goStraight(const JointValues& to, double speed_mm_s, double acceleration_mm_s2) {
    JointStation station;
    station.length_mm =
        (mechanism_.bedFromNozzle(to).translation() - stations_.each.back().pose.translation()).norm();
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
    station.pose = mechanism_.bedFromNozzle(values);
    stations_.of_path.push_back(stations_.each.size());
    stations_.each.push_back(std::move(station));
  }

  const Mechanism& mechanism_;
  JointStations stations_;
};

}  // namespace

void describe(SettingsSchema& schema, ApproachSettings& settings) {
  schema.number(
      "approach.lift_mm", settings.lift_mm, {0.0, 1e3},
      "How far the nozzle is lifted where the machine stands, and comes down on the start of a job.");
  schema.number("approach.lift_mm_s", settings.lift_mm_s, {0.0, 1e3, true}, "Speed of that.");
  schema.number("approach.joint_speed", settings.joint_speed, {0.0, 1.0, true},
                "Speed of the joints in between, of their greatest speeds.");
}

Approach approach(const JointValues& from, const JointValues& to, const Mechanism& mechanism,
                  const ApproachSettings& settings, const TimingSettings& timing) {
  ApproachSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  validate(timing);
  requireWithinLimits(from, mechanism, "where the machine stands");
  requireWithinLimits(to, mechanism, "where the job begins");
  if (from == to) throw InvalidInput("the machine stands where the job begins; expected a way to go");

  const std::vector<JointValues> up = lift(from, settings.lift_mm, mechanism, timing.trajectory);
  const std::vector<JointValues> down = lift(to, settings.lift_mm, mechanism, timing.trajectory);
  Way way(from, mechanism);
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
      std::make_unique<TimedPath>(std::make_shared<const TimedMotion>(std::move(stations), mechanism, off));
  return approach;
}

}  // namespace lamina
