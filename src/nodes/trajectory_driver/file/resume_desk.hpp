// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
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

/// Where jobs that were cut off are resumed, by where the machine came to rest; the service resume_place. It
/// answers in a thread of its own, as large files take their time. All other calls may come from several
/// threads.
class ResumeDesk {
 public:
  /// All that is referred to must outlive it.
  /// @param is_driving  whether a job is under way, in which nothing is asked for
  ResumeDesk(const ros::NodeHandle& node, const DriverSettings& settings, const KinematicModel& model,
             const PresentJoints& joints, std::function<bool()> is_driving);

  /// The machine is moved from where it rests, by hand or to the start of a job: there the last job came to
  /// rest, unless it was moved before.
  void depart(const JointValues& here);
  /// A job moves the machine, and has come to its start.
  void forget();

  /// The length of beads [mm] that a goal leaves out, and with `resume` all that is known of it in the log.
  /// @return nothing if it is driven from its start
  /// @throws InvalidInput if the toolpath has no such waypoint, or a goal with `resume` is none of a file, or
  ///   dry, or its layers may have been planned anew
  std::optional<ResumePlace> placeOf(const lamina_msgs::DriveToolpathGoal& goal,
                                     const MachineToolpath& placed) const;

 private:
  /// Another one of the same name differs in size or time.
  struct FileKey {
    std::string name;  ///< with its placement
    std::uintmax_t size = 0;
    std::filesystem::file_time_type written;
    bool operator==(const FileKey& other) const {
      return name == other.name && size == other.size && written == other.written;
    }
  };
  struct ReadFile {
    FileKey key;
    Eigen::Isometry3d bed_from_part;
    LaidBeads beads;
  };
  static FileKey keyOf(const lamina_msgs::ResumePlace::Request& request);
  std::shared_ptr<const ReadFile> fileOf(const lamina_msgs::ResumePlace::Request& request);
  bool onAsked(lamina_msgs::ResumePlace::Request& request, lamina_msgs::ResumePlace::Response& response);
  ResumePlace placeBy(const LaidBeads& beads, const Eigen::Isometry3d& bed_from_part, double laid_m,
                      double wait_s) const;
  JointValues rest(double wait_s) const;
  void requireResumable() const;

  const DriverSettings& settings_;
  const KinematicModel& model_;
  const PresentJoints& joints_;
  std::function<bool()> is_driving_;
  mutable std::mutex mutex_;
  std::optional<JointValues> rested_;     ///< before it was moved; guarded by it
  std::shared_ptr<const ReadFile> read_;  ///< that was asked for last; of the service's thread alone
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  // Last, so that its thread ends before what it uses.
  ros::AsyncSpinner spinner_;
};

}  // namespace lamina
