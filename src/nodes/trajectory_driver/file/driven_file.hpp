// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "conversions.hpp"
#include "drive_session.hpp"
#include "file/waypoint_count.hpp"
#include "lamina/kinematics/joint_path/motion_division.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "messages.hpp"

namespace lamina {

/// The toolpath of a goal's file, placed on the bed as the goal says.
/// @throws InvalidInput if the placement is not known; as `readToolpathOnBed`
MachineToolpath toolpathOfFile(const lamina_msgs::DriveToolpathGoal& goal, const MachineSettings& machine);

/// Progress in the file of a goal. Replanned layers are no longer those of the file: from then on waypoints
/// are not counted, until the end.
class DrivenFile {
 public:
  explicit DrivenFile(const MachineToolpath& placed) : toolpath_id_(placed.id), count_(placed.toolpath) {}

  const std::string& toolpathId() const { return toolpath_id_; }
  const WaypointCount& count() const { return count_; }

  /// Sets the toolpath that is driven from now on, with the waypoints of the file; null for any other motion,
  /// such as the approach. The toolpath must outlive its use.
  void follow(const DividedToolpath* driven) { driven_ = driven; }
  void see(const DriveStatus& status);
  void complete() { count_.complete(); }

 private:
  std::string toolpath_id_;
  WaypointCount count_;
  const DividedToolpath* driven_ = nullptr;
};

/// A job's place in its file, in waypoints, on the state that is published; nothing without a file.
void count(const std::optional<DrivenFile>& file, lamina_msgs::MachineState& message);

}  // namespace lamina
