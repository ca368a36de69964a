// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "playback.hpp"

namespace lamina {
namespace {

class LinearPlayback : public Playback {
 public:
  LinearPlayback(const MachineToolpath& placed, const CartesianMachine& machine, const MotionLimits& limits)
      : placed_(placed),
        machine_(machine),
        time_(estimateTime(placed.toolpath, limits)),
        player_(placed.toolpath, limits),
        layer_player_(placed.toolpath, limits),
        nozzle_player_(placed.toolpath, limits) {}

  const ToolpathTime& time() const override { return time_; }
  double nextWaypointTime() const override { return player_.nextWaypointTime(); }

  JointPositions at(double time_s) override { return positions(player_, time_s); }

  trajectory_msgs::JointTrajectory trajectory(const TimeSpan& span, double step_s) override {
    trajectory_msgs::JointTrajectory message;
    for (const MachineAxis& axis : machine_.axes) message.joint_names.push_back(axis.name);
    for (const double time_s : evenTimes(span.begin_s, span.end_s, step_s)) {
      const JointPositions positions = this->positions(layer_player_, time_s);
      trajectory_msgs::JointTrajectoryPoint point;
      for (const std::string& name : message.joint_names) point.positions.push_back(positions.at(name));
      point.time_from_start = ros::Duration(time_s - span.begin_s);
      message.points.push_back(point);
    }
    return message;
  }

  std::vector<NozzleState> nozzle(const TimeSpan& span, double step_s) override {
    return nozzleStates(evenTimes(span.begin_s, span.end_s, step_s), [this](double time_s) {
      return nozzleState(nozzle_player_.at(time_s), placed_.toolpath, placed_.bed_from_part);
    });
  }

 private:
  JointPositions positions(ToolpathPlayer& player, double time_s) const {
    const AxisValues values = axisValues(machine_, placed_.bed_from_part * player.at(time_s).position);
    JointPositions positions;
    for (std::size_t i = 0; i < machine_.axes.size(); ++i)
      positions[machine_.axes[i].name] = toMetres(values[static_cast<Eigen::Index>(i)]);
    return positions;
  }

  const MachineToolpath& placed_;
  CartesianMachine machine_;
  ToolpathTime time_;
  ToolpathPlayer player_;
  ToolpathPlayer layer_player_;   // goes back to where a layer begins
  ToolpathPlayer nozzle_player_;  // likewise
};

}  // namespace

std::unique_ptr<Playback> linearPlayback(const MachineToolpath& placed, const CartesianMachine& machine,
                                         const MotionLimits& limits) {
  return std::make_unique<LinearPlayback>(placed, machine, limits);
}

}  // namespace lamina
