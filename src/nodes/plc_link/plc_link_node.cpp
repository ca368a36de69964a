// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plc_link_node.hpp"

#include <ros/ros.h>
#include <sys/timex.h>

#include <utility>

#include "latched.hpp"
#include "names.hpp"
#include "network/exposure.hpp"

namespace lamina {
namespace {

constexpr double kTickInterval = 0.02;       // [s]
constexpr double kPublishInterval = 0.5;     // [s]
constexpr double kLongestUnitSilence = 1.5;  // [s] of a unit that speaks twice a second
constexpr double kMinute = 60.0;
constexpr std::size_t kBrokenFramesAMinute = 20;
constexpr std::size_t kRefusalsAMinute = 5;
constexpr int kRefusedRepeatedly = 2102;
constexpr int kBrokenFrames = 2103;
constexpr int kReachable = 9002;

/// Whether something keeps this host's clock in step with others.
bool isClockSynchronised() {
  timex clock{};
  return ntp_adjtime(&clock) != TIME_ERROR;
}

}  // namespace

PlcLinkNode::PlcLinkNode(const ros::NodeHandle& node, const LinkSettings& settings)
    : node_(node),
      settings_(settings),
      inputs_(node_.advertise<lamina_msgs::PlcInputs>(names::kPlcInputs, 100, true)),
      alarms_(node_.advertise<lamina_msgs::AlarmReport>(names::kAlarmReports, 100)),
      link_(settings.link),
      linked_(ros::WallTime::now().toSec()),
      broken_frames_(kBrokenFramesAMinute, kMinute),
      refusals_(kRefusalsAMinute, kMinute) {
  subscribers_ = {node_.subscribe(names::kPackmlStatus, 100, &PlcLinkNode::onStatus, this),
                  node_.subscribe(names::kProcessState, 1, &PlcLinkNode::onProcess, this),
                  node_.subscribe(names::kPrintProgress, 1, &PlcLinkNode::onPrinted, this),
                  node_.subscribe(names::kHeaterState, 100, &PlcLinkNode::onHeaters, this)};
  view(names::kAlarms, &UnitView::alarms);
  view(names::kJobQueue, &UnitView::queue);
  view(names::kMachineState, &UnitView::machine);
  view(names::kLoopState, &UnitView::loop);
  view(names::kLayerHeight, &UnitView::layer);
  view(names::kLoopFigures, &UnitView::figures);
  subscribers_.push_back(node_.subscribe(names::kCorrection, 100, &PlcLinkNode::onCorrection, this));
  desk_ = std::make_unique<OrderDesk>(
      node_, [this](const PlcOrder& order, CommandResult result, const std::string& message) {
        onAnswered(order, result, message);
      });
  const ModbusPeers peers = {
      [this](int connection, const ModbusRequest& request) { return answer(connection, request); },
      [this](int connection) { onClosed(connection); },
      [this](const std::string& address, const std::string& reason) { onBroken(address, reason); }};
  server_ = std::make_unique<ModbusServer>(serverSettings(settings), peers);
  if (!isLoopbackHost(settings.bind))
    ROS_WARN_STREAM("Modbus listens on " << settings.bind << ':' << port()
                                         << ", which other hosts may reach; it knows no passwords");
  ROS_INFO_STREAM("Modbus listens on " << settings.bind << ':' << port());
  const boost::function<void(const ros::WallTimerEvent&)> tick = [this](const auto&) { onTick(); };
  diagnostics_.begin(settings.bind + ':' + std::to_string(port()), "PLC",
                     [this](auto& diagnostics) { diagnose(diagnostics); });
  timer_ = node_.createWallTimer(ros::WallDuration(kTickInterval), tick);
}

template <class Message>
void PlcLinkNode::view(const char* topic, Message UnitView::*place) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> keep = [this,
                                                                               place](const auto& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    view_.*place = *message;
    refreshRegisters(clock_.now());
  };
  subscribers_.push_back(node_.subscribe<Message>(topic, 100, keep));
}

void PlcLinkNode::onStatus(const lamina_msgs::PackmlStatusConstPtr& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.unit = *status;
  view_.unit_heard_s = clock_.now();
  if (!std::exchange(is_unit_here_, true)) is_reach_reported_ = isLoopbackHost(settings_.bind);
  link_.setPresence(UnitPresence::Present, clock_.now());
  link_.setRemoteAccess(status->remote_access != 0 ? RemoteAccess::Allowed : RemoteAccess::Locked);
  refreshRegisters(clock_.now());
  // The unit may speak before it hears: what nobody takes is lost.
  if (is_reach_reported_ || alarms_.getNumSubscribers() == 0) return;
  is_reach_reported_ = true;
  raise(kReachable, port(), "Modbus listens on " + settings_.bind + ':' + std::to_string(port()));
}

void PlcLinkNode::onProcess(const lamina_msgs::ProcessStateConstPtr& process) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.process = *process;
  view_.process_heard_s = clock_.now();
}

void PlcLinkNode::onPrinted(const lamina_msgs::PrintProgressConstPtr& printed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.printed = *printed;
  view_.printed_heard_s = clock_.now();
}

void PlcLinkNode::onHeaters(const lamina_msgs::HeaterStateConstPtr& heaters) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.heaters = *heaters;
  view_.heaters_heard_s = clock_.now();
}

void PlcLinkNode::onCorrection(const lamina_msgs::CorrectionMapConstPtr& map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto& means = view_.mean_corrections;
  if (map->toolpath_id != corrected_) means.clear();
  corrected_ = map->toolpath_id;
  means[map->digest] = meanCorrection(*map);
}

void PlcLinkNode::onTick() {
  followUnit();
  diagnostics_.update();
}

void PlcLinkNode::followUnit() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double now_s = clock_.now();
  if (is_unit_here_ && now_s - view_.unit_heard_s > kLongestUnitSilence) {
    is_unit_here_ = false;
    ROS_WARN("the unit says nothing; commands are answered 'busy' until it does");
    link_.setPresence(UnitPresence::Lost, now_s);
  }
  followHeartbeat(now_s);
  refreshRegisters(now_s);
  if (now_s - published_s_ >= kPublishInterval) publishInputs();
}

void PlcLinkNode::followHeartbeat(double now_s) {
  const PlcHeartbeat heartbeat = link_.watch(now_s);
  if (std::exchange(heartbeat_, heartbeat) == heartbeat) return;
  if (heartbeat == PlcHeartbeat::Lost) ROS_WARN("the PLC's heartbeat does not come");
  publishInputs();
}

std::string PlcLinkNode::answer(int connection, const ModbusRequest& request) {
  std::vector<WrittenOrder> written;
  std::string bytes;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes = link_.answer(connection, request, clock_.now());
    if (request.written.empty()) return bytes;
    followHeartbeat(clock_.now());
    if (link_.news() != published_news_) publishInputs();
    for (const PlcOrder& order : link_.takeOrders()) written.push_back({order, inputsNow()});
  }
  desk_->give(written);
  return bytes;
}

void PlcLinkNode::onClosed(int connection) {
  const std::lock_guard<std::mutex> lock(mutex_);
  link_.close(connection);
}

void PlcLinkNode::onBroken(const std::string& address, const std::string& reason) {
  ROS_WARN_STREAM_THROTTLE(1.0, "the connection of " << address << " was closed: " << reason);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++reach_.broken_frames;
  reach_.last_break = address + ": " + reason;
  if (broken_frames_.add(clock_.now()))
    raise(kBrokenFrames, kBrokenFramesAMinute,
          "more than " + std::to_string(kBrokenFramesAMinute) + " within a minute, the last from " + address +
              ": " + reason);
}

void PlcLinkNode::onAnswered(const PlcOrder& order, CommandResult result, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  link_.setResult(order, result);
  if (result == CommandResult::Accepted) return;
  // A PLC asks a hundred times a second what is refused: once each is enough to read.
  if (std::exchange(refusal_, message) != message)
    ROS_WARN_STREAM("what the PLC asks for is refused: " << message);
  if (refusals_.add(clock_.now()))
    raise(kRefusedRepeatedly, kRefusalsAMinute,
          "more than " + std::to_string(kRefusalsAMinute) + " within a minute, the last: " + message);
}

void PlcLinkNode::refreshRegisters(double now_s) {
  PlcStatus status = plcStatus(view_, now_s);
  status.utc_s = ros::WallTime::now().toSec();
  status.is_clock_synchronised = isClockSynchronised();
  link_.setStatus(status);
}

/// As published last.
lamina_msgs::PlcInputs PlcLinkNode::inputsNow() {
  const PlcInputs said = link_.inputs();
  lamina_msgs::PlcInputs message;
  message.header.stamp = ros::Time::now();
  message.linked = linked_;
  message.sequence = sequence_;
  message.watchdog = static_cast<std::uint8_t>(heartbeat_);
  message.is_beating = link_.isBeating(clock_.now());
  message.on_silence = static_cast<std::uint8_t>(settings_.on_silence);
  message.has_material = said.has_material;
  message.has_gas = said.has_gas;
  message.has_cooling = said.has_cooling;
  message.has_vacuum = said.has_vacuum;
  message.is_blocked = said.is_blocked;
  message.is_starved = said.is_starved;
  message.is_guard_closed = said.is_guard_closed;
  message.is_guard_reset = said.is_guard_reset;
  message.is_emergency_stop_pressed = said.is_emergency_stop_pressed;
  message.is_plate_told = link_.isPlateWritten();
  message.is_plate_there = said.is_plate_there;
  message.is_plate_clamped = said.is_plate_clamped;
  message.is_part_removed = said.is_part_removed;
  message.is_zone_taken = said.is_zone_taken;
  message.speed = said.speed;
  message.badge = said.badge;
  return message;
}

void PlcLinkNode::publishInputs() {
  ++sequence_;
  published_news_ = link_.news();
  published_s_ = clock_.now();
  publishLatched(inputs_, inputsNow());
}

void PlcLinkNode::diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  const std::lock_guard<std::mutex> lock(mutex_);
  PlcReach reach = reach_;
  reach.is_unit_here = is_unit_here_;
  reach.last_refusal = refusal_;
  fillDiagnostics(inputsNow(), reach, diagnostics);
}

void PlcLinkNode::raise(int alarm, double value, const std::string& message) {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = static_cast<std::uint16_t>(alarm);
  report.source = "plc_link";
  report.value = value;
  report.message = message;
  alarms_.publish(report);
}

}  // namespace lamina
