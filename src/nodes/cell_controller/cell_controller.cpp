// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_controller.hpp"

#include <ros/callback_queue.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "call_source.hpp"
#include "driver_executor.hpp"
#include "job_rules.hpp"
#include "kept_corrections.hpp"
#include "lamina/base/disk_space.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/journal/part_judgement.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "status.hpp"
#include "stream_executor.hpp"
#include "unit_diagnostics.hpp"

namespace lamina {
namespace {

constexpr double kTickInterval = 0.02;   // [s]
constexpr double kStatusInterval = 0.5;  // [s]
constexpr int kSilentTicks = 5;
constexpr char kRemoteAccess[] = "remote_access";  // among the numbers that the journal keeps
constexpr char kLocalStart[] = "local_start_due";  // there, too
constexpr char kPlc[] = "plc";
constexpr char kQueue[] = "queue";
constexpr char kThisCell[] = "cell_controller";  // as a source of alarms
constexpr double kFeedInterval = 1.0;            // [s] between two tries of a speed that was refused
constexpr double kResumeLook = 2.0;              // [s] between two looks at where a job is resumed
constexpr int kEmergencyStopPressed = 1207;
constexpr int kStartAtTheMachine = 1312;
constexpr int kExecutorLost = 2201;
constexpr int kExecutorSilent = 2202;
constexpr int kJournalDamaged = 7001;
constexpr int kJournalNotWritable = 7003;
constexpr int kMasterLost = 8002;
constexpr int kClocksApart = 8003;
constexpr int kAnyAuditBroken = 9003;

UnitSettings unitSettings(const CellControllerSettings& settings) {
  UnitSettings unit;
  unit.hold_rule = settings.is_held_on_the_way ? HoldRule::AlsoOnTheWay : HoldRule::InExecute;
  return unit;
}

PlcWatchSettings watchedPlc(const CellControllerSettings& settings) {
  PlcWatchSettings plc = settings.plc;
  plc.holds_on_the_way = settings.is_held_on_the_way;
  return plc;
}

std::string madeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder + ": cannot be made: " + error.message());
  return folder;
}

using RemovalEvent = ros::ServiceEvent<std_srvs::Trigger::Request, std_srvs::Trigger::Response>;

/// Who confirms is known by the connection alone.
ros::ServiceServer advertiseRemoval(ros::NodeHandle& node,
                                    const boost::function<bool(RemovalEvent&)>& serve) {
  ros::AdvertiseServiceOptions options;
  options.initBySpecType<RemovalEvent>(names::kConfirmRemoval, serve);
  return node.advertiseService(options);
}

/// Of what is being thrown; it is in the log, too.
lamina_msgs::Status refused(const RequestName& request) {
  const Failure failure = currentFailure();
  ROS_ERROR_STREAM(refusalText(request, failure));
  return toMessage(failure);
}

std::uint8_t numberOf(CommandResult result) { return static_cast<std::uint8_t>(result); }

/// The machine's sheet; one that no job has if the machine is not to be read: jobs may run, and none starts.
std::string sheetOf(const CellControllerSettings& settings) {
  try {
    return jobSheet(settings);
  } catch (const Error& error) {
    ROS_ERROR_STREAM("no job can start: " << error.what());
    return std::string("description: cannot be read: ") + error.what() + '\n';
  }
}

std::unique_ptr<MachineExecutor> executorOf(ros::NodeHandle& node, const CellControllerSettings& settings,
                                            const std::function<void(const ExecutorReport&)>& report) {
  if (settings.executor == ExecutorKind::Driver)
    return std::make_unique<DriverExecutor>(node, settings.placement, report);
  return std::make_unique<StreamExecutor>(node, report);
}

}  // namespace

CellController::CellController(ros::NodeHandle node, const CellControllerSettings& settings)
    : settings_(settings),
      unit_settings_(unitSettings(settings)),
      machine_sheet_(sheetOf(settings)),
      status_(node.advertise<lamina_msgs::PackmlStatus>(names::kPackmlStatus, 100, true)),
      alarms_(node.advertise<lamina_msgs::CellAlarms>(names::kAlarms, 100, true)),
      queue_(node.advertise<lamina_msgs::JobQueue>(names::kJobQueue, 10, true)),
      journal_(madeFolder(settings.folder) + "/cell.db"),
      log_(journal_),
      layers_(node, journal_),
      artefacts_(settings.folder + "/artefacts"),
      care_(journal_, settings.folder, settings.care),
      executor_(executorOf(node, settings, [this](const ExecutorReport& report) { onReport(report); })),
      plc_(node, watchedPlc(settings),
           [this] {
             if (cell_) onTick();
           }),
      queue_follower_(settings.advance) {
  const auto numbers = journal_.counters();
  const auto remote = numbers.find(kRemoteAccess);
  is_remote_allowed_ = remote != numbers.end() && remote->second > 0.0;
  const auto local = numbers.find(kLocalStart);
  is_local_start_due_ = local != numbers.end() && local->second > 0.0;
  const auto seen = awaitExecutor();
  is_executor_lost_ = !executor_->isThere();
  silent_ticks_ = is_executor_lost_ ? kSilentTicks : 0;
  const auto keeper = [this](const QueuedJob& job, const ExecutionRow& execution) {
    return correctionsOf(job, execution);
  };
  cell_ = std::make_unique<ProductionCell>(unit_settings_,
                                           CellParts{journal_, artefacts_, *executor_, keeper}, seen, now());
  services_ = {node.advertiseService(names::kPackmlCommand, &CellController::onCommand, this),
               node.advertiseService(names::kSetUnitMode, &CellController::onMode, this),
               node.advertiseService(names::kChangeQueue, &CellController::onChange, this),
               node.advertiseService(names::kAcknowledgeAlarm, &CellController::onAcknowledge, this),
               advertiseRemoval(node, [this](RemovalEvent& event) { return onRemoval(event); }),
               node.advertiseService(names::kSetRemoteAccess, &CellController::onRemoteAccess, this),
               node.advertiseService(names::kJudgePart, &CellController::onJudge, this)};
  intake_ = std::make_unique<JobIntake>(node, artefacts_, settings_);
  manual_ = std::make_unique<ManualDesk>(node, journal_, [this] { return unitByHand(); });
  alarm_reports_ = node.subscribe(names::kAlarmReports, 100, &CellController::onAlarmReport, this);
  const boost::function<void(const lamina_msgs::LoopStateConstPtr&)> on_loop = [this](const auto& state) {
    loop_ = state;
  };
  if (settings_.needs_loop)
    loop_subscriber_ = node.subscribe<lamina_msgs::LoopState>(names::kLoopState, 10, on_loop);
  const boost::function<void(const ros::WallTimerEvent&)> tick = [this](const auto&) { onTick(); };
  timer_ = node.createWallTimer(ros::WallDuration(kTickInterval), tick);
  diagnostics_.begin("none", "unit", [this](auto& diagnostics) {
    fillDiagnostics(published_status_, published_alarms_, diagnostics);
  });
  ROS_INFO_STREAM("the unit is in " << toString(cell_->status().state));
}

std::optional<ExecutorReport> CellController::awaitExecutor() const {
  const double until_s = clock_.now() + settings_.patience_s;
  while (ros::ok() && !(executor_->seen() && executor_->isThere()) && clock_.now() < until_s)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  return executor_->seen();
}

/// A part whose maps are not to be had has a record all the same.
std::vector<Artefact> CellController::correctionsOf(const QueuedJob& job, const ExecutionRow& execution) {
  try {
    return keptCorrections(artefacts_, settings_.corrections_folder, job, execution);
  } catch (const Error& error) {
    ROS_WARN_STREAM("the maps that job " << job.id << " was corrected by are not kept: " << error.what());
    return {};
  }
}

CellTime CellController::now() const { return {clock_.now(), ros::WallTime::now().toSec()}; }

CellSurroundings CellController::surroundings() const {
  CellSurroundings found;
  // Programs are checked as they are put into the queue, and kept by their digests.
  found.start.is_checked = true;
  found.start.machine = {settings_.machine.name, machine_sheet_};
  for (const lamina_msgs::StartupStep& step : executor_->machine().startup)
    if (step.state != lamina_msgs::StartupStep::DONE && step.state != lamina_msgs::StartupStep::SKIPPED)
      found.start.unready.push_back(step.name + " is " + step.state_name + ": " + step.reason);
  found.start.needs_loop = settings_.needs_loop;
  found.start.loop_fault = loopFault();
  for (const ActiveAlarm& alarm : cell_->status().alarms.all())
    if (alarm.id == kClocksApart) found.start.clock_fault = alarm.message;
  found.start.free_bytes = freeBytesOf(settings_.folder);
  found.go_on.is_position_known = !is_executor_lost_;
  found.go_on.has_master = hasMaster();
  found.start.plc_need = found.go_on.plc_need = settings_.plc.is_required ? PlcNeed::Required : PlcNeed::None;
  found.start.plc = found.go_on.plc = plc_.watch().interlocks(clock_.now());
  return found;
}

ManualConditions CellController::unitByHand() const {
  ManualConditions found;
  found.mode = cell_->status().mode;
  found.state = cell_->status().state;
  found.zone_fault = whyZoneIsTaken(plc_.watch().interlocks(clock_.now()),
                                    settings_.plc.is_required ? PlcNeed::Required : PlcNeed::None);
  for (const ActiveAlarm& alarm : cell_->status().alarms.all())
    found.is_emergency_stopped = found.is_emergency_stopped || alarm.id == kEmergencyStopPressed;
  return found;
}

std::string CellController::loopFault() const {
  if (!loop_ || loop_subscriber_.getNumPublishers() == 0) return "height_controller gives no sign of life";
  return loop_->state == lamina_msgs::LoopState::BLOCKED ? loop_->reason : "";
}

std::vector<UnmetGuard> CellController::againstStart(const std::string& source) const {
  std::vector<UnmetGuard> against = care_.againstStart();
  if (is_local_start_due_ && source.compare(0, sizeof kPlc - 1, kPlc) == 0)
    against.push_back(
        {kStartAtTheMachine,
         "the emergency stop was pressed; expected the next Start from a person at the machine"});
  if (is_executor_lost_) against.push_back({kExecutorLost, "the executor gives no sign of life"});
  if (!hasMaster()) against.push_back({kMasterLost, "the ROS master does not answer"});
  for (const ActiveAlarm& alarm : cell_->status().alarms.all()) {
    const auto is_reported = [&alarm](const UnmetGuard& guard) { return guard.code == alarm.id; };
    if (alarm.id == kAnyAuditBroken && std::none_of(against.begin(), against.end(), is_reported))
      against.push_back({kAnyAuditBroken, alarm.message});
    if (alarm.id == kJournalDamaged && !alarm.acknowledged_s)
      against.push_back(
          {kJournalDamaged, "the journal was damaged: " + alarm.message + "; acknowledge it first"});
  }
  return against;
}

bool CellController::onCommand(lamina_msgs::PackmlCommand::Request& request,
                               lamina_msgs::PackmlCommand::Response& response) {
  using Request = lamina_msgs::PackmlCommand::Request;
  const auto command = unitCommand(request.command);
  if (const std::string fault = faultOf(request); !fault.empty() || !command) {
    response.result = numberOf(CommandResult::BadValue);
    response.message = fault;
    return true;
  }
  for (const lamina_msgs::PlcInputs& said : request.plc) plc_.hear(said);
  followPlc(now());
  UnitRequest asked{*command, request.source, std::nullopt, {}};
  if (request.expected_sequence >= 0)
    asked.expected_sequence = static_cast<std::uint32_t>(request.expected_sequence);
  if (*command == UnitCommand::Start) asked.unmet = againstStart(request.source);
  if (*command == UnitCommand::Start && request.cut_off == Request::RESUME) {
    const ResumeConfirmation confirmed = confirmationOf(request);
    for (UnmetGuard& guard : againstUnconfirmed(resumeSteps(), confirmed))
      asked.unmet.push_back(std::move(guard));
    executor_->confirmPlace(confirmed.begin_mm);
  }
  const std::optional<CommandAnswer> expired = expiredAnswer(request, *command);
  const CommandAnswer answer = expired ? *expired
                                       : cell_->command(std::move(asked), surroundings(),
                                                        static_cast<CutOffJob>(request.cut_off), now());
  if (*command == UnitCommand::Start && answer.result == CommandResult::Accepted) demandLocalStart(false);
  response.result = numberOf(answer.result);
  response.message = answer.reason;
  ROS_INFO_STREAM(toString(*command) << " by '" << request.source
                                     << "': " << (answer.reason.empty() ? "accepted" : answer.reason));
  onTick();  // publishes each state, however short
  return true;
}

bool CellController::onMode(lamina_msgs::SetUnitMode::Request& request,
                            lamina_msgs::SetUnitMode::Response& response) {
  const CommandAnswer answer = cell_->changeMode(request.mode, request.source, now());
  response.result = numberOf(answer.result);
  response.message = answer.reason;
  published_s_ = 0.0;
  return true;
}

bool CellController::onChange(lamina_msgs::ChangeQueue::Request& request,
                              lamina_msgs::ChangeQueue::Response& response) {
  try {
    change(request);
  } catch (...) {
    response.status = refused({"change job", std::to_string(request.job), ""});
  }
  is_queue_published_ = false;
  return true;
}

void CellController::change(const lamina_msgs::ChangeQueue::Request& request) {
  using Request = lamina_msgs::ChangeQueue::Request;
  const double utc_s = now().utc_s;
  switch (request.change) {
    case Request::RELEASE:
      return journal_.release(request.job, request.source, utc_s);
    case Request::REVOKE:
      return journal_.revoke(request.job, request.source, utc_s);
    case Request::MOVE_TO_FRONT:
      return journal_.moveToFront(request.job, request.source, utc_s);
    case Request::REMOVE:
      return journal_.remove(request.job, request.source, utc_s);
    case Request::MOVE:
      return journal_.moveTo(request.job, request.place, request.source, utc_s);
    default:
      throw InvalidInput("change is " + std::to_string(request.change) + "; expected 0 to 4");
  }
}

bool CellController::onAcknowledge(lamina_msgs::AcknowledgeAlarm::Request& request,
                                   lamina_msgs::AcknowledgeAlarm::Response& response) {
  const CommandAnswer answer = cell_->acknowledge(request.id, request.source, now());
  response.result = numberOf(answer.result);
  response.message = answer.reason;
  published_s_ = 0.0;
  return true;
}

bool CellController::onRemoval(RemovalEvent& event) {
  std_srvs::Trigger::Response& response = event.getResponse();
  response.success = cell_->isPartOnPlate();
  if (!response.success) response.message = "there is no part on the plate";
  const ros::M_string& connection = event.getConnectionHeader();
  const auto source = connection.find(kSourceOfCall);
  cell_->confirmRemoval(source == connection.end() ? event.getCallerName() : source->second, now());
  published_s_ = 0.0;
  return true;
}

bool CellController::onJudge(lamina_msgs::JudgePart::Request& request,
                             lamina_msgs::JudgePart::Response& response) {
  try {
    const JudgedPart judged = judgePart(
        journal_, artefacts_, {request.job, request.verdict, request.source, request.reason, now().utc_s});
    response.serial = judged.serial;
    response.before = judged.before;
  } catch (...) {
    response.status = refused({"judge a part for", request.source, ""});
  }
  return true;
}

bool CellController::onRemoteAccess(lamina_msgs::SetRemoteAccess::Request& request,
                                    lamina_msgs::SetRemoteAccess::Response& response) {
  try {
    const bool is_allowed = request.is_allowed != 0;
    journal_.add(
        AuditRow{now().utc_s, request.source, "", "remote access", is_allowed ? "allowed" : "locked"});
    journal_.setCounters({{kRemoteAccess, is_allowed ? 1.0 : 0.0}});
    is_remote_allowed_ = is_allowed;
    if (!is_allowed) plc_.watch().disarm();
    ROS_INFO_STREAM("remote access is " << (is_allowed ? "allowed" : "locked") << " by '" << request.source
                                        << "'");
  } catch (...) {
    response.status = refused({"set remote access for", request.source, ""});
  }
  publish();
  return true;
}

void CellController::onAlarmReport(const lamina_msgs::AlarmReportConstPtr& report) {
  try {
    if (report->is_gone)
      endAlarm(report->id, report->source, now());
    else
      raiseAlarm({report->id, report->source, report->value, report->source + ": " + report->message}, now());
  } catch (const InvalidInput& error) {
    ROS_ERROR_STREAM_THROTTLE(1.0, "an alarm of '" << report->source << "' is refused: " << error.what());
  }
  onTick();
}

/// What this node finds itself is one source among others.
void CellController::raiseAlarm(const ReportedCause& cause, CellTime now) {
  cell_->raise(cause.id, cause.value, cause.message, now);
  raised_by_.raise(cause);
}

void CellController::endAlarm(int id, const std::string& source, CellTime now) {
  const auto end = raised_by_.end(id, source);
  if (!end) return;
  if (end->is_over) cell_->end(id, now);
  if (end->other) cell_->raise(id, end->other->value, end->other->message, now);
}

bool CellController::hasMaster() const { return !raised_by_.isRaised(kMasterLost); }

void CellController::onReport(const ExecutorReport& report) {
  if (!cell_) return;
  layers_.onMachine(executor_->machine());
  if (report.phase == ExecutorPhase::Done || report.phase == ExecutorPhase::Resting)
    layers_.onEnd(executor_->machine());
  cell_->onReport(report, now());
}

void CellController::onTick() {
  try {
    followTime();
  } catch (const Error& error) {
    ROS_ERROR_STREAM_THROTTLE(1.0, "the journal cannot be read: " << error.what());
    cell_->raise(kJournalNotWritable, 0.0, error.what(), now());
  }
}

void CellController::followTime() {
  const CellTime at = now();
  watchExecutor(at);
  followPlc(at);
  cell_->tick(at);
  manual_->follow(at);
  if (intake_->addTo(journal_, at.utc_s)) is_queue_published_ = false;
  followQueue(at);
  followExecution();
  followLateScan(at);
  followResume(at);
  followTimeLeft();
  followSpeed(at);
  careForJournal(at);
  const bool has_changed = cell_->status().sequence != published_sequence_;
  if (has_changed || at.steady_s - published_s_ >= kStatusInterval) publish();
  if (has_changed || !is_queue_published_) publishQueue();
}

void CellController::watchExecutor(CellTime now) {
  const std::string order = executor_->takeUnanswered(settings_.patience_s);
  if (!order.empty())
    cell_->raise(kExecutorSilent, settings_.patience_s,
                 executor_->name() + " has not answered the order to " + order + " in " +
                     numberText(settings_.patience_s) + " s",
                 now);
  // After a callback that took long, signs of life may still wait behind this one.
  silent_ticks_ = executor_->isThere() ? 0 : silent_ticks_ + 1;
  const bool is_lost = silent_ticks_ >= kSilentTicks;
  if (is_lost == is_executor_lost_) return;
  is_executor_lost_ = is_lost;
  if (is_lost)
    raiseAlarm({kExecutorLost, kThisCell, 0.0, executor_->name() + " gives no sign of life"}, now);
  else
    endAlarm(kExecutorLost, kThisCell, now);
}

void CellController::followPlc(CellTime now) {
  const PlcDemands demands = plc_.watch().demands(cell_->status(), now.steady_s);
  for (const PlcAlarm& alarm : demands.raised) {
    cell_->raise(alarm.id, 0.0, alarm.message, now);
    if (demandsLocalStart(alarm, settings_)) demandLocalStart(true);
  }
  for (const int alarm : demands.ended) cell_->end(alarm, now);
  if (demands.is_part_removed && is_remote_allowed_) cell_->confirmRemoval(kPlc, now);
  if (!demands.command) return;
  const CommandAnswer answer =
      cell_->command({*demands.command, kPlc, std::nullopt, {}}, surroundings(), CutOffJob::Undecided, now);
  ROS_INFO_STREAM(toString(*demands.command)
                  << " by what the PLC says: " << (answer.reason.empty() ? "accepted" : answer.reason));
}

void CellController::followQueue(CellTime now) {
  const std::string before = queue_follower_.waitsFor();
  const auto look = [this] { return StartOutlook{surroundings(), againstStart(kQueue)}; };
  queue_follower_.follow(*cell_, look, now);
  const std::string& waits_for = queue_follower_.waitsFor();
  if (!waits_for.empty() && waits_for != before) ROS_INFO_STREAM("the queue waits: " << waits_for);
}

void CellController::careForJournal(CellTime now) {
  for (const CareAlarm& alarm : care_.look(now)) {
    if (alarm.is_gone)
      endAlarm(alarm.id, kThisCell, now);
    else
      raiseAlarm({alarm.id, kThisCell, alarm.value, alarm.message}, now);
  }
}

/// What the machine has in force is known by its answers alone, and forgotten between jobs: a machine that
/// was reset has forgotten it, too.
void CellController::followSpeed(CellTime now) {
  if (const auto answer = executor_->takeFeedAnswer()) {
    is_feed_asked_ = false;
    if (answer->refusal.empty()) {
      feed_ = answer->feed;
      if (followed_) log_.add(*followed_, {now.utc_s, "feed", answer->feed, kPlc});
    } else {
      ROS_WARN_STREAM("the speed " << answer->feed
                                   << " that the PLC asks for is refused: " << answer->refusal);
    }
  }
  if (cell_->status().state != UnitState::Execute) {
    if (feed_ != 1.0) feed_.reset();
    return;
  }
  const bool may_ask = is_remote_allowed_ && plc_.watch().interlocks(now.steady_s).is_alive;
  if (!may_ask || is_feed_asked_ || feed_ == plc_.speed() || now.steady_s - feed_asked_s_ < kFeedInterval)
    return;
  is_feed_asked_ = true;
  feed_asked_s_ = now.steady_s;
  executor_->changeFeed(plc_.speed());
}

/// Kept in the journal: a restart of the cell is no person at the machine.
void CellController::demandLocalStart(bool is_due) {
  if (is_local_start_due_ == is_due) return;
  is_local_start_due_ = is_due;
  try {
    journal_.setCounters({{kLocalStart, is_due ? 1.0 : 0.0}});
  } catch (const Error& error) {
    ROS_ERROR_STREAM("that the next Start is to come from a person cannot be kept: " << error.what());
  }
}

void CellController::followExecution() {
  const auto running = cell_->runningExecution();
  if (running == followed_) return;
  followed_ = running;
  layers_.follow(running, executor_->machine());
  if (!running) return;
  if (const auto open = journal_.open()) execution_began_s_ = open->started_s;
}

/// A scan of the last layer may come after the program's end, when the record is written.
void CellController::followLateScan(CellTime now) {
  const auto execution = layers_.takeLate();
  if (!execution) return;
  try {
    renewRecord(journal_, artefacts_, *execution, now.utc_s);
  } catch (const Error& error) {
    ROS_ERROR_STREAM("what was measured after the end is not in the record: " << error.what());
  }
}

/// Nobody waits for the answer; it holds until the next one.
void CellController::followResume(CellTime now) {
  if (!cell_->resumeWaits() || is_executor_lost_ || now.steady_s - resume_looked_s_ < kResumeLook) return;
  resume_looked_s_ = now.steady_s;
  const auto open = journal_.open();
  if (!open) return;
  for (const Artefact& artefact : journal_.job(open->job).artefacts)
    if (artefact.kind == "program") executor_->lookAtResume(artefacts_.pathOf(artefact), open->progress);
}

std::vector<ResumeStep> CellController::resumeSteps() const {
  const auto open = cell_->resumeWaits() ? journal_.open() : std::nullopt;
  if (!open) return {};
  ResumeConditions found;
  found.is_executor_there = !is_executor_lost_;
  found.executor = executor_->name();
  for (const UnmetGuard& guard : cell_->againstResuming()) found.refusals.push_back(guard.sentence);
  found.unready = surroundings().start.unready;
  const ResumeOutlook outlook = executor_->resumeOutlook();
  found.is_by_place = outlook.is_by_place;
  found.begin_mm = outlook.begin_mm;
  found.place = outlook.is_by_place ? outlook.text : lineText(open->progress.taken_through);
  found.temperatures = temperaturesText(executor_->machine());
  return lamina::resumeSteps(found);
}

void CellController::followTimeLeft() {
  if (!followed_) return;
  // Time in which the unit prints: what it waits does not count.
  const double running_s = timeIn(cell_->status().counters, kProduction, UnitState::Execute);
  left_.observe(running_s, *followed_, fractionOf(cell_->report()));
}

void CellController::addProgress(lamina_msgs::PackmlStatus& status) const {
  status.since_reset = totalTime(cell_->status().counters);
  status.remote_access = is_remote_allowed_;
  status.remaining = -1.0;
  if (!followed_) return;
  status.elapsed = now().utc_s - execution_began_s_;
  if (const auto left = left_.estimate()) status.remaining = left->seconds;
}

void CellController::publish() {
  const ros::Time stamp = ros::Time::now();
  lamina_msgs::PackmlStatus status =
      toMessage(*cell_, unit_settings_.modes, unit_settings_.hold_rule, clock_.now());
  addProgress(status);
  for (const ResumeStep& step : resumeSteps()) status.resume_steps.push_back(toMessage(step));
  status.header.stamp = stamp;
  published_sequence_ = status.sequence;
  published_s_ = clock_.now();
  publishLatched(status_, status);
  lamina_msgs::CellAlarms alarms;
  alarms.header.stamp = stamp;
  for (const ActiveAlarm& alarm : cell_->status().alarms.all()) alarms.alarms.push_back(toMessage(alarm));
  publishLatched(alarms_, alarms);
  published_status_ = std::move(status);
  published_alarms_ = std::move(alarms);
  diagnostics_.update();
}

void CellController::publishQueue() {
  lamina_msgs::JobQueue queue;
  queue.header.stamp = ros::Time::now();
  for (const QueuedJob& job : journal_.queue()) queue.jobs.push_back(toMessage(job));
  publishLatched(queue_, queue);
  is_queue_published_ = true;
}

}  // namespace lamina
