// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_driver.hpp"

#include <ros/ros.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "correction_messages.hpp"
#include "drive_messages.hpp"
#include "drive_settings.hpp"
#include "joint_messages.hpp"
#include "lamina/base/clock.hpp"
#include "latched.hpp"
#include "markers/check_markers.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "shutdown.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr double kStep = 0.02;       // s between looks at what is due; for waits of wall time
constexpr double kStandstill = 2.0;  // s of simulated time that does not go on
const ros::WallDuration kSimulatedLook(0.001);
constexpr double kShowPeriod = 0.1;  // s between reports

/// Nothing to report to but a goal that may be cancelled.
class GoalProgress final : public Progress {
 public:
  explicit GoalProgress(std::function<bool()> is_cancelled) : is_cancelled_(std::move(is_cancelled)) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return is_cancelled_(); }

 private:
  std::function<bool()> is_cancelled_;
};

/// Of two motions one after the other; where the machine is, and in what state, is of the later one.
DriveStatus joined(const DriveStatus& before, DriveStatus after) {
  if (!(before.time_s > 0.0)) return after;
  const double time_s = before.time_s + after.time_s;
  after.rms_tip_error_mm = std::sqrt((std::pow(before.rms_tip_error_mm, 2) * before.time_s +
                                      std::pow(after.rms_tip_error_mm, 2) * after.time_s) /
                                     time_s);
  after.time_s = time_s;
  after.duration_s += before.duration_s;
  after.worst_tip_error_mm = std::max(before.worst_tip_error_mm, after.worst_tip_error_mm);
  after.feeding.starvations += before.feeding.starvations;
  after.feeding.least_queued_s = std::min(before.feeding.least_queued_s, after.feeding.least_queued_s);
  return after;
}

/// A job that was cut off when nothing was left to lay.
DriveStatus allLaid(const ResumePlace& place) {
  DriveStatus status;
  status.state = PackmlState::Complete;
  status.laid_mm = place.total_mm;
  status.heading_for = place.heading_for;
  return status;
}

/// Nothing but a complete motion has succeeded.
DriveStatus judged(DriveStatus status) {
  if (status.failure.code == ErrorCode::Ok && status.state != PackmlState::Complete)
    status.failure = {ErrorCode::DeviceError,
                      std::string("the motion ended as ") + toString(status.state) + "; expected Complete"};
  return status;
}

}  // namespace

TrajectoryDriver::TrajectoryDriver(ros::NodeHandle node, const DriverSettings& settings)
    : settings_(settings),
      owner_(settings.owner),
      model_(kinematicModelOf(settings.machine)),
      state_(node.advertise<lamina_msgs::MachineState>(names::kMachineState, 100, true)),
      tracking_(node.advertise<lamina_msgs::TrackingError>(names::kTrackingError, 100)),
      progress_(node.advertise<lamina_msgs::PrintProgress>(names::kPrintProgress, 100)),
      part_markers_(node),
      findings_(node.advertise<visualization_msgs::MarkerArray>(names::kCheckMarkers, 1, true)),
      pause_(advertiseForOwner(node, names::kPause, owner_,
                               [this](auto& request, auto& response) { return onPause(request, response); })),
      resume_(
          advertiseForOwner(node, names::kResume, owner_,
                            [this](auto& request, auto& response) { return onResume(request, response); })),
      abort_(advertiseForOwner(node, names::kAbort, owner_,
                               [this](auto& request, auto& response) { return onAbort(request, response); })),
      process_(node),
      process_io_(node, settings_.process_io),
      joints_(node, *model_),
      owner_watch_(node, settings.owner_grace_s),
      resume_desk_(node, settings_, *model_, joints_, [this] { return is_driving_.load(); }),
      overrides_(node, settings_.feeder, owner_, [this] { return session(); }),
      controller_(node, *model_,
                  [this](const ControllerReport& report) {
                    if (const auto job = session()) job->hear(report, ros::Time::now());
                  }),
      jog_(node, settings_, *model_, owner_,
           JogLinks{controller_, process_, joints_, [this] { return bedFromPart(); },
                    [this](const JointValues& here) { resume_desk_.depart(here); }}),
      action_(
          node, ActionGate<lamina_msgs::DriveToolpathAction>::inner(names::kDriveToolpath, owner_),
          [this](const lamina_msgs::DriveToolpathGoalConstPtr& goal) { onGoal(goal); }, false),
      gate_(node, names::kDriveToolpath, owner_),
      pulses_(settings.guard_socket, [this] { return pulse(); }) {
  ClearanceSettings clearance = settings_.clearance;
  clearance.need = settings_.is_clearance_checked ? ClearanceNeed::Always : ClearanceNeed::Never;
  tellDriveSettings(node, {settings_.run.joints, clearance});
  // Plans that this node publishes take no toolpath's place: that may be driven once more.
  const boost::function<void(const ros::MessageEvent<const lamina_msgs::Toolpath>&)> onToolpath =
      [this](const auto& event) {
        if (event.getPublisherName() == ros::this_node::getName()) return;
        const std::lock_guard<std::mutex> lock(mutex_);
        toolpath_ = event.getConstMessage();
      };
  diagnostics_.begin(model_->name(), "drive", [this](auto& diagnostics) {
    const std::lock_guard<std::mutex> lock(mutex_);
    fillDiagnostics(status_, diagnostics);
  });
  const boost::function<void(const ros::TimerEvent&)> update = [this](const ros::TimerEvent&) {
    diagnostics_.update();
  };
  diagnostics_timer_ = node.createTimer(ros::Duration(1.0), update);
  toolpath_subscriber_ = node.subscribe<lamina_msgs::Toolpath>(names::kToolpath, 1, onToolpath);
  const boost::function<void(const lamina_msgs::CorrectionMapConstPtr&)> correct = [this](const auto& map) {
    onCorrection(*map);
  };
  if (settings_.is_corrected) {
    applied_ = node.advertise<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 100);
    correction_ = node.subscribe<lamina_msgs::CorrectionMap>(names::kCorrection, 100, correct);
  }
  const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> plan = [this](const auto& message) {
    onPlan(message);
  };
  if (settings_.is_corrected && settings_.follows_plans)
    plan_ = node.subscribe<lamina_msgs::Toolpath>(names::kReplannedToolpath, 1, plan);
  DriveStatus idle;
  idle.state = PackmlState::Idle;
  publishState(idle);
  action_.start();
}

MachinePulse TrajectoryDriver::pulse() {
  MachinePulse pulse;
  pulse.is_at_work = is_driving_ || jog_.isUnderWay();
  pulse.has_job = is_driving_;
  pulse.firmware = kFollowsTrajectories;
  pulse.port.name = controller_.action();
  return pulse;
}

void TrajectoryDriver::awaitRest() const {
  while (is_driving_ && ros::ok()) ros::WallDuration(kStep).sleep();
  awaitDelivery();
}

void TrajectoryDriver::onGoal(const lamina_msgs::DriveToolpathGoalConstPtr& goal) {
  is_abort_requested_ = false;
  is_driving_ = true;
  pulses_.send();
  if (!pulses_.isHeard())
    ROS_WARN("nobody listens at %s: no watch stops the controller if this node dies",
             settings_.guard_socket.c_str());
  job_ = goal->program.empty() ? goal->toolpath_id : goal->program;
  file_.reset();
  used_mm3_ = 1e9 * goal->laid_volume;
  is_ordered_by_cell_ = !goal->execution.empty();
  is_hold_due_ = false;
  owner_watch_.expect();
  publishState(DriveStatus());
  const DriveStatus status = judged(drive(*goal));
  if (file_ && status.state == PackmlState::Complete) file_->complete();
  publishState(status);
  lamina_msgs::DriveToolpathResult result = toResult(status);
  if (file_) result.waypoints = static_cast<std::uint32_t>(file_->count().reached());
  if (status.failure.code == ErrorCode::Ok) {
    ROS_INFO(
        "driven in %.1f s; tip error at most %.4f mm, rms %.4f mm; %zu starvations, %.2f s queued at least",
        status.time_s, status.worst_tip_error_mm, status.rms_tip_error_mm, status.feeding.starvations,
        status.feeding.least_queued_s);
    action_.setSucceeded(result);
  } else {
    ROS_ERROR_STREAM(refusalText({"drive toolpath", job_, ""}, status.failure));
    if (action_.isPreemptRequested())
      action_.setPreempted(result, status.failure.message);
    else
      action_.setAborted(result, status.failure.message);
  }
  is_driving_ = false;
  jog_.allow();
}

bool TrajectoryDriver::isCancelled() const {
  return is_abort_requested_ || action_.isPreemptRequested() || isStopRequested() || !ros::ok();
}

/// What was driven counts, whatever comes after it.
DriveStatus TrajectoryDriver::drive(const lamina_msgs::DriveToolpathGoal& goal) {
  DriveStatus so_far;
  try {
    jog_.block([this] { return isCancelled(); });
    dry_ = dryOrderOf(goal);
    MachineToolpath placed = toolpath(goal);
    placed.toolpath = drivenAs(dry_, std::move(placed.toolpath), settings_.dry);
    controller_.requirePresent(settings_.controller_wait_s);
    const std::optional<ResumePlace> place = resume_desk_.placeOf(goal, placed);
    if (place) used_mm3_ += place->unreported_mm3;
    if (place && place->isAllLaid()) return allLaid(*place);
    awaitProcessIo();
    GoalProgress progress([this] { return isCancelled(); });
    Driven driven = drive(prepared(placed, place ? place->begin_mm : 0.0, progress), MapOfFirstLayer::AsItIs);
    so_far = driven.status;
    while (driven.next) {
      const PreparedJob plan = *std::move(driven.next);
      goOnWith(plan.job);
      driven = drive(plan, MapOfFirstLayer::Awaited);
      so_far = joined(so_far, driven.status);
    }
  } catch (...) {
    so_far.failure = currentFailure();
    so_far.state = PackmlState::Aborted;
  }
  return so_far;
}

/// By the time that it is prepared the machine is to stand where it is to go to the start from.
TrajectoryDriver::PreparedJob TrajectoryDriver::prepared(const MachineToolpath& placed, double from_mm,
                                                         Progress& progress) {
  PreparedJob prepared{jobOf(placed, progress), {}, std::nullopt};
  prepared.job.from_mm = from_mm;
  prepared.here = joints_.fresh(settings_.tracking.silence_s, settings_.controller_wait_s);
  prepared.way = wayToStart(prepared.here, prepared.job, *model_, settings_, progress);
  return prepared;
}

TrajectoryDriver::Driven TrajectoryDriver::drive(const PreparedJob& prepared, MapOfFirstLayer first_map) {
  const DriveJob& job = prepared.job;
  const std::string& id = job.placed.id;
  if (!isDry()) part_markers_.begin(job.timed.run.toolpath());
  // However it ends, for the toolpath goes with the job.
  const std::shared_ptr<void> part_end(nullptr, [this](void*) { part_markers_.end(); });
  if (prepared.way) {
    const TimedPath& way = *prepared.way->motion;
    ROS_INFO("going to the start of %s: %.1f s", id.c_str(), way.duration());
    resume_desk_.depart(prepared.here);
    DriveStatus status = run({way, id, PackmlState::Starting, nullptr, dry_.process(), 0.0}).status;
    if (status.state != PackmlState::Complete) return {std::move(status), std::nullopt};
  }
  resume_desk_.forget();
  if (file_ && job.placed.id == file_->toolpathId()) file_->follow(&job.timed.run.divided);
  const std::shared_ptr<void> file_end(nullptr, [this](void*) {
    if (file_) file_->follow(nullptr);
  });
  const std::shared_ptr<ChunkCorrection> correction = correctionOf(job);
  if (correction && first_map == MapOfFirstLayer::Awaited) awaitFirstMap(*correction);
  const TimedPath& path = *job.timed.trajectory;
  ROS_INFO("driving %s%s: %.1f s on %s", id.c_str(), isDry() ? " dry" : "", path.duration(),
           model_->name().c_str());
  Driven driven = run({path, id, PackmlState::Execute, correction, dry_.process(), job.from_mm});
  show(driven.status);
  used_mm3_ += driven.status.used_mm3;
  if (driven.status.state == PackmlState::Complete) part_markers_.complete();
  return driven;
}

DriveJob TrajectoryDriver::jobOf(const MachineToolpath& placed, Progress& progress) {
  return driveJob(
      placed, *model_, settings_,
      [this](const MachineCheck& check) { publishLatched(findings_, checkMarkers(check)); }, progress);
}

std::shared_ptr<ChunkCorrection> TrajectoryDriver::correctionOf(const DriveJob& job) const {
  if (!settings_.is_corrected || isDry()) return nullptr;
  return std::make_shared<ChunkCorrection>(
      DrivenToolpath{job.placed.id, job.timed.run.toolpath(), job.placed.bed_from_part}, settings_.loop,
      *model_);
}

/// A plan is corrected from its first layer on, by what was learnt before.
void TrajectoryDriver::awaitFirstMap(ChunkCorrection& correction) const {
  const ros::Time begin = ros::Time::now();
  while (!isCancelled()) {
    const std::optional<HeardMap> last = lastMap();
    if (last && last->map.toolpath_id == correction.toolpathId()) correction.hear(last->map, last->digest);
    const double waited_s = (ros::Time::now() - begin).toSec();
    if (correction.isKnown(0)) return;
    if (waited_s >= settings_.loop.wait_s) return correction.giveUp(0, waited_s);
    ros::WallDuration(kStep).sleep();
  }
}

std::optional<TrajectoryDriver::HeardMap> TrajectoryDriver::lastMap() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return map_;
}

/// The layers left as they are to be driven from here, made ready beside the motion, which can be paused and
/// aborted meanwhile; nothing while there is no plan, or none that can be driven: then the job is held for
/// the operator.
std::optional<TrajectoryDriver::PreparedJob> TrajectoryDriver::plannedAnew(DriveSession& session,
                                                                           std::optional<PlanInWork>& work) {
  const lamina_msgs::ToolpathConstPtr plan = session.plan();
  if (!plan) return std::nullopt;
  if (work && work->id != plan->id) work->result->giveUp();
  if (work && !work->result->isDone()) return std::nullopt;
  if (!work || work->id != plan->id) {
    work = PlanInWork{plan->id, std::make_unique<WorkBeside<PreparedJob>>([this, plan](Progress& progress) {
                        return prepared(fromMessage(*plan), 0.0, progress);
                      })};
    return std::nullopt;
  }
  const PlanInWork done = *std::exchange(work, std::nullopt);
  try {
    PreparedJob job = done.result->take();
    if (session.leaveFor(plan->id)) return job;
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR("plan %s cannot be driven, the job is held: %s", plan->id.c_str(), failure.message.c_str());
    session.refuse(plan->id, failure.message);
    session.pause();
  }
  return std::nullopt;
}

/// Who follows the print follows the plan from here on.
void TrajectoryDriver::goOnWith(const DriveJob& plan) {
  ROS_WARN("going on with the layers left as planned anew: %s", plan.placed.id.c_str());
  if (!file_) job_ = plan.placed.id;  // a cell knows its job by the file
  publishToolpath(plan.placed);
}

void TrajectoryDriver::publishToolpath(const MachineToolpath& placed) {
  if (!toolpath_publisher_) {
    ros::NodeHandle node;
    toolpath_publisher_ = node.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  }
  publishLatched(toolpath_publisher_, stamped(placed, ros::Time::now()));
}

/// One of a file is published for who follows the print, and by no other node that could be late with it.
MachineToolpath TrajectoryDriver::toolpath(const lamina_msgs::DriveToolpathGoal& goal) {
  if (goal.program.empty()) return toolpath(goal.toolpath_id);
  MachineToolpath placed = toolpathOfFile(goal, settings_.machine);
  file_.emplace(placed);
  publishToolpath(placed);
  return placed;
}

/// A toolpath may be asked for before it has come through.
MachineToolpath TrajectoryDriver::toolpath(const std::string& id) {
  lamina_msgs::ToolpathConstPtr message;
  for (const ros::Time end = ros::Time::now() + ros::Duration(settings_.controller_wait_s);;) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      message = toolpath_;
    }
    const bool is_there = message && message->id == id;
    if (is_there || ros::Time::now() >= end) break;
    if (is_abort_requested_) throw Cancelled("aborted on request");
    if (action_.isPreemptRequested()) throw Cancelled("the goal was cancelled");
    if (isStopRequested() || !ros::ok()) throw Cancelled("the node was ended");
    ros::WallDuration(kStep).sleep();
  }
  if (!message) throw InvalidInput("toolpath " + id + " is asked for, but none was published");
  if (message->id != id)
    throw InvalidInput("toolpath " + id + " is asked for; the one published last is " + message->id);
  return fromMessage(*message);
}

/// Time has passed since the way there was looked for, or since it was gone.
void TrajectoryDriver::requireAtStart(const DriveMotion& motion) const {
  const JointValues start = TrajectoryFeeder(motion.path, settings_.feeder, motion.from_mm).at(0.0).position;
  const TrackingLimits& limits = settings_.tracking;
  const std::string refusal =
      joints_.refusalAt(start, limits.tip_mm, limits.silence_s,
                        {settings_.controller_wait_s, [this] { return isCancelled(); }});
  if (!refusal.empty()) throw DeviceError("the motion is not begun: " + refusal);
}

TrajectoryDriver::Driven TrajectoryDriver::run(const DriveMotion& motion) {
  requireAtStart(motion);
  const auto session =
      std::make_shared<DriveSession>(motion, *model_, settings_, DriveLinks{controller_, process_, joints_});
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    session_ = session;
  }
  if (motion.correction) correctByLastMap(*session, motion.toolpath_id);
  if (isDry())
    session->setShare(OverrideKind::Feed, dry_.speed);
  else
    overrides_.applyTo(*session);
  // Before what makes all safe, which then does not wait for the end of a plan's computation.
  std::optional<PlanInWork> plan;
  // However it ends, nothing burns or flows, and no session is left behind.
  const std::shared_ptr<void> safe_end(nullptr, [this](void*) {
    process_.makeSafe(ros::Time::now());
    const std::lock_guard<std::mutex> lock(mutex_);
    session_.reset();
  });
  ros::Time shown;
  for (abortIfCancelled(*session); session->step();) {
    abortIfCancelled(*session);
    holdIfProcessFails(*session);
    holdWithoutOwner(*session);
    tell(session->takeLayers());
    if ((ros::Time::now() - shown).toSec() >= kShowPeriod) {
      shown = ros::Time::now();
      show(session->status());
    }
    if (std::optional<PreparedJob> next = plannedAnew(*session, plan)) {
      tell(session->takeLayers());
      return {session->status(), std::move(next)};
    }
    if (!awaitStep()) break;
  }
  session->leave({ErrorCode::Cancelled, "the node was ended"});
  tell(session->takeLayers());
  return {session->status(), std::nullopt};
}

/// The next step in ROS time. False if there is none: ROS is shut down, or simulated time stands still while
/// the node is to end.
bool TrajectoryDriver::awaitStep() const {
  if (!ros::Time::isSimTime()) {
    ros::WallDuration(kStep).sleep();
    return ros::ok();
  }
  const SteadyClock clock;
  const ros::Time before = ros::Time::now();
  const double begin_s = clock.now();
  while (ros::ok()) {
    kSimulatedLook.sleep();
    const ros::Time now = ros::Time::now();
    if (now < before || now >= before + ros::Duration(kStep)) return true;
    if (isStopRequested() && clock.now() - begin_s > kStandstill) return false;
  }
  return false;
}

void TrajectoryDriver::abortIfCancelled(DriveSession& session) const {
  if (is_abort_requested_) session.abort({ErrorCode::Cancelled, "aborted on request"});
  if (action_.isPreemptRequested()) session.abort({ErrorCode::Cancelled, "the goal was cancelled"});
  if (isStopRequested() || !ros::ok()) session.abort({ErrorCode::Cancelled, "the node was ended"});
}

void TrajectoryDriver::awaitProcessIo() const {
  if (isDry()) return;
  const ros::Time begin = ros::Time::now();
  for (;;) {
    const ros::Time now = ros::Time::now();
    const std::string fault = process_io_.fault(now);
    if (fault.empty()) return;
    if (isCancelled()) throw Cancelled("cancelled while process_io was waited for");
    if ((now - begin).toSec() >= settings_.controller_wait_s) throw DeviceError(fault);
    ros::WallDuration(kStep).sleep();
  }
}

/// On the way to the start the process is off; the job is held as soon as it begins.
void TrajectoryDriver::holdIfProcessFails(DriveSession& session) const {
  const ros::Time now = ros::Time::now();
  if (isDry() || session.status().state != PackmlState::Execute) return;
  const std::string fault = process_io_.fault(now);
  if (fault.empty() || session.pause()) return;
  ROS_ERROR_STREAM("the job is held: " << fault);
}

/// Nobody would see what the machine does, or stop it. On the way to the start, where the process is off, the
/// job is held as soon as it begins.
void TrajectoryDriver::holdWithoutOwner(DriveSession& session) {
  if (!is_ordered_by_cell_) return;
  if (owner_watch_.takeLoss()) {
    is_hold_due_ = true;
    ROS_ERROR("the cell that ordered the job has said nothing for more than %.1f s; the job is held",
              settings_.owner_grace_s);
  }
  is_hold_due_ = is_hold_due_ && owner_watch_.isLost();
  if (is_hold_due_ && session.status().state == PackmlState::Execute)
    is_hold_due_ = session.pause().has_value();
}

/// That came before there was a session to correct.
void TrajectoryDriver::correctByLastMap(DriveSession& session, const std::string& toolpath_id) const {
  const std::optional<HeardMap> last = lastMap();
  if (last && last->map.toolpath_id == toolpath_id) session.correct(last->map, last->digest);
}

void TrajectoryDriver::onPlan(const lamina_msgs::ToolpathConstPtr& message) {
  const auto job = session();
  const std::string refusal = job ? job->offer(message) : "nothing is driven";
  if (!refusal.empty()) ROS_WARN("plan %s is not gone on with: %s", message->id.c_str(), refusal.c_str());
}

void TrajectoryDriver::tell(const std::vector<DrivenLayer>& layers) {
  for (const DrivenLayer& layer : layers) {
    lamina_msgs::AppliedCorrection message = toMessage(layer.missed, layer.toolpath_id, layer.digest);
    message.header.stamp = ros::Time::now();
    applied_.publish(message);
  }
}

void TrajectoryDriver::onCorrection(const lamina_msgs::CorrectionMap& message) {
  try {
    const CorrectionMap map = toCore(message);
    std::shared_ptr<DriveSession> job;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      map_ = HeardMap{map, message.digest};
      job = session_;
    }
    const std::string refusal = job ? job->correct(map, message.digest) : "nothing is driven";
    if (refusal.empty())
      ROS_INFO("layer %lu is corrected by map %s from here on", static_cast<unsigned long>(map.layer),
               message.digest.c_str());
    else
      ROS_WARN("a correction is not used: %s", refusal.c_str());
  } catch (const Error& error) {
    ROS_WARN("a correction is not used: %s", error.what());
  }
}

void TrajectoryDriver::show(const DriveStatus& status) {
  if (file_) file_->see(status);
  action_.publishFeedback(toFeedback(status));
  publishState(status);
  lamina_msgs::TrackingError tracking = toTrackingError(status, *model_);
  tracking.header.stamp = ros::Time::now();
  tracking_.publish(tracking);
  lamina_msgs::PrintProgress printed = toPrintProgress(status, job_);
  printed.header.stamp = tracking.header.stamp;
  printed.laid_volume += 1e-9 * used_mm3_;
  progress_.publish(printed);
  part_markers_.growTo(status.heading_for);
}

void TrajectoryDriver::publishState(const DriveStatus& status) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    status_ = status;
  }
  lamina_msgs::MachineState message = toMachineState(status, job_);
  count(file_, message);
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kBedFrame;
  publishLatched(state_, message);
}

std::shared_ptr<DriveSession> TrajectoryDriver::session() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return session_;
}

/// Of the toolpath published last; as the bed without one.
Eigen::Matrix3d TrajectoryDriver::bedFromPart() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!toolpath_) return Eigen::Matrix3d::Identity();
  return fromMessage(toolpath_->bed_from_part).linear();
}

bool TrajectoryDriver::onPause(Trigger::Request&, Trigger::Response& response) {
  const auto job = session();
  const std::optional<std::string> refusal =
      job ? job->pause() : std::optional<std::string>("no toolpath is being driven");
  response.success = !refusal;
  response.message = refusal.value_or("holding");
  return true;
}

bool TrajectoryDriver::onResume(Trigger::Request&, Trigger::Response& response) {
  const auto job = session();
  const std::string fault = job && job->isDry() ? "" : process_io_.fault(ros::Time::now());
  std::optional<std::string> refusal = "no toolpath is being driven";
  if (job) refusal = fault.empty() ? job->resume() : fault;
  response.success = !refusal;
  response.message = refusal.value_or("going on");
  return true;
}

bool TrajectoryDriver::onAbort(Trigger::Request&, Trigger::Response& response) {
  response.success = is_driving_;
  response.message = is_driving_ ? "stopping" : "no toolpath is being driven";
  if (!is_driving_) return true;
  // What runs next, if nothing does just now, sees it before it moves.
  is_abort_requested_ = true;
  if (const auto job = session()) job->abort({ErrorCode::Cancelled, "aborted on request"});
  return true;
}

}  // namespace lamina
