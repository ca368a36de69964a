// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>
#include <vector>

#include "cell_messages.hpp"
#include "cell_settings.hpp"
#include "job_intake.hpp"
#include "journal_care.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/cell/alarm_sources.hpp"
#include "lamina/cell/production_cell.hpp"
#include "lamina/cell/queue_follower.hpp"
#include "lamina/cell/resume_steps.hpp"
#include "lamina/cell/time_left.hpp"
#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "lamina/journal/execution_log.hpp"
#include "layer_log.hpp"
#include "machine_executor.hpp"
#include "manual_desk.hpp"
#include "node_diagnostics.hpp"
#include "plc_desk.hpp"

namespace lamina {

/// The unit of a cell on ROS: takes commands and jobs, commands its executor, and publishes the state of the
/// cell. Its topics and services: docs/nodes/cell_controller.md.
///
/// All callbacks run in one thread, which never waits for the executor.
class CellController {
 public:
  /// Waits for the executor's last state, at most for the patience of the settings.
  /// @throws FileError if the journal cannot be opened
  CellController(ros::NodeHandle node, const CellControllerSettings& settings);

 private:
  using RemovalEvent = ros::ServiceEvent<std_srvs::Trigger::Request, std_srvs::Trigger::Response>;
  using Trigger = std_srvs::Trigger;

  std::optional<ExecutorReport> awaitExecutor() const;
  bool onCommand(lamina_msgs::PackmlCommand::Request& request,
                 lamina_msgs::PackmlCommand::Response& response);
  bool onMode(lamina_msgs::SetUnitMode::Request& request, lamina_msgs::SetUnitMode::Response& response);
  bool onChange(lamina_msgs::ChangeQueue::Request& request, lamina_msgs::ChangeQueue::Response& response);
  bool onAcknowledge(lamina_msgs::AcknowledgeAlarm::Request& request,
                     lamina_msgs::AcknowledgeAlarm::Response& response);
  bool onRemoval(RemovalEvent& event);
  bool onRemoteAccess(lamina_msgs::SetRemoteAccess::Request& request,
                      lamina_msgs::SetRemoteAccess::Response& response);
  bool onJudge(lamina_msgs::JudgePart::Request& request, lamina_msgs::JudgePart::Response& response);
  void change(const lamina_msgs::ChangeQueue::Request& request);

  void onAlarmReport(const lamina_msgs::AlarmReportConstPtr& report);

  void followPlc(CellTime now);
  void followQueue(CellTime now);
  void followSpeed(CellTime now);
  void followExecution();
  void followLateScan(CellTime now);
  void followResume(CellTime now);
  void followTimeLeft();
  void careForJournal(CellTime now);
  std::vector<UnmetGuard> againstStart(const std::string& source) const;
  void demandLocalStart(bool is_due);

  CellSurroundings surroundings() const;
  ManualConditions unitByHand() const;
  std::string loopFault() const;
  void raiseAlarm(const ReportedCause& cause, CellTime now);
  void endAlarm(int id, const std::string& source, CellTime now);
  bool hasMaster() const;
  void onReport(const ExecutorReport& report);
  void onTick();
  void followTime();
  void watchExecutor(CellTime now);
  void addProgress(lamina_msgs::PackmlStatus& status) const;
  std::vector<ResumeStep> resumeSteps() const;
  void publish();
  void publishQueue();
  std::vector<Artefact> correctionsOf(const QueuedJob& job, const ExecutionRow& execution);
  CellTime now() const;

  CellControllerSettings settings_;
  UnitSettings unit_settings_;
  std::string machine_sheet_;  ///< of the machine as described when the node started
  SteadyClock clock_;
  ros::Publisher status_;
  ros::Publisher alarms_;
  ros::Publisher queue_;
  NodeDiagnostics diagnostics_;
  lamina_msgs::PackmlStatus published_status_;
  lamina_msgs::CellAlarms published_alarms_;
  CellJournal journal_;
  ExecutionLog log_;
  LayerLog layers_;
  ArtefactStore artefacts_;
  JournalCare care_;
  std::unique_ptr<MachineExecutor> executor_;
  PlcDesk plc_;
  QueueFollower queue_follower_;
  std::unique_ptr<ProductionCell> cell_;
  std::unique_ptr<JobIntake> intake_;
  std::unique_ptr<ManualDesk> manual_;
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber alarm_reports_;
  ros::Subscriber loop_subscriber_;
  lamina_msgs::LoopStateConstPtr loop_;  ///< nothing if it was not heard
  ros::WallTimer timer_;
  std::uint32_t published_sequence_ = 0;
  double published_s_ = 0.0;
  double resume_looked_s_ = 0.0;
  bool is_queue_published_ = false;
  AlarmSources raised_by_;  ///< of alarms by other nodes, and of this node's that others may raise too
  bool is_executor_lost_ = false;
  int silent_ticks_ = 0;
  bool is_remote_allowed_ = false;
  bool is_local_start_due_ = false;   ///< after an emergency stop
  std::optional<double> feed_ = 1.0;  ///< feed in force; nothing if it is not known
  bool is_feed_asked_ = false;        ///< whether a change of feed is not answered yet
  double feed_asked_s_ = 0.0;
  std::optional<std::int64_t> followed_;  ///< execution
  double execution_began_s_ = 0.0;        ///< since 1970
  TimeLeft left_;
};

}  // namespace lamina
