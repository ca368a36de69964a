// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/stated_joints.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kinematics/joint_path/station_joints.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"

namespace lamina {
namespace {

constexpr double kLinearDecimals = 1e-3;  // mm: of a program, through the levers of its rotary joints
constexpr double kRotaryDecimals = 1e-6;  // rad

/// A fault and where it stands among the waypoints.
struct PlacedFault {
  std::size_t index = 0;
  FaultyWaypoint fault;
};

void putToLimits(JointValues& values, const std::vector<DrivenJoint>& joints) {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    double& value = values[static_cast<Eigen::Index>(j)];
    const double within = std::clamp(value, joints[j].low, joints[j].high);
    const double decimals = joints[j].kind == JointKind::Linear ? kLinearDecimals : kRotaryDecimals;
    if (std::abs(value - within) <= decimals) value = within;
  }
}

/// What is wrong with the turn of a joint on one motion that deposits.
std::optional<std::string> jumpFault(const JointValues& from, const JointValues& to,
                                     const std::vector<JointRange>& ranges, const KinematicModel& model,
                                     double most_turn_deg) {
  for (std::size_t j = 0; j < ranges.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    const double turn = std::abs(to[index] - from[index]);
    if (!ranges[j].is_rotary || turn <= toRadians(most_turn_deg) + kRotaryDecimals) continue;
    return "joint " + model.joints()[j].name + " turns from " + jointValueText(ranges[j], from[index]) +
           " to " + jointValueText(ranges[j], to[index]) + " in one motion that deposits; at most " +
           angleText(toRadians(most_turn_deg));
  }
  return std::nullopt;
}

bool isDeposition(const Toolpath& toolpath, const WaypointIndex& from, const WaypointIndex& to) {
  if (from.layer != to.layer || from.path != to.path) return false;
  return toolpath.layers[to.layer].paths[to.path].role != PathRole::Travel;
}

class StatedJudge {
 public:
  StatedJudge(const JointPath& stated, const Toolpath& toolpath, const KinematicModel& model,
              const JointPathSettings& settings)
      : stated_(stated),
        toolpath_(toolpath),
        model_(model),
        settings_(settings),
        ranges_(jointRanges(model.joints())) {}

  std::vector<FaultyWaypoint> faults() {
    addKnown();
    for (std::size_t i = 0; i < stated_.at.size(); ++i) addAt(i);
    addSlow();
    std::stable_sort(found_.begin(), found_.end(),
                     [](const PlacedFault& a, const PlacedFault& b) { return a.index < b.index; });
    std::vector<FaultyWaypoint> faults;
    faults.reserve(found_.size());
    for (PlacedFault& each : found_) faults.push_back(std::move(each.fault));
    return faults;
  }

 private:
  void add(std::size_t index, JointFault fault, std::string reason) {
    found_.push_back({index, {stated_.at[index], fault, std::move(reason)}});
  }

  /// Those that came with the joints are in the order of the motion, too.
  void addKnown() {
    std::size_t i = 0;
    for (const FaultyWaypoint& known : stated_.faults) {
      while (i + 1 < stated_.at.size() && stated_.at[i] != known.at) ++i;
      found_.push_back({i, known});
    }
  }

  void addAt(std::size_t i) {
    const JointValues& values = stated_.values[i];
    if (values.size() == 0) return;
    if (const auto fault = limitFault(values, model_)) add(i, JointFault::OutOfLimits, *fault);
    if (i == 0 || stated_.values[i - 1].size() == 0) return;
    if (!isDeposition(toolpath_, stated_.at[i - 1], stated_.at[i])) return;
    if (const auto fault = jumpFault(stated_.values[i - 1], values, ranges_, model_, settings_.max_turn_deg))
      add(i, JointFault::Jump, *fault);
  }

  void addSlow() {
    const StationList list = stationsOf(toolpath_, Eigen::Isometry3d::Identity(), {});
    std::vector<StationJoints> joints(list.stations.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i].values = stated_.values[list.waypoint_of[i]];
      joints[i].is_linked = i > 0 && joints[i].values.size() > 0 && joints[i - 1].values.size() > 0;
    }
    const NoGuard nobody;
    const RungSolver solver({model_, nobody}, settings_);
    for (StationFault& slow : slowPassages(joints, {list.stations, model_, solver, settings_}))
      add(list.waypoint_of[slow.station], slow.fault, std::move(slow.reason));
  }

  const JointPath& stated_;
  const Toolpath& toolpath_;
  const KinematicModel& model_;
  const JointPathSettings& settings_;
  std::vector<JointRange> ranges_;
  std::vector<PlacedFault> found_;
};

}  // namespace

std::optional<std::string> statedLimitFault(JointValues values, const KinematicModel& model) {
  putToLimits(values, model.joints());
  return limitFault(values, model);
}

JointPath judged(JointPath stated, const Toolpath& toolpath, const KinematicModel& model,
                 const JointPathSettings& settings) {
  for (JointValues& values : stated.values)
    if (values.size() > 0) putToLimits(values, model.joints());
  std::vector<FaultyWaypoint> faults = StatedJudge(stated, toolpath, model, settings).faults();
  stated.faults = std::move(faults);
  return stated;
}

}  // namespace lamina
