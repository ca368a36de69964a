// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_desk.hpp"

#include <sensor_msgs/image_encodings.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "call_source.hpp"
#include "conversions.hpp"
#include "names.hpp"
#include "service_call.hpp"
#include "sliced_upload.hpp"

namespace lamina {
namespace {

constexpr double kProgramPatience = 1800.0;  // [s]: a program of 1 GiB is read, and may wait for others
constexpr std::size_t kMostLayers = 500;
constexpr std::uint32_t kMostCells = 160;  // columns and rows of the picture of deviations

ShownJob shown(const lamina_msgs::CellJob& job) {
  return {job.id,         job.name,       job.part, job.machine, job.digest, static_cast<JobState>(job.state),
          job.created_by, job.released_by};
}

ShownUnit shown(const lamina_msgs::PackmlStatus& status) {
  ShownUnit unit;
  unit.state = unitState(status.state).value_or(UnitState::Stopped);
  unit.sequence = status.sequence;
  unit.in_state_s = status.in_state;
  unit.mode = status.mode;
  unit.mode_name = status.mode_name;
  for (const std::uint8_t command : status.accepted_now)
    if (const auto known = unitCommand(command)) unit.accepted_now.push_back(*known);
  unit.stop_reason = status.stop_reason;
  unit.stop_message = status.stop_message;
  if (status.job.id != 0) unit.job = shown(status.job);
  unit.resume_waits = status.resume_waits;
  unit.resume_refusal = status.resume_refusal;
  for (const lamina_msgs::ResumeStep& step : status.resume_steps) {
    unit.resume_steps.push_back({step.name, static_cast<ResumeStepState>(step.state), step.text});
    if (std::isfinite(step.begin_length))
      unit.resume_steps.back().begin_mm = toMillimetres(step.begin_length);
  }
  unit.is_part_on_plate = status.is_part_on_plate;
  unit.plc_access = status.remote_access != 0 ? PlcAccess::Allowed : PlcAccess::Locked;
  unit.lines = status.lines;
  unit.lines_acknowledged = status.lines_acknowledged;
  unit.layer = status.layer;
  unit.fraction = status.fraction;
  unit.laid_m = status.laid_length;
  unit.material_m3 = status.material;
  unit.elapsed_s = status.elapsed;
  unit.parts = status.parts;
  unit.defective = status.defective;
  unit.running_s = status.running;
  return unit;
}

ShownAlarm shown(const lamina_msgs::CellAlarm& alarm) {
  return {alarm.id,
          alarm.category,
          alarm.title,
          alarm.remedy,
          alarm.message,
          alarm.is_gone != 0,
          alarm.is_acknowledged != 0,
          alarm.acknowledged_by,
          alarm.times};
}

std::vector<ShownStep> shown(const std::vector<lamina_msgs::StartupStep>& steps) {
  std::vector<ShownStep> rows;
  rows.reserve(steps.size());
  for (const lamina_msgs::StartupStep& step : steps)
    rows.push_back({step.name, step.state_name, step.reason, step.value, step.unit, step.expected});
  return rows;
}

/// The picture with one value for each square of cells: their mean.
ShownDeviation coarser(const sensor_msgs::Image& image) {
  const std::uint32_t step = std::max(
      {1U, (image.width + kMostCells - 1) / kMostCells, (image.height + kMostCells - 1) / kMostCells});
  ShownDeviation shown_picture;
  shown_picture.columns = (image.width + step - 1) / step;
  shown_picture.rows = (image.height + step - 1) / step;
  std::vector<double> sums(std::size_t{shown_picture.columns} * shown_picture.rows, 0.0);
  std::vector<int> counts(sums.size(), 0);
  for (std::uint32_t row = 0; row < image.height; ++row)
    for (std::uint32_t column = 0; column < image.width; ++column) {
      float value = 0.0F;
      std::memcpy(&value, image.data.data() + std::size_t{row} * image.step + column * sizeof value,
                  sizeof value);
      if (!std::isfinite(value)) continue;
      const std::size_t cell = std::size_t{row / step} * shown_picture.columns + column / step;
      sums[cell] += value;
      ++counts[cell];
    }
  for (std::size_t i = 0; i < sums.size(); ++i)
    shown_picture.errors_m.push_back(counts[i] == 0 ? std::nanf("")
                                                    : static_cast<float>(sums[i] / counts[i]));
  return shown_picture;
}

DeskAnswer silent(const char* name) {
  DeskAnswer answer;
  answer.outcome = DeskAnswer::Outcome::Silent;
  answer.message = std::string("the service ") + name + " is not there, or broke off";
  return answer;
}

DeskAnswer answerOf(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  DeskAnswer answer;
  answer.code = status.code;
  answer.message = status.message;
  if (status.code == Status::OK) return answer;
  const bool is_input = status.code >= Status::INVALID_INPUT && status.code <= Status::UNREACHABLE;
  answer.outcome = is_input ? DeskAnswer::Outcome::BadInput : DeskAnswer::Outcome::Refused;
  return answer;
}

DeskAnswer unitAnswer(int result, const std::string& message) {
  DeskAnswer answer;
  answer.code = result;
  answer.message = message;
  if (result == static_cast<int>(CommandResult::BadValue))
    answer.outcome = DeskAnswer::Outcome::BadInput;
  else if (result == static_cast<int>(CommandResult::NoSuchJob))
    answer.outcome = DeskAnswer::Outcome::Unknown;
  else if (result != static_cast<int>(CommandResult::Accepted))
    answer.outcome = DeskAnswer::Outcome::Refused;
  return answer;
}

OrderEffect effectOf(UnitCommand command) {
  return stopsUnit(command) ? OrderEffect::Stops : OrderEffect::Moves;
}

}  // namespace

RosDesk::RosDesk(ros::NodeHandle node, double patience_s)
    : node_(node),
      patience_s_(patience_s),
      alarm_reports_(node.advertise<lamina_msgs::AlarmReport>(names::kAlarmReports, 10)),
      subscribers_({node.subscribe(names::kPackmlStatus, 10, &RosDesk::onStatus, this),
                    node.subscribe(names::kAlarms, 10, &RosDesk::onAlarms, this),
                    node.subscribe(names::kJobQueue, 10, &RosDesk::onQueue, this),
                    node.subscribe(names::kMachineState, 10, &RosDesk::onMachine, this),
                    node.subscribe(names::kHeaterState, 10, &RosDesk::onHeaters, this),
                    node.subscribe(names::kLoopState, 10, &RosDesk::onLoop, this),
                    node.subscribe(names::kManualState, 10, &RosDesk::onManual, this),
                    node.subscribe(names::kLayerHeight, 100, &RosDesk::onLayer, this),
                    node.subscribe(names::kHeightDeviation, 1, &RosDesk::onDeviation, this)}) {}

void RosDesk::setCamera(bool is_there) {
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.has_camera = is_there;
}

CellSnapshot RosDesk::snapshot() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return seen_;
}

ShownDeviation RosDesk::deviation() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return deviation_;
}

ShownPreview RosDesk::preview(std::int32_t layer) {
  std::string program;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    program = seen_.machine.job;
  }
  if (program.empty() || program.front() != '/') return {};  // a toolpath that was published
  return preview_.layer(program, layer);
}

void RosDesk::onStatus(const lamina_msgs::PackmlStatusConstPtr& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_other = (seen_.unit.job ? seen_.unit.job->id : 0) != status->job.id;
  seen_.unit = shown(*status);
  seen_.heard_s = clock_.now();
  if (is_other && status->job.id != 0) seen_.layers.clear();
}

void RosDesk::onAlarms(const lamina_msgs::CellAlarmsConstPtr& alarms) {
  std::vector<ShownAlarm> rows;
  rows.reserve(alarms->alarms.size());
  for (const lamina_msgs::CellAlarm& alarm : alarms->alarms) rows.push_back(shown(alarm));
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.alarms = std::move(rows);
}

void RosDesk::onQueue(const lamina_msgs::JobQueueConstPtr& queue) {
  std::vector<ShownJob> rows;
  rows.reserve(queue->jobs.size());
  for (const lamina_msgs::CellJob& job : queue->jobs) rows.push_back(shown(job));
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.queue = std::move(rows);
}

void RosDesk::onMachine(const lamina_msgs::MachineStateConstPtr& machine) {
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.machine_heard_s = clock_.now();
  seen_.machine.job = machine->job;
  seen_.machine.nozzle_degc = machine->nozzle_temperature;
  seen_.machine.bed_degc = machine->bed_temperature;
  seen_.machine.position_m = {machine->position.x, machine->position.y, machine->position.z};
  seen_.machine.failure = machine->status.message;
  seen_.startup = shown(machine->startup);
}

void RosDesk::onHeaters(const lamina_msgs::HeaterStateConstPtr& heaters) {
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.machine.nozzle_target_degc = heaters->nozzle_target;
  seen_.machine.bed_target_degc = heaters->bed_target;
}

void RosDesk::onLoop(const lamina_msgs::LoopStateConstPtr& loop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.loop = ShownLoop{loop->state_name, loop->reason, loop->layer, loop->alarm};
}

void RosDesk::onManual(const lamina_msgs::ManualStateConstPtr& manual) {
  ShownManual shown_manual{manual->holder, manual->remaining, manual->moving != 0,
                           manual->scale,  manual->reason,    {}};
  const std::size_t joints = std::min(manual->joints.size(), manual->is_linear.size());
  shown_manual.joints.reserve(joints);
  for (std::size_t i = 0; i < joints; ++i)
    shown_manual.joints.push_back({manual->joints[i], manual->is_linear[i] != 0});
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.manual = std::move(shown_manual);
}

void RosDesk::onLayer(const lamina_msgs::LayerHeightConstPtr& layer) {
  if (layer->sight == lamina_msgs::LayerHeight::NOT_SEEN) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  auto& layers = seen_.layers;
  if (!layers.empty() && layer->layer <= layers.back().layer) layers.clear();  // another print
  layers.push_back({layer->layer, layer->mean_error, layer->rms_error, layer->worst_error, layer->coverage});
  if (layers.size() > kMostLayers) layers.erase(layers.begin());
}

void RosDesk::onDeviation(const sensor_msgs::ImageConstPtr& image) {
  const bool is_whole = image->encoding == sensor_msgs::image_encodings::TYPE_32FC1 &&
                        image->step >= image->width * sizeof(float) &&
                        image->data.size() >= std::size_t{image->step} * image->height;
  if (!is_whole) return;
  ShownDeviation picture = coarser(*image);
  const std::lock_guard<std::mutex> lock(mutex_);
  picture.number = deviation_.number + 1;
  deviation_ = std::move(picture);
  seen_.deviation_number = deviation_.number;
}

template <class Service>
DeskAnswer RosDesk::callUnit(const Label& label, const char* name, const Service& call) {
  const auto ask = [node = node_, name, call = call]() mutable {
    if (!callService(node.resolveName(name), call)) return silent(name);
    return unitAnswer(call.response.result, call.response.message);
  };
  return lanes_.give({label.kind, label.effect, label.node, patience_s_, ask});
}

template <class Service>
DeskAnswer RosDesk::callForStatus(const Label& label, const char* name, const Service& call) {
  const auto ask = [node = node_, name, call = call]() mutable {
    if (!callService(node.resolveName(name), call)) return silent(name);
    return answerOf(call.response.status);
  };
  return lanes_.give({label.kind, label.effect, label.node, patience_s_, ask});
}

DeskAnswer RosDesk::command(const DeskCommand& command) {
  lamina_msgs::PackmlCommand call;
  call.request.command = static_cast<std::uint8_t>(command.command);
  call.request.source = command.source;
  call.request.expected_sequence = command.expected_sequence ? std::int64_t{*command.expected_sequence} : -1;
  call.request.cut_off = static_cast<std::uint8_t>(command.cut_off);
  call.request.confirmed = command.confirmed.steps;
  if (command.confirmed.begin_mm) call.request.confirmed_length = {toMetres(*command.confirmed.begin_mm)};
  // By then whoever asked has the report that nobody has answered.
  call.request.expires = ros::Time(ros::WallTime::now().toSec() + patience_s_);
  return callUnit({toString(command.command), effectOf(command.command)}, names::kPackmlCommand, call);
}

DeskAnswer RosDesk::changeMode(int mode, const std::string& source) {
  lamina_msgs::SetUnitMode call;
  call.request.mode = static_cast<std::uint8_t>(mode);
  call.request.source = source;
  return callUnit({"a mode"}, names::kSetUnitMode, call);
}

DeskAnswer RosDesk::setPlcAccess(PlcAccess access, const std::string& source) {
  lamina_msgs::SetRemoteAccess call;
  call.request.is_allowed = static_cast<std::uint8_t>(access == PlcAccess::Allowed);
  call.request.source = source;
  return callForStatus({"the PLC's access"}, names::kSetRemoteAccess, call);
}

/// Of steps that several ask for at once only one waits: a step that comes late is none that is held.
DeskAnswer RosDesk::moveByHand(const DeskManual& order) {
  lamina_msgs::MoveByHand call;
  call.request.request = static_cast<std::uint8_t>(order.kind);
  call.request.source = order.who.source;
  call.request.lease = order.who.lease;
  call.request.frame = order.step.frame;
  call.request.axis = order.step.axis;
  call.request.step = order.step.step;
  call.request.speed = order.step.speed;
  const auto ask = [node = node_, call]() mutable {
    if (!callService(node.resolveName(names::kMoveByHand), call)) return silent(names::kMoveByHand);
    DeskAnswer answer = unitAnswer(call.response.result, call.response.message);
    answer.lease = call.response.lease;
    return answer;
  };
  switch (order.kind) {
    case DeskManual::Kind::Take:
      return lanes_.give({"a lease", OrderEffect::Other, kUnitNode, patience_s_, ask});
    case DeskManual::Kind::Step:
      return lanes_.give({"a step by hand", OrderEffect::Moves, kUnitNode, kLatestStep, ask});
    case DeskManual::Kind::Release:
      break;
  }
  const std::string kind = "release of lease " + std::to_string(order.who.lease);
  return lanes_.give({kind, OrderEffect::Stops, kUnitNode, patience_s_, ask});
}

DeskAnswer RosDesk::enqueue(const DeskProgram& program) {
  lamina_msgs::EnqueueJob call;
  call.request.program = program.path;
  call.request.name = program.name;
  call.request.part = program.part;
  call.request.source = program.source;
  call.request.mesh = program.mesh;
  call.request.mesh_name = program.mesh_name;
  const auto ask = [node = node_, call]() mutable {
    if (!callService(node.resolveName(names::kEnqueueJob), call)) return silent(names::kEnqueueJob);
    DeskAnswer answer = answerOf(call.response.status);
    answer.job = call.response.job;
    return answer;
  };
  return programs_.ask({program.path, OrderEffect::Other, "cell_controller", kProgramPatience, ask});
}

DeskAnswer RosDesk::enqueueMesh(const DeskMesh& mesh) {
  const SlicedUpload files(mesh);
  const auto ask = [node = node_, call = files.request()]() mutable {
    if (!callService(node.resolveName(names::kSliceMesh), call)) return silent(names::kSliceMesh);
    return answerOf(call.response.status);
  };
  DeskAnswer sliced = meshes_.ask({mesh.path, OrderEffect::Other, "slicing_service", kProgramPatience, ask});
  if (sliced.outcome != DeskAnswer::Outcome::Done) {
    sliced.message = files.withNames(sliced.message);
    return sliced;
  }
  return enqueue(files.program());
}

DeskAnswer RosDesk::changeQueue(QueueChange change, std::int64_t job, const std::string& source) {
  lamina_msgs::ChangeQueue call;
  call.request.change = static_cast<std::uint8_t>(change);
  call.request.source = source;
  return callQueue(std::move(call), job);
}

DeskAnswer RosDesk::moveJob(std::int64_t job, std::int64_t place, const std::string& source) {
  lamina_msgs::ChangeQueue call;
  call.request.change = lamina_msgs::ChangeQueue::Request::MOVE;
  call.request.place = static_cast<std::uint32_t>(
      std::clamp(place, std::int64_t{0}, std::int64_t{std::numeric_limits<std::uint32_t>::max()}));
  call.request.source = source;
  return callQueue(std::move(call), job);
}

DeskAnswer RosDesk::callQueue(lamina_msgs::ChangeQueue call, std::int64_t job) {
  if (job > std::int64_t{std::numeric_limits<std::uint32_t>::max()}) {
    DeskAnswer unknown;
    unknown.outcome = DeskAnswer::Outcome::Unknown;
    unknown.message = "there is no job " + std::to_string(job);
    return unknown;
  }
  call.request.job = static_cast<std::uint32_t>(job);
  const std::string kind =
      "change " + std::to_string(int{call.request.change}) + " of job " + std::to_string(job);
  DeskAnswer answer = callForStatus({kind}, names::kChangeQueue, call);
  // A job in another state than the change needs is refused as bad input by the journal.
  if (answer.outcome == DeskAnswer::Outcome::BadInput) answer.outcome = DeskAnswer::Outcome::Refused;
  return answer;
}

DeskAnswer RosDesk::acknowledge(int alarm, const std::string& source) {
  lamina_msgs::AcknowledgeAlarm call;
  call.request.id = static_cast<std::uint16_t>(alarm);
  call.request.source = source;
  return callUnit({"acknowledgement of alarm " + std::to_string(alarm)}, names::kAcknowledgeAlarm, call);
}

DeskAnswer RosDesk::judge(const DeskVerdict& verdict) {
  lamina_msgs::JudgePart call;
  call.request.job = static_cast<std::uint32_t>(verdict.job);
  call.request.verdict = verdict.verdict;
  call.request.source = verdict.source;
  call.request.reason = verdict.reason;
  return callForStatus({"verdict of job " + std::to_string(verdict.job)}, names::kJudgePart, call);
}

DeskAnswer RosDesk::confirmRemoval(const std::string& source) {
  const auto ask = [node = node_, source]() mutable {
    std_srvs::Trigger call;
    // A Trigger has no place for who asks: it goes with the connection.
    auto client =
        node.serviceClient<std_srvs::Trigger>(names::kConfirmRemoval, true, {{kSourceOfCall, source}});
    if (!client.isValid() || !client.call(call)) return silent(names::kConfirmRemoval);
    DeskAnswer answer;
    answer.message = call.response.message;
    if (!call.response.success) answer.outcome = DeskAnswer::Outcome::Refused;
    return answer;
  };
  return lanes_.give({"the part's removal", OrderEffect::Other, kUnitNode, patience_s_, ask});
}

DeskAnswer RosDesk::startup(StartupCommand command, const std::string& step) {
  lamina_msgs::RunStartup call;
  call.request.command = static_cast<std::uint8_t>(command);
  call.request.step = step;
  const Label label = command == StartupCommand::Abort
                          ? Label{"the start-up's abort", OrderEffect::Stops, kStartupNode}
                          : Label{"the start-up's next step", OrderEffect::Moves, kStartupNode};
  return callForStatus(label, names::kRunStartup, call);
}

DeskAnswer RosDesk::setLoop(ShownLoopRequest request) {
  lamina_msgs::SetLoop call;
  call.request.request = static_cast<std::uint8_t>(request);
  const bool is_off = request == ShownLoopRequest::Off;
  return callForStatus({"the loop's state", is_off ? OrderEffect::Other : OrderEffect::Moves, kLoopNode},
                       names::kSetLoop, call);
}

void RosDesk::report(int alarm, double value, const std::string& message) {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = static_cast<std::uint16_t>(alarm);
  report.source = "operator_page";
  report.value = value;
  report.message = message;
  alarm_reports_.publish(report);
}

}  // namespace lamina
