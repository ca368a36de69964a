// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>
#include <string>

#include "conversions.hpp"
#include "driver_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/laid_beads.hpp"
#include "lamina/toolpath/resume_place.hpp"
#include "messages.hpp"
#include "present_joints.hpp"

namespace lamina {

/// Where jobs that were cut off are resumed, by where the machine came to rest; the service resume_place.
/// Its calls may come from several threads.
class ResumeDesk {
 public:
  /// All that is referred to must outlive it.
  ResumeDesk(ros::NodeHandle& node, const DriverSettings& settings, const KinematicModel& model,
             const PresentJoints& joints);

  /// The machine is moved by hand from where it rests: there the last job came to rest, unless it was moved
  /// before.
  void depart(const JointValues& here);
  /// A job moves the machine.
  void forget();

  /// The length of beads [mm] that a goal leaves out, and with `resume` all that is known of it in the log.
  /// @return nothing if it is driven from its start
  /// @throws InvalidInput if the toolpath has no such waypoint, or a goal with `resume` is none of a file, or
  ///   dry, or its layers may have been planned anew
  std::optional<ResumePlace> placeOf(const lamina_msgs::DriveToolpathGoal& goal,
                                     const MachineToolpath& placed) const;

 private:
  struct ReadFile {
    std::string name;  ///< with its placement
    Eigen::Isometry3d bed_from_part;
    LaidBeads beads;
  };
  bool onAsked(lamina_msgs::ResumePlace::Request& request, lamina_msgs::ResumePlace::Response& response);
  ResumePlace placeBy(const LaidBeads& beads, const Eigen::Isometry3d& bed_from_part, double laid_m,
                      double wait_s) const;
  JointValues rest(double wait_s) const;
  void requireResumable() const;

  const DriverSettings& settings_;
  const KinematicModel& model_;
  const PresentJoints& joints_;
  mutable std::mutex mutex_;           ///< of what follows
  std::optional<JointValues> rested_;  ///< before it was moved by hand
  std::optional<ReadFile> read_;       ///< that was asked for last
  ros::ServiceServer server_;
};

}  // namespace lamina
