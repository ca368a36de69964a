// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_streamer.hpp"

#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include "conversions.hpp"
#include "correction_messages.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/control/supervision.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "shutdown.hpp"
#include "startup_messages.hpp"
#include "status.hpp"
#include "stream_messages.hpp"
#include "streamer_pulse.hpp"

namespace lamina {
namespace {

constexpr double kFeedbackPeriod = 0.1;  // s
constexpr double kHoldStep = 0.01;       // s between looks whether the job holds, or has ended
constexpr int kHoldSteps = 100;          // a session takes what is asked of it far sooner

/// Lines that are counted in one look: a job that is resumed has millions behind it, and must hear of its
/// end.
constexpr std::uint64_t kCountedAtOnce = 10000;

/// Of a job that was done before anybody heard of it.
StreamStatus completeStatus(const StreamableProgram& program) {
  StreamStatus status;
  status.state = PackmlState::Complete;
  status.lines_total = status.lines_sent = status.lines_acknowledged = program.lines();
  return status;
}

/// Returns once the session has taken it.
void hold(StreamSession& job) {
  job.pause();
  for (int i = 0; i < kHoldSteps && job.status().state == PackmlState::Execute; ++i)
    ros::WallDuration(kHoldStep).sleep();
}

/// Reports of steps that are no longer in the state they were in.
void logChanges(const std::vector<lamina_msgs::StartupStep>& before,
                const std::vector<lamina_msgs::StartupStep>& now) {
  for (std::size_t i = 0; i < before.size() && i < now.size(); ++i) {
    if (before[i].state == now[i].state) continue;
    const ros::console::Level level = now[i].state == lamina_msgs::StartupStep::FAILED
                                          ? ros::console::levels::Error
                                          : ros::console::levels::Info;
    ROS_LOG(level, ROSCONSOLE_DEFAULT_NAME, "start-up: %s is %s: %s", now[i].name.c_str(),
            now[i].state_name.c_str(), now[i].reason.c_str());
  }
}

}  // namespace

GcodeStreamer::GcodeStreamer(ros::NodeHandle node, const GcodeStreamerSettings& settings)
    : settings_(settings),
      owner_(settings.owner),
      machine_(machineOf(settings.machine)),
      programs_(machine_, settings),
      bed_from_program_(programFromBed(machine_).inverse()),
      state_(node.advertise<lamina_msgs::MachineState>(names::kMachineState, 100, true)),
      heaters_(node.advertise<lamina_msgs::HeaterState>(names::kHeaterState, 100, true)),
      progress_(node.advertise<lamina_msgs::PrintProgress>(names::kPrintProgress, 100)),
      report_([this](const auto& state, const auto& heaters) { publishState(state, heaters); }),
      pause_(advertiseForOwner(node, names::kPause, owner_,
                               [this](auto& request, auto& response) { return onPause(request, response); })),
      resume_(
          advertiseForOwner(node, names::kResume, owner_,
                            [this](auto& request, auto& response) { return onResume(request, response); })),
      abort_(advertiseForOwner(node, names::kAbort, owner_,
                               [this](auto& request, auto& response) { return onAbort(request, response); })),
      change_(node.advertiseService(names::kChangeJob, &GcodeStreamer::onChange, this)),
      owner_watch_(node, settings.owner_grace_s),
      job_alarms_(node),
      pulses_(settings.guard_socket, [this] { return pulse(); }),
      startup_(settings.startup, settings.stream, settings.port,
               [this](const StartupReport& report) { onStartup(report); }),
      startup_service_(node, startup_),
      action_(
          node, ActionGate<lamina_msgs::StreamProgramAction>::inner(names::kStreamProgram, owner_),
          [this](const lamina_msgs::StreamProgramGoalConstPtr& goal) { onGoal(goal); }, false),
      gate_(node, names::kStreamProgram, owner_) {
  if (settings_.stream.position_interval_s > 0) {
    position_ = node.advertise<sensor_msgs::JointState>(names::kMachinePosition, 100);
  }
  // Plans that this node publishes take no toolpath's place: that may be streamed once more.
  const boost::function<void(const ros::MessageEvent<const lamina_msgs::Toolpath>&)> onToolpath =
      [this](const auto& event) {
        if (event.getPublisherName() == ros::this_node::getName()) return;
        const std::lock_guard<std::mutex> lock(mutex_);
        toolpath_ = event.getConstMessage();
      };
  toolpath_subscriber_ = node.subscribe<lamina_msgs::Toolpath>(names::kToolpath, 1, onToolpath);
  const boost::function<void(const lamina_msgs::CorrectionMapConstPtr&)> correct = [this](const auto& map) {
    onCorrection(*map);
  };
  if (settings_.corrections.is_used) {
    reports_ = CorrectionReports(node);
    correction_ = node.subscribe<lamina_msgs::CorrectionMap>(names::kCorrection, 100, correct);
  }
  const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> plan = [this](const auto& message) {
    onPlan(message);
  };
  if (settings_.corrections.is_used && settings_.corrections.follows_plans) {
    toolpath_publisher_ = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
    plan_ = node.subscribe<lamina_msgs::Toolpath>(names::kReplannedToolpath, 1, plan);
  }
  diagnostics_.begin(settings_.port.name, "stream", [this](auto& diagnostics) { diagnose(diagnostics); });
  const boost::function<void(const ros::TimerEvent&)> update = [this](const ros::TimerEvent&) {
    diagnostics_.update();
  };
  diagnostics_timer_ = node.createTimer(ros::Duration(1.0), update);
  onStartup(startup_.report());
  action_.start();
}

void GcodeStreamer::awaitRest() {
  // First: a goal may still be read for long, while the machine is hot.
  startup_.end();
  while (has_goal_) ros::WallDuration(kHoldStep).sleep();
  awaitDelivery();
}

void GcodeStreamer::onGoal(const lamina_msgs::StreamProgramGoalConstPtr& goal) {
  has_goal_ = true;
  const SteadyClock clock;
  const double start_s = clock.now();
  StreamStatus status;
  try {
    status = stream(*goal);
  } catch (...) {
    // Nothing was sent: the program was refused or the port could not be opened.
    status.failure = currentFailure();
    status.state = PackmlState::Aborted;
    report_.take(status);
  }
  finish(status, clock.now() - start_s);
  has_goal_ = false;
}

/// A job that was cut off goes on, begins or was complete, as its progress file knows.
/// @throws InvalidInput if nothing is known of it, and it may not begin
ExecutionRecord GcodeStreamer::recordOfExecution(const lamina_msgs::StreamProgramGoal& goal) const {
  const std::string path = journalPath(settings_.stream, settings_.port.name);
  const ExecutionRecord record = recordOf(path, goal.execution);
  if (record == ExecutionRecord::None && !goal.or_begin)
    throw InvalidInput("execution " + goal.execution + " is to go on, but " + path +
                       " does not know it; expected the progress file of its port");
  return record;
}

StreamStatus GcodeStreamer::stream(const lamina_msgs::StreamProgramGoal& goal) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_of_toolpath_ = goal.program.empty();
    is_preparing_ = true;
    is_hold_due_ = false;
    is_abort_due_ = false;
  }
  report_.begin(goal.program.empty() ? goal.toolpath_id : goal.program);
  requireWanted();
  const StreamableProgram program = programFor(goal);
  const std::unique_ptr<const DryProgram> dry = dryProgram(goal, program);
  JobStart start = goal.resume ? JobStart::Resume : JobStart::New;
  if (goal.resume && !goal.execution.empty()) {
    const ExecutionRecord record = recordOfExecution(goal);
    if (record == ExecutionRecord::Complete) {
      StreamStatus complete = completeStatus(program);
      report_.take(complete);
      return complete;
    }
    if (record == ExecutionRecord::None) start = JobStart::New;
  }
  requireWanted();
  beginJob(goal, program);
  StreamStatus status;
  try {
    status = streamProgram(dry ? dry->program() : program, start, goal.execution);
  } catch (...) {
    // One that was given up has sent nothing, and found nothing out about the machine.
    const Failure why = currentFailure();
    if (why.code != ErrorCode::Cancelled) status.failure = why;
    startup_.endJob(program, status);
    throw;
  }
  startup_.endJob(program, status);
  return status;
}

/// The program as it is run dry; null if it is run with its process.
std::unique_ptr<const DryProgram> GcodeStreamer::dryProgram(const lamina_msgs::StreamProgramGoal& goal,
                                                            const StreamableProgram& program) {
  is_dry_ = isDry(goal);
  if (!is_dry_) return nullptr;
  DryRunSettings settings = settings_.dry;
  if (goal.speed != 0.0) settings.speed = goal.speed;
  auto dry = std::make_unique<const DryProgram>(program, settings, settings_.stream);
  ROS_INFO_STREAM(toText(dry->report()));
  return dry;
}

/// @throws Rejected if the machine is not started up; Cancelled if the goal is to end
void GcodeStreamer::beginJob(const lamina_msgs::StreamProgramGoal& goal, const StreamableProgram& program) {
  ProgramIdentity identity{program.name(), 0, 0};
  if (startup_.awaits(StartupStep::TransferProgram)) {
    // A toolpath comes as one message, so that it is whole.
    if (goal.program.empty())
      startup_.transferred(identity);
    else
      identity = identityOfFile(goal.program);
  }
  try {
    startup_.beginJob(identity, [this] { return !cancellation(); });
  } catch (const Cancelled&) {
    requireWanted();  // in the words of the goal
    throw;
  }
}

/// A job that is gone on with lays by maps what its record says, and the rest as planned.
StreamStatus GcodeStreamer::streamProgram(const StreamableProgram& program, JobStart start,
                                          const std::string& execution) {
  std::optional<RecordedProgram> recorded;
  if (start == JobStart::Resume && settings_.corrections.is_used)
    recorded = recordedProgram(program, settings_.corrections, settings_.stream);
  const StreamableProgram& sent = recorded ? recorded->program : program;
  StreamJournal journal;
  if (!is_dry_)
    journal = journalFor(journalPath(settings_.stream, settings_.port.name), sent, settings_.port, start);
  journal.execution = execution;
  const std::shared_ptr<CorrectedStream> corrected = recorded ? nullptr : correctionOf(program);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (corrected && first_layer_map_) corrected->hear(*first_layer_map_);
    corrected_ = corrected;
  }
  // Before the machine has anything to do: the program may be gone.
  const bool may_be_replaced = corrected && settings_.corrections.follows_plans;
  startup_.watchJob(program, may_be_replaced ? WatchedLines::MayBeReplaced : WatchedLines::OfTheProgram);
  requireWanted();
  LaidLines laid(sent, corrected, settings_.program.filament_diameter_mm);
  const auto session = std::make_shared<StreamSession>(
      sent, settings_.stream, settings_.port, [this](const StreamStatus& status) { onStatus(status); },
      SessionOptions{[this](const FirmwareReply& reply) { startup_.heard(reply); }, journal, start,
                     laid.revision()});
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    session_ = session;
    is_preparing_ = false;
    if (is_hold_due_) session->pause();
  }
  // However it ends: a session that is left behind would go on with nobody to report it, and keep the port.
  const std::shared_ptr<void> end(nullptr, [this](void*) {
    const std::lock_guard<std::mutex> lock(mutex_);
    session_.reset();
  });
  if (const auto why = cancellation()) session->abort(*why);
  ROS_INFO("streaming %s, %lu lines, to %s", program.name().c_str(), static_cast<unsigned long>(sent.lines()),
           settings_.port.name.c_str());
  owner_watch_.expect();
  if (!pulses_.isHeard())
    ROS_WARN("nobody listens at %s: no watch stops the machine if this node dies",
             settings_.guard_socket.c_str());
  return follow(*session, [&](const StreamStatus& now) {
    watchStartup(*session, now);
    if (!execution.empty()) holdWithoutOwner(*session);
    if (corrected) reports_.tell(*corrected);
    if (recorded) reports_.tell(*recorded, now.layer);
    const std::uint64_t most = session->waitFor(0.0) ? now.lines_acknowledged : kCountedAtOnce;
    publishProgress(now, laid.through(now.lines_acknowledged, most));
  });
}

/// Nobody would see what the machine does, or stop it.
void GcodeStreamer::holdWithoutOwner(StreamSession& session) {
  if (!owner_watch_.takeLoss()) return;
  ROS_ERROR("the cell that ordered the job has said nothing for more than %.1f s; the job is held",
            settings_.owner_grace_s);
  session.pause();
}

/// A job that has ended, or is being ended, keeps nothing.
void GcodeStreamer::watchStartup(StreamSession& session, const StreamStatus& status) {
  const bool keeps = status.state == PackmlState::Execute || status.state == PackmlState::Holding ||
                     status.state == PackmlState::Held || status.state == PackmlState::Unholding;
  job_alarms_.tell(keeps ? startup_.losses(status) : std::vector<JobLoss>());
  const double now_s = SteadyClock().now();
  if (!keeps || now_s - asked_s_ < settings_.startup.check_interval_s) return;
  asked_s_ = now_s;
  session.ask(startup_.questions());
}

/// To the end of the job; what is due besides is looked at as often as it is reported.
StreamStatus GcodeStreamer::follow(StreamSession& session,
                                   const std::function<void(const StreamStatus&)>& look) {
  while (!session.waitFor(kFeedbackPeriod)) {
    const StreamStatus status = session.status();
    action_.publishFeedback(toFeedback(status));
    onStartup(startup_.report());
    report_.publish();
    look(status);
    if (const auto why = cancellation()) session.abort(*why);
  }
  StreamStatus status = session.status();
  report_.take(status);
  look(status);
  return status;
}

StreamableProgram GcodeStreamer::programFor(const lamina_msgs::StreamProgramGoal& goal) const {
  if (goal.program.empty()) return programFromToolpath(goal.toolpath_id);
  return StreamableProgram::fromFile(goal.program, settings_.stream);
}

StreamableProgram GcodeStreamer::programFromToolpath(const std::string& id) const {
  if (id.empty()) throw InvalidInput("neither program nor toolpath_id is given; expected one of them");
  lamina_msgs::ToolpathConstPtr message;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    message = toolpath_;
  }
  if (!message) throw InvalidInput("toolpath " + id + " is asked for, but none was published");
  if (message->id != id) {
    throw InvalidInput("toolpath " + id + " is asked for; the one published last is " + message->id);
  }
  return programs_.programOf(fromMessage(*message));
}

std::shared_ptr<CorrectedStream> GcodeStreamer::correctionOf(const StreamableProgram& program) const {
  if (!settings_.corrections.is_used || is_dry_) return nullptr;
  lamina_msgs::ToolpathConstPtr message;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    message = toolpath_;
  }
  if (!message)
    throw InvalidInput("corrections.use is set, but no toolpath was published that the program could be of");
  return programs_.corrected(program, fromMessage(*message));
}

void GcodeStreamer::onPlan(const lamina_msgs::ToolpathConstPtr& message) {
  std::shared_ptr<CorrectedStream> corrected;
  std::shared_ptr<StreamSession> job;
  bool is_of_toolpath = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    corrected = corrected_;
    job = session_;
    is_of_toolpath = is_of_toolpath_;
  }
  if (!corrected || !job) {
    ROS_WARN("plan %s is not gone on with: nothing is streamed", message->id.c_str());
    return;
  }
  if (corrected->isFollowing(message->id)) return;  // it came twice
  try {
    const std::string refusal = is_of_toolpath ? goOverTo(*message, *corrected, job)
                                               : "the job is of a file; expected one of a toolpath";
    if (refusal.empty()) return;
    ROS_WARN("plan %s is not gone on with: %s", message->id.c_str(), refusal.c_str());
    reports_.refuse(message->id, *corrected, refusal);
  } catch (const Error& error) {
    ROS_ERROR("plan %s cannot be streamed, the job is held: %s", message->id.c_str(), error.what());
    // Held first: the layer has been waited for long enough, and would begin as planned.
    hold(*job);
    corrected->dropPlan();
    reports_.refuse(message->id, *corrected, error.what());
  }
}

/// Who follows the print follows the plan from here on.
std::string GcodeStreamer::goOverTo(const lamina_msgs::Toolpath& message, CorrectedStream& corrected,
                                    const std::shared_ptr<StreamSession>& job) {
  const MachineToolpath plan = fromMessage(message);
  std::string refusal = corrected.goOverTo(plan.id, [&](const LayerCorrector& present, std::size_t layer) {
    return programs_.programOf(plan, present, layer);
  });
  if (!refusal.empty()) return refusal;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (session_ != job) return "the job has ended";
    report_.rename(plan.id);
  }
  ROS_WARN("going on with the layers left as planned anew: %s", plan.id.c_str());
  publishLatched(toolpath_publisher_, stamped(plan, ros::Time::now()));
  return {};
}

void GcodeStreamer::onCorrection(const lamina_msgs::CorrectionMap& message) {
  try {
    CorrectionMap map = toCore(message);
    std::shared_ptr<CorrectedStream> corrected;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      corrected = corrected_;
      // Of the layers above nothing can be known before the job.
      if (!corrected && map.layer == 0) first_layer_map_ = map;
    }
    if (!corrected) return;
    const std::string refusal = corrected->hear(std::move(map));
    if (!refusal.empty()) ROS_WARN("a correction is not used: %s", refusal.c_str());
  } catch (const Error& error) {
    ROS_WARN("a correction is not used: %s", error.what());
  }
}

void GcodeStreamer::finish(const StreamStatus& status, double duration_s) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    corrected_.reset();
    first_layer_map_.reset();
    is_preparing_ = false;
  }
  const lamina_msgs::StreamProgramResult result = toResult(status, duration_s);
  if (status.failure.code == ErrorCode::Ok) {
    ROS_INFO("streamed %lu lines in %.1f s, %lu resends",
             static_cast<unsigned long>(status.lines_acknowledged), duration_s,
             static_cast<unsigned long>(status.resends));
    action_.setSucceeded(result);
    return;
  }
  ROS_ERROR_STREAM(refusalText({"stream", report_.job(), ""}, status.failure));
  if (action_.isPreemptRequested()) {
    action_.setPreempted(result, status.failure.message);
  } else {
    action_.setAborted(result, status.failure.message);
  }
}

std::shared_ptr<StreamSession> GcodeStreamer::session() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return session_;
}

bool GcodeStreamer::holdPrepared(bool is_held) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_preparing_) is_hold_due_ = is_held;
  return is_preparing_;
}

bool GcodeStreamer::giveUpPrepared() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_preparing_) is_abort_due_ = true;
  return is_preparing_;
}

std::optional<Failure> GcodeStreamer::cancellation() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_abort_due_) return Failure{ErrorCode::Cancelled, "aborted on request"};
  }
  if (action_.isPreemptRequested()) return Failure{ErrorCode::Cancelled, "the goal was cancelled"};
  if (isStopRequested() || !ros::ok()) return Failure{ErrorCode::Cancelled, names::kNodeEnded};
  return std::nullopt;
}

void GcodeStreamer::requireWanted() {
  if (const auto why = cancellation()) throw Cancelled(why->message);
}

bool GcodeStreamer::onPause(Trigger::Request&, Trigger::Response& response) {
  const bool is_prepared = holdPrepared(true);
  const auto job = session();
  const PackmlState state = job ? job->status().state : PackmlState::Idle;
  const bool is_begun = state == PackmlState::Execute;
  response.success = is_prepared || is_begun || state == PackmlState::Starting;
  response.message = std::string("state is ") + toString(state) + "; only Starting and Execute can be paused";
  if (response.success)
    response.message = is_begun ? "holding after the lines under way" : "holding before the first line";
  if (response.success && job) job->pause();
  return true;
}

bool GcodeStreamer::onResume(Trigger::Request&, Trigger::Response& response) {
  const bool is_prepared = holdPrepared(false);
  const auto job = session();
  const PackmlState state = job ? job->status().state : PackmlState::Idle;
  const bool is_waited_for = job && !job->status().wait.empty();
  response.success = is_prepared || is_waited_for || state == PackmlState::Starting ||
                     state == PackmlState::Holding || state == PackmlState::Held;
  response.message = response.success
                         ? "going on"
                         : std::string("state is ") + toString(state) + "; only Held can be resumed";
  if (response.success && job) job->resume();
  return true;
}

bool GcodeStreamer::onAbort(Trigger::Request&, Trigger::Response& response) {
  const bool is_prepared = giveUpPrepared();
  const auto job = session();
  const bool is_starting_up = !job && startup_.isBusy();
  response.success = is_prepared || job != nullptr || is_starting_up;
  response.message = response.success ? "stopping the machine" : "no job is under way";
  if (is_prepared && !job && !is_starting_up) response.message = "nothing is begun";
  if (job) job->abort({ErrorCode::Cancelled, "aborted on request"});
  if (!is_starting_up) return true;
  try {
    startup_.abort();
  } catch (const Error& error) {
    response.success = is_prepared;
    response.message = is_prepared ? "nothing is begun" : error.what();
  }
  return true;
}

bool GcodeStreamer::onChange(lamina_msgs::ChangeJob::Request& request,
                             lamina_msgs::ChangeJob::Response& response) {
  try {
    const LiveChange change = liveChangeOf(request.setting, request.value);
    const auto job = session();
    if (!job) throw Rejected("no job is under way");
    const std::string refusal = job->change(change);
    if (!refusal.empty()) throw Rejected(refusal);
  } catch (const Error&) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"change", request.setting, ""}, failure));
    response.status = toMessage(failure);
  }
  return true;
}

MachinePulse GcodeStreamer::pulse() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const StreamStatus status = report_.status();
  MachinePulse pulse =
      pulseOf(settings_, session_ ? status.state : PackmlState::Idle, status, startup_report_);
  if (!is_of_toolpath_) pulse.program = report_.job();
  return pulse;
}

void GcodeStreamer::onStatus(const StreamStatus& status) {
  const StatusNews news = report_.take(status);
  if (news.is_warning) ROS_WARN_STREAM(status.warning);
  if (news.is_state) pulses_.send();
  if (position_ && news.is_position) publishPosition(*status.position);
}

void GcodeStreamer::publishState(lamina_msgs::MachineState state, lamina_msgs::HeaterState heaters) const {
  state.header.stamp = ros::Time::now();
  state.header.frame_id = names::kBedFrame;
  heaters.header.stamp = state.header.stamp;
  publishLatched(state_, state);
  publishLatched(heaters_, heaters);
}

void GcodeStreamer::publishProgress(const StreamStatus& status, const LaidFilament& laid) const {
  lamina_msgs::PrintProgress message = toPrintProgress(status, laid, report_.job());
  message.header.stamp = ros::Time::now();
  progress_.publish(message);
}

/// Between jobs: the state is that in which the last one ended.
void GcodeStreamer::onStartup(const StartupReport& report) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    startup_report_ = report;
  }
  const auto messages = toMessages(report.steps);
  logChanges(report_.takeSteps(messages), messages);
  if (!session()) report_.publish();
}

void GcodeStreamer::publishPosition(const ReportedPosition& position) {
  const Point3 on_bed = bed_from_program_ * Point3(position.x, position.y, position.z);
  sensor_msgs::JointState message = jointState(machine_, axisValues(machine_, on_bed));
  message.header.stamp = ros::Time::now();
  position_.publish(message);
}

void GcodeStreamer::diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  fillDiagnostics(report_.status(), diagnostics);
  for (const auto& step : report_.steps()) diagnostics.add("start-up: " + step.name, step.state_name);
}

}  // namespace lamina
