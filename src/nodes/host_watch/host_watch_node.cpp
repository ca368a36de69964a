// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host_watch_node.hpp"

#include <ros/ros.h>

#include <limits>
#include <utility>

#include "host_diagnostics.hpp"
#include "lamina/base/disk_space.hpp"
#include "lamina/base/text.hpp"
#include "latched.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kTickInterval = 0.1;   // [s]
constexpr double kStateInterval = 1.0;  // [s]

std::vector<PeerHost> hostsOf(const std::vector<PeerAddress>& addresses) {
  std::vector<PeerHost> hosts;
  hosts.reserve(addresses.size());
  for (const PeerAddress& peer : addresses) hosts.push_back(peer.host);
  return hosts;
}

lamina_msgs::HostPeer toMessage(const PeerStatus& peer, const PeerAddress& address, double now_s) {
  lamina_msgs::HostPeer message;
  message.name = peer.host.name;
  message.address = address.address + ":" + std::to_string(address.port);
  message.is_needed = peer.host.is_needed;
  message.is_lost = peer.is_lost;
  message.silent = now_s - peer.heard_at_s;
  const auto offset = peer.clocks.offset();
  message.is_compared = offset.has_value();
  message.clock_offset = offset ? offset->offset_s : std::numeric_limits<double>::quiet_NaN();
  message.clock_uncertainty = offset ? offset->uncertainty_s : std::numeric_limits<double>::quiet_NaN();
  return message;
}

lamina_msgs::HostNode toMessage(const NodeStatus& node) {
  lamina_msgs::HostNode message;
  message.name = node.name;
  message.answers = node.answers;
  message.pid = static_cast<std::uint32_t>(node.pid);
  message.restarts = static_cast<std::uint32_t>(node.restarts);
  return message;
}

}  // namespace

HostWatchNode::HostWatchNode(ros::NodeHandle node, const HostWatchNodeSettings& settings)
    : settings_(settings),
      addresses_(peersOf(settings)),
      watch_(watchOf(settings), hostsOf(addresses_), shiftedNow(settings.shift_s)),
      alarms_(node.advertise<lamina_msgs::AlarmReport>(names::kAlarmReports, 100,
                                                       [this](const auto& listener) { greet(listener); })),
      state_(node.advertise<lamina_msgs::HostState>(names::kHostState, 10, true)),
      look_(watchedNodes(settings, node.getNamespace()), settings.watch.master_silence_s / 5.0, watch_,
            mutex_),
      link_(settings, watch_, mutex_) {
  if (!addresses_.empty() && settings.bind.compare(0, 4, "127.") != 0)
    ROS_WARN_STREAM(
        "UDP port " << settings.port << " of " << settings.bind
                    << " is open to the network; datagrams of other hosts than hosts.peers are dropped");
  const boost::function<void(const ros::WallTimerEvent&)> tick = [this](const auto&) { onTick(); };
  if (!settings.guard_socket.empty()) watchMachine();
  diagnostics_.begin(settings.watch.host, "host", [this](auto& diagnostics) { diagnose(diagnostics); });
  timer_ = node.createWallTimer(ros::WallDuration(kTickInterval), tick);
}

void HostWatchNode::watchMachine() {
  WatchObserver observer;
  observer.news = [this](const GuardNews& news) { onMachine(news); };
  observer.begun = [] { ROS_WARN("the stop of a machine whose executor is lost has begun"); };
  observer.heard = [this](const MachinePulse& pulse) {
    if (pulse.firmware == kFollowsTrajectories) controllers_.connect(pulse.port.name);
  };
  const MachineStopper stop = [this](const MachinePulse& machine, const std::function<void()>& begun) {
    return machine.firmware == kFollowsTrajectories ? controllers_.stop(machine.port.name, begun)
                                                    : stopMachine(machine, begun);
  };
  machine_.emplace(settings_.guard_socket, settings_.guard, std::move(observer), stop);
}

lamina_msgs::AlarmReport HostWatchNode::reportOf(const HostAlarm& alarm) const {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = static_cast<std::uint16_t>(alarm.id);
  report.source = "host_watch of " + settings_.watch.host;
  report.value = alarm.value;
  report.message = alarm.message;
  report.is_gone = alarm.is_gone;
  return report;
}

/// A cell that was started anew has forgotten what was raised; one that was there may wait for the end of
/// what a process before this one has raised.
void HostWatchNode::greet(const ros::SingleSubscriberPublisher& listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const HostAlarm& alarm : watch_.present()) listener.publish(reportOf(alarm));
  if (settings_.guard_socket.empty()) return;
  for (const HostAlarm& alarm : machine_alarms_.present()) listener.publish(reportOf(alarm));
}

void HostWatchNode::onMachine(const GuardNews& news) {
  std::vector<HostAlarm> alarms;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    alarms = machine_alarms_.of(news);
  }
  if (news.kind == GuardNewsKind::Back) ROS_INFO_STREAM("the executor is back: " << news.message);
  for (const HostAlarm& alarm : alarms) {
    if (!alarm.is_gone) ROS_WARN_STREAM(alarm.id << ": " << alarm.message);
    alarms_.publish(reportOf(alarm));
  }
}

void HostWatchNode::onTick() {
  const auto free_bytes = freeBytesOf(settings_.folder);
  std::vector<HostAlarm> alarms;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (free_bytes) watch_.onFreeSpace(static_cast<double>(*free_bytes));
    alarms = watch_.tick(shiftedNow(settings_.shift_s));
  }
  for (const HostAlarm& alarm : alarms) {
    if (!alarm.is_gone) ROS_WARN_STREAM(alarm.id << ": " << alarm.message);
    alarms_.publish(reportOf(alarm));
  }
  const double now_s = shiftedNow(0.0).steady_s;
  if (alarms.empty() && now_s - published_s_ < kStateInterval) return;
  published_s_ = now_s;
  publish();
}

void HostWatchNode::publish() {
  lamina_msgs::HostState state;
  state.header.stamp = ros::Time::now();
  state.host = settings_.watch.host;
  const double now_s = shiftedNow(0.0).steady_s;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state.has_master = watch_.hasMaster();
    state.master_defect = watch_.masterDefect();
    state.free_space = watch_.freeBytes().value_or(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < addresses_.size(); ++i)
      state.peers.push_back(toMessage(watch_.peers()[i], addresses_[i], now_s));
    for (const NodeStatus& watched : watch_.nodes()) state.nodes.push_back(toMessage(watched));
  }
  publishLatched(state_, state);
  published_ = std::move(state);
  diagnostics_.update();
}

void HostWatchNode::diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  std::vector<HostAlarm> alarms;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    alarms = watch_.present();
    const std::vector<HostAlarm> of_machine = machine_alarms_.present();
    if (!settings_.guard_socket.empty()) alarms.insert(alarms.end(), of_machine.begin(), of_machine.end());
  }
  fillDiagnostics(published_, alarms, diagnostics);
}

}  // namespace lamina
