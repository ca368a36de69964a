// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "controller_client.hpp"
#include "conversions.hpp"
#include "drive_job.hpp"
#include "drive_session.hpp"
#include "driver_settings.hpp"
#include "file/driven_file.hpp"
#include "file/resume_desk.hpp"
#include "job_overrides.hpp"
#include "jog_driver.hpp"
#include "lamina/streaming/guard/pulse_link.hpp"
#include "messages.hpp"
#include "node_diagnostics.hpp"
#include "owner/action_gate.hpp"
#include "owner/executor_owner.hpp"
#include "owner/owner_watch.hpp"
#include "part_markers.hpp"
#include "present_joints.hpp"
#include "process_io_watch.hpp"
#include "process_publisher.hpp"
#include "work_beside.hpp"

namespace lamina {

/// Runs toolpaths on a machine or robot whose controller follows joint trajectories: in chunks with
/// look-ahead, the process in step. Its action, services and topics: docs/nodes/trajectory_driver.md.
///
/// One job at a time: a new goal aborts the one under way.
class TrajectoryDriver {
 public:
  /// @throws InvalidConfig if the machine is unknown
  TrajectoryDriver(ros::NodeHandle node, const DriverSettings& settings);

  /// Returns once the machine is at rest and this has been reported; `isStopRequested` aborts a job under
  /// way.
  void awaitRest() const;

 private:
  using Trigger = std_srvs::Trigger;
  using Server = actionlib::SimpleActionServer<lamina_msgs::DriveToolpathAction>;

  void onGoal(const lamina_msgs::DriveToolpathGoalConstPtr& goal);
  /// A job, and the approach to it.
  struct PreparedJob {
    DriveJob job;
    JointValues here;             ///< where the machine stands
    std::optional<Approach> way;  ///< nothing if the machine is at the start
  };
  /// How a motion ended.
  struct Driven {
    DriveStatus status;
    std::optional<PreparedJob> next;  ///< plan with which to continue
  };
  /// A plan that is being prepared.
  struct PlanInWork {
    std::string id;
    std::unique_ptr<WorkBeside<PreparedJob>> result;
  };
  struct HeardMap {
    CorrectionMap map;
    std::string digest;
  };
  /// Whether a job that begins waits for the map of its first layer.
  enum class MapOfFirstLayer { AsItIs, Awaited };

  /// Whether the goal was aborted or preempted, or the node ends.
  bool isCancelled() const;
  DriveStatus drive(const lamina_msgs::DriveToolpathGoal& goal);
  bool isDry() const { return dry_.process() == ProcessUse::Off; }
  PreparedJob prepared(const MachineToolpath& placed, double from_mm, Progress& progress);
  Driven drive(const PreparedJob& prepared, MapOfFirstLayer first_map);
  DriveJob jobOf(const MachineToolpath& placed, Progress& progress);
  MachineToolpath toolpath(const lamina_msgs::DriveToolpathGoal& goal);
  MachineToolpath toolpath(const std::string& id);
  Driven run(const DriveMotion& motion);
  void requireAtStart(const DriveMotion& motion) const;
  std::shared_ptr<ChunkCorrection> correctionOf(const DriveJob& job) const;
  std::optional<PreparedJob> plannedAnew(DriveSession& session, std::optional<PlanInWork>& work);
  bool awaitStep() const;
  void abortIfCancelled(DriveSession& session) const;
  void awaitProcessIo() const;
  void holdIfProcessFails(DriveSession& session) const;
  void holdWithoutOwner(DriveSession& session);
  void goOnWith(const DriveJob& plan);
  void publishToolpath(const MachineToolpath& placed);
  void awaitFirstMap(ChunkCorrection& correction) const;
  std::optional<HeardMap> lastMap() const;
  void correctByLastMap(DriveSession& session, const std::string& toolpath_id) const;
  void onCorrection(const lamina_msgs::CorrectionMap& message);
  /// Reports on applied_correction.
  void tell(const std::vector<DrivenLayer>& layers);
  void onPlan(const lamina_msgs::ToolpathConstPtr& message);
  void show(const DriveStatus& status);
  void publishState(const DriveStatus& status);

  bool onPause(Trigger::Request& request, Trigger::Response& response);
  bool onResume(Trigger::Request& request, Trigger::Response& response);
  bool onAbort(Trigger::Request& request, Trigger::Response& response);
  std::shared_ptr<DriveSession> session() const;
  MachinePulse pulse();
  Eigen::Matrix3d bedFromPart() const;

  DriverSettings settings_;
  ExecutorOwner owner_;
  std::unique_ptr<const KinematicModel> model_;
  ros::Publisher state_;
  ros::Publisher tracking_;
  ros::Publisher progress_;
  PartMarkers part_markers_;
  ros::Publisher findings_;
  ros::Publisher applied_;
  ros::Subscriber toolpath_subscriber_;
  ros::Subscriber correction_;
  ros::Subscriber plan_;
  ros::Publisher
      toolpath_publisher_;  ///< publishes followed plans, and toolpaths of files; advertised with the first
  ros::ServiceServer pause_;
  ros::ServiceServer resume_;
  ros::ServiceServer abort_;
  NodeDiagnostics diagnostics_;
  ros::Timer diagnostics_timer_;
  ProcessPublisher process_;
  ProcessIoWatch process_io_;
  PresentJoints joints_;
  OwnerWatch owner_watch_;
  std::atomic<bool> is_driving_{false};
  std::atomic<bool> is_abort_requested_{false};  ///< of the goal
  ResumeDesk resume_desk_;

  mutable std::mutex mutex_;  ///< of what follows up to the controller
  std::shared_ptr<DriveSession> session_;
  lamina_msgs::ToolpathConstPtr toolpath_;
  std::optional<HeardMap> map_;  ///< the last map received
  DriveStatus status_;

  // State of the goal, used by the thread that drives.
  std::string job_;
  std::optional<DrivenFile> file_;  ///< none if a published toolpath is driven
  double used_mm3_ = 0.0;           ///< of material, before the motion under way
  bool is_ordered_by_cell_ = false;
  bool is_hold_due_ = false;  ///< whether the cell is lost and the job cannot be held yet
  DryOrder dry_;              ///< of the goal under way
  JobOverrides overrides_;
  ControllerClient controller_;
  JogDriver jog_;
  // Last, so that its thread ends before what it uses.
  mutable Server action_;
  ActionGate<lamina_msgs::DriveToolpathAction> gate_;
  PulseSender pulses_;
};

}  // namespace lamina
