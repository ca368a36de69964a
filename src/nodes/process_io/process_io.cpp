// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_io.hpp"

#include <ros/ros.h>
#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "joint_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/process_io/channel_drive.hpp"
#include "lamina/process_io/process_tables.hpp"
#include "lamina/process_io/process_watch.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros_devices.hpp"
#include "shutdown.hpp"
#include "stamps.hpp"

namespace lamina {
namespace {

constexpr double kOnShare = 0.01;  // of the band: what is on

/// What devices read of a channel; NaN if none does.
double measuredOf(const OutputChannel& channel, const ProcessTables& tables,
                  const std::vector<double>& measured) {
  for (std::size_t i = 0; i < tables.inputs.size(); ++i)
    if (tables.inputs[i].check == InputCheck::Follows && tables.inputs[i].channel == channel.name)
      return measured[i];
  return std::numeric_limits<double>::quiet_NaN();
}

/// Puts the effect of a channel in.
void setEffect(const OutputChannel& channel, double value, ProcessSignals& signals) {
  const bool is_on = value - channel.safe > kOnShare * (channel.high - channel.low);
  ProcessLevels& levels = signals.levels;
  switch (channel.quantity) {
    case ProcessQuantity::LaserPower:
      levels[ProcessLevel::LaserPower] = value;
      [[fallthrough]];
    case ProcessQuantity::LaserOn:
      signals.is_laser_on = signals.is_laser_on || is_on;
      break;
    case ProcessQuantity::WireSpeed:
      levels[ProcessLevel::WireSpeed] = value;
      [[fallthrough]];
    case ProcessQuantity::WireOn:
      signals.is_wire_fed = signals.is_wire_fed || is_on;
      break;
    case ProcessQuantity::Powder:
      levels[ProcessLevel::Powder] = value;
      [[fallthrough]];
    case ProcessQuantity::PowderOn:
      signals.is_powder_on = signals.is_powder_on || is_on;
      break;
    case ProcessQuantity::Gas:
      levels[ProcessLevel::Gas] = value;
      [[fallthrough]];
    case ProcessQuantity::GasOn:
      signals.is_gas_on = signals.is_gas_on || is_on;
      break;
    case ProcessQuantity::ScrewSpeed:
      levels[ProcessLevel::ScrewSpeed] = value;
      break;
    case ProcessQuantity::Fan:
      levels[ProcessLevel::Fan] = value;
      break;
    case ProcessQuantity::Flow:
      signals.flow_mm3_s = value;
      break;
  }
}

/// What the process does, without stamp: what devices read where they do, else the effects there should be.
/// @param measured  of each input [unit of its quantity]; NaN where it is not read
lamina_msgs::ProcessState effectsMessage(const ProcessTables& tables, const std::vector<ChannelDrive>& drives,
                                         const std::vector<double>& measured) {
  ProcessSignals signals;
  std::vector<lamina_msgs::ProcessOutput> outputs;
  for (const ChannelDrive& drive : drives) {
    lamina_msgs::ProcessOutput output;
    output.name = drive.channel().name;
    output.quantity = nameOf(drive.channel().quantity);
    output.commanded = drive.sent();
    output.expected = drive.expected();
    output.measured = measuredOf(drive.channel(), tables, measured);
    setEffect(drive.channel(), std::isnan(output.measured) ? output.expected : output.measured, signals);
    outputs.push_back(std::move(output));
  }
  lamina_msgs::ProcessState state = toStateMessage(signals);
  state.outputs = std::move(outputs);
  return state;
}

/// With the time of now.
lamina_msgs::AlarmReport toReport(const ProcessAlarm& alarm) {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = alarm.id;
  // Ends are reported once for all devices of an alarm: to the unit they have one source.
  report.source = "process_io";
  report.value = alarm.value;
  report.message = alarm.message;
  report.is_gone = alarm.is_gone;
  return report;
}

constexpr std::uint32_t kQueue = 1000;  // chunks
constexpr double kReadyHz = 10.0;
constexpr double kUnserved = 0.35;  // s without a cycle: more than three of the slowest
constexpr double kQuiet = 1.0;      // s between two messages of the same kind in the log

double milliseconds(double time_s) { return 1e3 * time_s; }

/// Of jitter and round trips, in one line.
std::string textOf(const DeviceFigures& figures) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "%llu outputs, late by %.1f ms (50 %%), %.1f ms (99 %%), %.1f ms at most; %llu by more than 10 ms, "
      "%llu by more than 50 ms; answered in %.1f ms (50 %%), %.1f ms (99 %%)",
      static_cast<unsigned long long>(figures.late.count()), milliseconds(figures.late.percentile(0.5)),
      milliseconds(figures.late.percentile(0.99)), milliseconds(figures.late.worst()),
      static_cast<unsigned long long>(figures.late.late()),
      static_cast<unsigned long long>(figures.late.tooLate()),
      milliseconds(figures.round_trip.percentile(0.5)), milliseconds(figures.round_trip.percentile(0.99)));
  return text;
}

/// Devices in the order in which their first channels become safe.
std::vector<std::size_t> safeOrder(const ProcessTables& tables) {
  std::vector<std::size_t> order;
  const auto add = [&](const std::string& name) {
    for (std::size_t i = 0; i < tables.devices.size(); ++i)
      if (tables.devices[i].name == name && std::find(order.begin(), order.end(), i) == order.end())
        order.push_back(i);
  };
  for (const OutputChannel& channel : tables.channels) add(channel.device);
  for (const DeviceSettings& device : tables.devices) add(device.name);
  return order;
}

}  // namespace

ProcessIo::ProcessIo(ros::NodeHandle node, const ProcessIoSettings& settings)
    : tables_(processTables(settings.tables)),
      state_(node.advertise<lamina_msgs::ProcessState>(names::kProcessState, kQueue)),
      ready_(node.advertise<lamina_msgs::ProcessReady>(names::kProcessReady, 10, true)),
      alarms_(node.advertise<lamina_msgs::AlarmReport>(
          names::kAlarmReports, 100,
          [this](const ros::SingleSubscriberPublisher& subscriber) { tellAlarms(subscriber); })),
      order_(safeOrder(tables_)),
      bridge_(tables_, settings.bridge, clock_.now()),
      measured_(tables_.inputs.size(), std::numeric_limits<double>::quiet_NaN()) {
  connect(node);
  const boost::function<void(const lamina_msgs::ProcessTrajectoryConstPtr&)> on_trajectory =
      [this](const auto& message) { onTrajectory(*message); };
  const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_positions =
      [this](const auto& message) { onPositions(*message); };
  trajectory_ = node.subscribe<lamina_msgs::ProcessTrajectory>(
      names::kProcessTrajectory, kQueue, on_trajectory, {}, ros::TransportHints().tcpNoDelay());
  positions_ = node.subscribe<sensor_msgs::JointState>(names::kMachinePosition, 100, on_positions);
  state_timer_ = node.createWallTimer(ros::WallDuration(1.0 / settings.state_hz),
                                      [this](const ros::WallTimerEvent&) { publishState(); });
  ready_timer_ = node.createWallTimer(ros::WallDuration(1.0 / kReadyHz),
                                      [this](const ros::WallTimerEvent&) { publishReady(); });
  diagnostics_.begin("process_io", "outputs", [this](auto& diagnostics) { diagnose(diagnostics); });
  cycle_ =
      std::make_unique<PeriodicThread>(settings.bridge.rate_hz, [this](double due_s) { onCycle(due_s); });
  ROS_INFO_STREAM("process outputs run " << cycle_->rights());
}

ProcessIo::~ProcessIo() {
  cycle_.reset();
  const double now_s = clock_.now();
  // All at once; the end of each link waits until its device has them.
  sendToDevices(bridge_.stop(now_s), now_s);
  bool have_ended = true;
  for (const std::size_t i : order_) have_ended = links_[i]->end() && have_ended;
  awaitDelivery();
  // A service that does not answer would be waited for for ever.
  if (!have_ended) ros::shutdown();
  for (const std::size_t i : order_) {
    ROS_INFO_STREAM(tables_.devices[i].name << ": " << textOf(links_[i]->figures()));
    links_[i].reset();
  }
}

void ProcessIo::connect(const ros::NodeHandle& node) {
  for (std::size_t i = 0; i < tables_.devices.size(); ++i) {
    const DeviceTable table = tableOf(tables_, i);
    std::vector<double> safe;
    for (const OutputChannel& channel : table.channels) safe.push_back(rawOf(channel, channel.safe));
    links_.push_back(
        std::make_unique<DeviceLink>(makeRosDevice(node, table), table.device, clock_, std::move(safe)));
  }
}

void ProcessIo::onTrajectory(const lamina_msgs::ProcessTrajectory& message) {
  // ROS time may be set while the monotonic clock goes on: it counts once per chunk.
  const double begin_s = clock_.now() + secondsBetween(ros::Time::now(), message.header.stamp);
  ProcessChunk chunk;
  for (const lamina_msgs::ProcessPoint& point : message.points)
    chunk.points.push_back({begin_s + point.time_from_start.toSec(), fromMessage(point)});
  chunk.valid_until_s = begin_s + message.valid_for.toSec();
  try {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      bridge_.accept(chunk, clock_.now());
    }
    // The outputs do not wait for a warning to be written.
    const double hold_s = chunk.valid_until_s - chunk.points.back().time_s;
    if (hold_s > ProcessPlan::kLongestHold + ProcessPlan::kMeet)
      ROS_WARN_STREAM_THROTTLE(
          kQuiet, "a process trajectory is valid for "
                      << numberText(hold_s) << " s behind its last point; expected at most "
                      << numberText(ProcessPlan::kLongestHold) << " s, after which the process is safe");
  } catch (const InvalidInput& error) {
    ROS_ERROR_STREAM_THROTTLE(kQuiet, "a process trajectory is refused: " << error.what());
  }
}

void ProcessIo::onPositions(const sensor_msgs::JointState& message) {
  std::map<std::string, double> positions;
  for (std::size_t i = 0; i < std::min(message.name.size(), message.position.size()); ++i)
    positions[message.name[i]] = message.position[i];
  const std::lock_guard<std::mutex> lock(mutex_);
  bridge_.updatePositions(positions, clock_.now());
}

void ProcessIo::onCycle(double due_s) {
  CycleView view;
  std::vector<DeviceReport> reports;
  for (const auto& link : links_) {
    reports.push_back(link->report());
    view.devices.push_back({reports.back().is_connected, reports.back().reason});
    view.late_s = std::max(view.late_s, reports.back().late_s);
  }
  view.measured = measuredBy(reports);
  const std::lock_guard<std::mutex> lock(mutex_);
  BridgeCycle cycle = bridge_.cycle(clock_.now(), view);
  sendToDevices(cycle.values, due_s);
  measured_ = std::move(view.measured);
  fault_ = std::move(cycle.fault);
  served_s_ = clock_.now();
  std::move(cycle.alarms.begin(), cycle.alarms.end(), std::back_inserter(news_));
  for (DeviceReport& report : reports)
    if (!report.note.empty()) notes_.push_back(std::move(report.note));
}

void ProcessIo::sendToDevices(const std::vector<double>& values, double due_s) {
  std::vector<std::vector<double>> raw(links_.size());
  for (std::size_t c = 0; c < values.size(); ++c)
    for (std::size_t d = 0; d < links_.size(); ++d)
      if (tables_.devices[d].name == tables_.channels[c].device)
        raw[d].push_back(rawOf(tables_.channels[c], values[c]));
  for (const std::size_t d : order_) links_[d]->send(std::move(raw[d]), due_s);
}

std::vector<double> ProcessIo::measuredBy(const std::vector<DeviceReport>& reports) const {
  std::vector<double> measured;
  std::vector<std::size_t> taken(reports.size(), 0);
  for (const InputChannel& input : tables_.inputs) {
    double value = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t d = 0; d < reports.size(); ++d) {
      if (tables_.devices[d].name != input.device) continue;
      const std::size_t index = taken[d]++;
      if (index < reports[d].inputs.size()) value = valueOf(input, reports[d].inputs[index]);
    }
    measured.push_back(value);
  }
  return measured;
}

void ProcessIo::publishState() {
  lamina_msgs::ProcessState state;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state = effectsMessage(tables_, bridge_.drives(), measured_);
  }
  state.header.stamp = ros::Time::now();
  state_.publish(state);
}

void ProcessIo::publishReady() {
  lamina_msgs::ProcessReady ready;
  std::vector<ProcessAlarm> news;
  std::vector<std::string> notes;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double unserved_s = clock_.now() - served_s_;
    ready.reason = unserved_s <= kUnserved
                       ? fault_
                       : "no output was found for " + numberText(unserved_s) + " s; expected one every " +
                             numberText(kUnserved) + " s at least";
    news = std::exchange(news_, {});
    notes = std::exchange(notes_, {});
  }
  ready.header.stamp = ros::Time::now();
  ready.ready = ready.reason.empty();
  ready_.publish(ready);
  for (const ProcessAlarm& alarm : news) publishAlarm(alarm);
  for (const std::string& note : notes) ROS_WARN_STREAM(note);
  diagnostics_.update();
}

void ProcessIo::publishAlarm(const ProcessAlarm& alarm) {
  if (alarm.is_gone)
    ROS_INFO_STREAM("alarm " << alarm.id << " of " << alarm.source << " is gone");
  else
    ROS_ERROR_STREAM("alarm " << alarm.id << ": " << alarm.message);
  alarms_.publish(toReport(alarm));
}

/// Whoever begins to listen knows of none that a process before this one may have raised.
void ProcessIo::tellAlarms(const ros::SingleSubscriberPublisher& subscriber) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::uint16_t id : {5101, 5102, 5106, 5107})
    subscriber.publish(toReport({id, "process_io", 0.0, {}, true}));
  for (const ProcessAlarm& alarm : bridge_.raised()) subscriber.publish(toReport(alarm));
}

void ProcessIo::diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) const {
  using diagnostic_msgs::DiagnosticStatus;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (fault_.empty())
    diagnostics.summary(DiagnosticStatus::OK, "ready");
  else
    diagnostics.summary(DiagnosticStatus::ERROR, fault_);
  for (std::size_t i = 0; i < links_.size(); ++i)
    diagnostics.add(tables_.devices[i].name, textOf(links_[i]->figures()));
  diagnostics.add("chunks that came late", bridge_.lateChunks());
  diagnostics.add("chunks that changed what was sent", bridge_.overtaken());
}

}  // namespace lamina
