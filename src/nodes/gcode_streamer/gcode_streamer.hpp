// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "conversions.hpp"
#include "corrected_stream.hpp"
#include "correction_reports.hpp"
#include "dry_program.hpp"
#include "job_alarms.hpp"
#include "laid_lines.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/streaming/guard/pulse_link.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "messages.hpp"
#include "node_diagnostics.hpp"
#include "owner/action_gate.hpp"
#include "owner/executor_owner.hpp"
#include "owner/owner_watch.hpp"
#include "recorded_program.hpp"
#include "startup_service.hpp"
#include "stream_report.hpp"
#include "streamer_settings.hpp"
#include "toolpath_programs.hpp"

namespace lamina {

/// Streams programs to a machine on request: a G-code file, or the toolpath published last. Its action,
/// services and topics: docs/nodes/gcode_streamer.md.
///
/// With `corrections.use`, the lines of each layer are corrected before they are numbered, by the map that
/// has arrived when the machine rests in front of the layer, and by later maps within the layer. With
/// `corrections.follow_plans` replanned layers replace the remaining layers of a toolpath.
///
/// A machine with a start-up sequence (`startup.*`) takes a job only when every step is satisfied.
///
/// One job at a time: a new goal aborts the one under way.
class GcodeStreamer {
 public:
  GcodeStreamer(ros::NodeHandle node, const GcodeStreamerSettings& settings);

  /// Returns once the job under way, which `isStopRequested` aborts, and the start-up have left the machine
  /// safe, and this has been reported.
  void awaitRest();

 private:
  using Trigger = std_srvs::Trigger;

  void onGoal(const lamina_msgs::StreamProgramGoalConstPtr& goal);
  StreamStatus stream(const lamina_msgs::StreamProgramGoal& goal);
  std::unique_ptr<const DryProgram> dryProgram(const lamina_msgs::StreamProgramGoal& goal,
                                               const StreamableProgram& program);
  void beginJob(const lamina_msgs::StreamProgramGoal& goal, const StreamableProgram& program);
  StreamStatus streamProgram(const StreamableProgram& program, JobStart start, const std::string& execution);
  ExecutionRecord recordOfExecution(const lamina_msgs::StreamProgramGoal& goal) const;
  StreamStatus follow(StreamSession& session, const std::function<void(const StreamStatus&)>& look);
  StreamableProgram programFor(const lamina_msgs::StreamProgramGoal& goal) const;
  StreamableProgram programFromToolpath(const std::string& id) const;
  void holdWithoutOwner(StreamSession& session);
  void watchStartup(StreamSession& session, const StreamStatus& status);
  void finish(const StreamStatus& status, double duration_s);

  /// The corrected stream of the program; null if programs are not corrected.
  std::shared_ptr<CorrectedStream> correctionOf(const StreamableProgram& program) const;
  void onCorrection(const lamina_msgs::CorrectionMap& message);

  void onPlan(const lamina_msgs::ToolpathConstPtr& message);
  std::string goOverTo(const lamina_msgs::Toolpath& message, CorrectedStream& corrected,
                       const std::shared_ptr<StreamSession>& job);

  bool onPause(Trigger::Request& request, Trigger::Response& response);
  bool onResume(Trigger::Request& request, Trigger::Response& response);
  bool onAbort(Trigger::Request& request, Trigger::Response& response);
  bool onChange(lamina_msgs::ChangeJob::Request& request, lamina_msgs::ChangeJob::Response& response);
  /// The job under way; null if there is none.
  std::shared_ptr<StreamSession> session() const;
  /// Holds, or no longer holds, the goal that has no session yet. @return false if there is none
  bool holdPrepared(bool is_held);
  /// Ends the goal that has no session yet. @return false if there is none
  bool giveUpPrepared();
  /// Why the goal is to end; nothing if it is not.
  std::optional<Failure> cancellation();
  /// @throws Cancelled if the goal is to end
  void requireWanted();

  /// Data with which a watch can stop the machine in place of this node.
  MachinePulse pulse() const;

  void onStatus(const StreamStatus& status);
  void publishProgress(const StreamStatus& status, const LaidFilament& laid) const;
  void publishState(lamina_msgs::MachineState state, lamina_msgs::HeaterState heaters) const;

  void onStartup(const StartupReport& report);
  void publishPosition(const ReportedPosition& position);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

  GcodeStreamerSettings settings_;
  ExecutorOwner owner_;
  CartesianMachine machine_;
  ToolpathPrograms programs_;
  Eigen::Affine3d bed_from_program_;
  ros::Publisher state_;
  ros::Publisher heaters_;
  ros::Publisher progress_;
  ros::Publisher position_;
  StreamReport report_;
  CorrectionReports reports_;
  ros::Subscriber toolpath_subscriber_;
  ros::Subscriber correction_;
  ros::Subscriber plan_;
  ros::Publisher toolpath_publisher_;  ///< publishes plans that are followed
  ros::ServiceServer pause_;
  ros::ServiceServer resume_;
  ros::ServiceServer abort_;
  ros::ServiceServer change_;
  OwnerWatch owner_watch_;
  JobAlarms job_alarms_;
  double asked_s_ = 0.0;  ///< when the machine was last asked how it is, during a job
  NodeDiagnostics diagnostics_;
  ros::Timer diagnostics_timer_;

  bool is_dry_ = false;  ///< the job under way; of the action's thread alone
  std::atomic<bool> has_goal_{false};

  mutable std::mutex mutex_;  ///< of everything below
  std::shared_ptr<StreamSession> session_;
  std::shared_ptr<CorrectedStream> corrected_;    ///< the job under way
  std::optional<CorrectionMap> first_layer_map_;  ///< that came while there was no job
  bool is_of_toolpath_ = false;                   ///< the job under way, and not of a file
  bool is_preparing_ = false;                     ///< a goal, whose session is not there yet
  bool is_hold_due_ = false;                      ///< of it
  bool is_abort_due_ = false;                     ///< of it
  lamina_msgs::ToolpathConstPtr toolpath_;
  StartupReport startup_report_;

  PulseSender pulses_;  ///< until job and start-up have left the machine safe
  StartupSession startup_;
  StartupService startup_service_;

  // Last, so that its thread ends before what it uses.
  actionlib::SimpleActionServer<lamina_msgs::StreamProgramAction> action_;
  ActionGate<lamina_msgs::StreamProgramAction> gate_;
};

}  // namespace lamina
