// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <mutex>
#include <string>
#include <vector>

#include "conversions.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/verification/collision/clearance.hpp"
#include "lamina/verification/overhang/overhang.hpp"
#include "messages.hpp"

namespace lamina {

/// Slices parts on request.
///
/// Services    slice_mesh (lamina/SliceMesh)
/// Actions     slice (lamina/Slice): the same with progress and cancel; a new goal cancels the one under way
/// Publishes   toolpath (lamina/Toolpath, latched), and as visualization_msgs/MarkerArray, latched:
///             toolpath_markers;
///             overhang_markers, what is deposited with nothing below it: empty unless overhang.report says
///             so; collision_markers, where the machine collides: empty unless clearance.report says so;
///             frame_markers, how the nozzle is held: empty unless frames.every_mm is set;
///             refusal_markers, which region of a part stands in the way of slicing it: empty when it is
///             sliced
///
/// One part at a time: a request during another one is answered with REJECTED. A request that fails writes
/// nothing, and publishes nothing but refusal_markers if a region of the part is the reason.
class SlicingService {
 public:
  /// @param settings  of every job, as far as its request does not override them
  SlicingService(ros::NodeHandle node, const JobSettings& settings);

 private:
  /// What the service's request and the action's goal have in common, and what their answers have.
  struct Request {
    std::string part;
    std::vector<lamina_msgs::Setting> settings;
    std::string output;
    std::string material;  ///< name of a profile; empty for none
    std::string process;
    bool is_file_only = false;  ///< whether nothing is published
  };
  struct Answer {
    lamina_msgs::Status status;
    std::string toolpath_id;
    lamina_msgs::SliceSummary summary;
  };

  /// Findings in a toolpath; empty unless requested.
  struct Findings {
    OverhangReport overhangs;
    ClearanceReport clearance;
  };

  bool onService(lamina_msgs::SliceMesh::Request& request, lamina_msgs::SliceMesh::Response& response);
  void onGoal(const lamina_msgs::SliceGoalConstPtr& goal);
  Answer answer(const Request& request, Progress& progress);
  Answer slice(const Request& request, Progress& progress);
  /// The node's settings with those of the request.
  JobSettings settingsOf(const Request& request) const;
  /// Shows the region of a part that cannot be sliced.
  SlicedPart runShown(const SliceJob& job, Progress& progress);
  static Findings find(const SlicedPart& sliced, const JobSettings& settings, Progress& progress);
  void publish(const MachineToolpath& placed, const Findings& findings, const FrameSettings& frames);

  JobSettings settings_;
  std::mutex job_;
  ros::Publisher toolpath_;
  ros::Publisher markers_;
  ros::Publisher overhang_markers_;
  ros::Publisher collision_markers_;
  ros::Publisher frame_markers_;
  ros::Publisher refusal_markers_;
  ros::ServiceServer service_;
  actionlib::SimpleActionServer<lamina_msgs::SliceAction> action_;
};

}  // namespace lamina
