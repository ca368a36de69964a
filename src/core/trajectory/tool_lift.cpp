// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/tool_lift.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "trajectory/straight_lift.hpp"

namespace lamina {
std::shared_ptr<const TimedMotion> toolLift(const JointValues& from, const ToolLift& lift,
                                            const KinematicModel& model, const TimingSettings& settings) {
  if (!(lift.height_mm > 0.0 && lift.speed_mm_s > 0.0))
    throw InvalidInput("the tool is to be lifted by " + std::to_string(lift.height_mm) + " mm at " +
                       std::to_string(lift.speed_mm_s) + " mm/s; both must be positive");
  const StraightLift way = straightLift(from, lift.height_mm, model, settings.trajectory);
  if (!way.stopped_by.empty())
    throw Unreachable("the tool can be lifted by " +
                      std::to_string(way.step_mm * static_cast<double>(way.values.size() - 1)) + " mm of " +
                      std::to_string(lift.height_mm) + " mm only: " + way.stopped_by);
  JointStations stations;
  for (const JointValues& values : way.values) {
    JointStation station;
    station.values = values;
    station.pose = model.bedFromNozzle(values);
    if (!stations.each.empty()) {
      station.length_mm = way.step_mm;
      station.feed_mm_s = lift.speed_mm_s;
      station.acceleration_mm_s2 = settings.motion.travel_acceleration_mm_s2;
      station.is_smooth = true;
    }
    stations.each.push_back(station);
  }
  TimingSettings timing = settings;
  timing.process = {};
  return std::make_shared<const TimedMotion>(std::move(stations), model, timing);
}

}  // namespace lamina
