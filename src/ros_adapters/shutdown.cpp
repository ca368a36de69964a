// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shutdown.hpp"

#include <ros/poll_manager.h>
#include <ros/ros.h>
#include <ros/service_manager.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "network/former_port.hpp"
#include "network/loopback.hpp"
#include "node_plugins.hpp"

namespace lamina {
namespace {

const ros::WallDuration kSignalPeriod(0.02);
constexpr double kDelivery = 1.5;  // [s] at most, until messages are on their way
const ros::WallDuration kDeliveryPeriod(0.002);
const ros::WallDuration kReading(0.5);  // that subscribers need to read them, also on a loaded host

// A signal handler can reach nothing but a variable of this kind, and threads no variable of another.
std::atomic<bool> was_stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void stop(int) { was_stop_requested = true; }

// roscpp's own handler shuts down from its polling thread, which then logs through loggers that are gone; and
// it knows SIGINT alone. Here the thread that spins shuts down, on SIGTERM and SIGHUP too.
ros::WallTimer shutdownOnSignal(const ros::NodeHandle& node) {
  return node.createWallTimer(kSignalPeriod, [](const ros::WallTimerEvent&) {
    if (was_stop_requested) ros::shutdown();
  });
}

// Who asks, and why: what has no reason is no request, as in roscpp.
void onShutdownCall(XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& answer) {
  answer = ros::xmlrpc::responseInt(1, "", 0);
  if (request.getType() != XmlRpc::XmlRpcValue::TypeArray || request.size() < 2) return;
  const bool is_text = request[1].getType() == XmlRpc::XmlRpcValue::TypeString;
  const std::string reason = is_text ? static_cast<std::string&>(request[1]) : "";
  ROS_WARN("asked to end: '%s'", reason.c_str());
  was_stop_requested = true;
}

// Of rosnode kill, and of the master where another node takes this one's name. roscpp's own handler cuts the
// node off from ROS before it has said anything, with the machine running.
void stopOnShutdownCall() {
  constexpr char kCall[] = "shutdown";
  const ros::XMLRPCManagerPtr& calls = ros::XMLRPCManager::instance();
  calls->unbind(kCall);
  calls->bind(kCall, onShutdownCall);
}

// In Debian's rosconsole, to list the loggers gives them away: the node would crash at its next new one, with
// the machine running. A logger's level can still be set.
void withdrawLoggerList() {
  ros::ServiceManager::instance()->unadvertiseService(ros::names::resolve("~get_loggers"));
}

void logFailure(const Failure& failure) {
  if (ros::ok())
    ROS_FATAL("%s: %s", toString(failure.code), failure.message.c_str());
  else
    std::fprintf(stderr, "%s: %s\n", toString(failure.code), failure.message.c_str());
}

}  // namespace

bool isStopRequested() { return was_stop_requested; }

void awaitDelivery() {
  // What is published waits for the polling thread. One pass may have begun before: the second holds it all.
  const auto passes = std::make_shared<std::atomic<int>>(0);
  const ros::PollManagerPtr& polling = ros::PollManager::instance();
  const auto listener = polling->addPollThreadListener([passes] { ++*passes; });
  const SteadyClock clock;
  const double end_s = clock.now() + kDelivery;
  while (ros::ok() && *passes < 2 && clock.now() < end_s) {
    polling->getPollSet().signal();
    kDeliveryPeriod.sleep();
  }
  polling->removePollThreadListener(listener);
  if (ros::ok()) kReading.sleep();
}

void runNode(int argc, char** argv, const NodeRun& run, const std::function<void()>& body) {
  int exit_code = 0;
  try {
    stayOnLoopback(argc, argv);
    ros::init(argc, argv, run.name, ros::init_options::NoSigintHandler);
    std::optional<HeldPort> former;
    if (const auto port = formerPort()) former.emplace(*port);
    const ros::NodeHandle node;
    former.reset();
    guardPorts();
    withdrawLoggerList();
    stopOnShutdownCall();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, stop);
    const ros::WallTimer timer =
        run.on_signal == OnSignal::ShutDown ? shutdownOnSignal(node) : ros::WallTimer();
    loadNodePlugins(ros::NodeHandle("~"));
    body();
  } catch (...) {
    logFailure(currentFailure());
    exit_code = 1;
  }
  ros::shutdown();
  // Threads of roscpp may still log for a moment: static objects such as the loggers must outlive them.
  // Everything of the node's own is destroyed by now.
  std::fflush(nullptr);
  std::quick_exit(exit_code);
}

}  // namespace lamina
