// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/tool_lift.hpp"

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "trajectory/pose_correction.hpp"

namespace lamina {
namespace {

constexpr double kStep = 1.0;         // mm
constexpr double kOnTheLimit = 1e-9;  // mm, rad: what rounding leaves

void requireWithinLimits(const JointValues& values, const Mechanism& mechanism) {
  for (std::size_t j = 0; j < mechanism.joints().size(); ++j) {
    const DrivenJoint& joint = mechanism.joints()[j];
    const double value = values[static_cast<Eigen::Index>(j)];
    const char* unit = joint.kind == JointKind::Linear ? " mm" : " rad";
    if (!(value >= joint.low - kOnTheLimit && value <= joint.high + kOnTheLimit))
      throw Unreachable("lifting the tool takes joint " + joint.name + " to " + std::to_string(value) + unit +
                        "; must be within " + std::to_string(joint.low) + " to " +
                        std::to_string(joint.high) + unit);
  }
}

}  // namespace

std::shared_ptr<const TimedMotion> toolLift(const JointValues& from, const ToolLift& lift,
                                            const Mechanism& mechanism, const TimingSettings& settings) {
  if (!(lift.height_mm > 0.0 && lift.speed_mm_s > 0.0))
    throw InvalidInput("the tool is to be lifted by " + std::to_string(lift.height_mm) + " mm at " +
                       std::to_string(lift.speed_mm_s) + " mm/s; both must be positive");
  const PoseCorrection correction(mechanism, settings.trajectory);
  JointStation station;
  station.values = from;
  station.pose = mechanism.bedFromNozzle(from);
  const Eigen::Isometry3d start = station.pose;
  const auto steps = static_cast<int>(std::ceil(lift.height_mm / kStep));
  JointStations stations;
  stations.each.push_back(station);
  for (int i = 1; i <= steps; ++i) {
    Eigen::Isometry3d asked = start;
    asked.translation() -= start.linear().col(2) * (lift.height_mm * i / steps);
    const auto values = correction.near(station.values, asked, PoseCorrection::Keep::TipAndJet);
    if (!values) throw Unreachable("the tool cannot be lifted straight from where it is");
    requireWithinLimits(*values, mechanism);
    station.values = *values;
    station.pose = mechanism.bedFromNozzle(*values);
    station.length_mm = lift.height_mm / steps;
    station.feed_mm_s = lift.speed_mm_s;
    station.acceleration_mm_s2 = settings.motion.travel_acceleration_mm_s2;
    station.is_smooth = true;
    stations.each.push_back(station);
  }
  TimingSettings timing = settings;
  timing.process = {};
  return std::make_shared<const TimedMotion>(std::move(stations), mechanism, timing);
}

}  // namespace lamina
