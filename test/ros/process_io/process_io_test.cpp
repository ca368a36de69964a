// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <std_msgs/Float64.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "lamina/process_io/devices/emulated_coupler.hpp"
#include "lamina/process_io/devices/process_device.hpp"
#include "lamina/process_io/lateness.hpp"
#include "ros/drive/drive_cell.hpp"
#include "ros/node_process.hpp"

namespace lamina {
namespace {

using test::DriveCell;
using test::NodeProcess;
using test::waitUntil;

constexpr double kDeadTime = 0.1;  // s, of the laser
constexpr int kSteps = 500;
constexpr double kStepS = 0.012;
constexpr double kStateHz = 20.0;
constexpr double kWatchdog = 5.0;  // s, of the coupler: a loaded host may keep the node waiting for a second

/// A cell of process_io, a coupler, a topic and a service, in a namespace of its own.
class ProcessCell {
 public:
  explicit ProcessCell(const std::string& space) : space_(space), node_(space), io_node_(space) {
    ModbusServerSettings server;
    server.port = 0;
    CouplerSettings settings;
    settings.dead_time_s = kDeadTime;
    settings.watchdog_s = kWatchdog;
    coupler = std::make_unique<CouplerServer>(settings, server);
    plan = node_.advertise<lamina_msgs::ProcessTrajectory>(names::kProcessTrajectory, 100);
    const boost::function<void(const lamina_msgs::ProcessReadyConstPtr&)> on_ready =
        [this](const auto& message) { ready = *message; };
    const boost::function<void(const lamina_msgs::ProcessStateConstPtr&)> on_state =
        [this](const auto& message) { states.push_back(*message); };
    const boost::function<void(const lamina_msgs::AlarmReportConstPtr&)> on_alarm =
        [this](const auto& message) { alarms.push_back(*message); };
    const boost::function<void(const std_msgs::Float64ConstPtr&)> on_fan = [this](const auto& message) {
      fans.push_back(message->data);
    };
    const boost::function<bool(lamina_msgs::SetIo::Request&, lamina_msgs::SetIo::Response&)> on_io =
        [this](auto& request, auto& response) { return setPin(request, response); };
    subscribers_ = {node_.subscribe<lamina_msgs::ProcessReady>(names::kProcessReady, 10, on_ready),
                    node_.subscribe<lamina_msgs::ProcessState>(names::kProcessState, 10000, on_state),
                    node_.subscribe<lamina_msgs::AlarmReport>(names::kAlarmReports, 100, on_alarm),
                    node_.subscribe<std_msgs::Float64>("fan_speed", 10000, on_fan)};
    // In a thread of its own: a node that ends still calls it.
    io_node_.setCallbackQueue(&io_queue_);
    service_ =
        io_node_.advertiseService<lamina_msgs::SetIo::Request, lamina_msgs::SetIo::Response>("set_io", on_io);
    io_spinner_.start();
    set("rate_hz", 250);
    set("late_s", 60.0);
    set("too_late_s", 60.0);
    set("standstill_s", 0.0);
    set("connect_wait_s", 0.2);
    set("state_hz", kStateHz);
    set("devices/coupler/kind", "modbus_tcp");
    set("devices/coupler/address", "127.0.0.1:" + std::to_string(coupler->port()));
    set("devices/coupler/timeout_s", 5.0);
    set("devices/coupler/watchdog_register", static_cast<int>(kCouplerWatchdog));
    set("devices/coupler/watchdog_most_s", kWatchdog);
    set("devices/topics/kind", "topic");
    set("devices/controller/kind", "set_io");
    set("devices/controller/address", "set_io");
    set("devices/controller/timeout_s", 5.0);
    addChannel("laser", "laser_power_w", "coupler", "0", 2000);
    set("channels/laser/dead_time_s", kDeadTime);
    set("channels/laser/scale", 10.0);
    addChannel("wire", "wire_speed_mm_s", "coupler", "1", 60);
    set("channels/wire/scale", 100.0);
    addChannel("fan", "fan", "topics", "fan_speed", 1);
    addChannel("gas", "gas", "controller", "4", 1);
    set("inputs/power/device", "coupler");
    set("inputs/power/read", static_cast<int>(kCouplerEffects));
    set("inputs/power/scale", 10.0);
    set("inputs/power/check", "follows");
    set("inputs/power/channel", "laser");
    set("inputs/power/tolerance", 1e6);
  }

  template <class Value>
  void set(const std::string& key, const Value& value) {
    ros::param::set(space_ + "/process_io/" + key, value);
  }
  void addChannel(const std::string& name, const std::string& quantity, const std::string& device,
                  const std::string& write, int high) {
    set("channels/" + name + "/quantity", quantity);
    set("channels/" + name + "/device", device);
    set("channels/" + name + "/write", write);
    set("channels/" + name + "/high", high);
  }

  std::unique_ptr<NodeProcess> start() const {
    return std::make_unique<NodeProcess>(LAMINA_IO_NODE, std::vector<std::string>{"__ns:=" + space_});
  }
  bool becomesReady() {
    return waitUntil([&] { return ready.ready && plan.getNumSubscribers() > 0; });
  }
  /// Laser, wire, gas and fan on for a time from now on, from off, the laser in steps: 100 W, 101 W, ...
  ros::Time run(int steps, double step_s) const {
    lamina_msgs::ProcessTrajectory message;
    message.header.stamp = ros::Time::now() + ros::Duration(0.3);
    message.points.emplace_back();
    for (int i = 0; i < steps; ++i) {
      lamina_msgs::ProcessPoint point;
      point.time_from_start = ros::Duration(step_s * i);
      point.flow = 1e-8;
      point.laser = point.wire = point.gas = true;
      point.laser_power = 100.0 + i;
      point.wire_speed = 0.03;
      point.screw_speed = point.powder_rate = point.gas_rate = NAN;
      point.fan = 0.5;
      message.points.push_back(point);
    }
    message.valid_for = ros::Duration(step_s * steps);
    plan.publish(message);
    return message.header.stamp;
  }
  std::vector<CouplerEvent> laserEvents() const {
    std::vector<CouplerEvent> all = coupler->events();
    all.erase(
        std::remove_if(all.begin(), all.end(), [](const CouplerEvent& event) { return event.output != 0; }),
        all.end());
    return all;
  }
  std::vector<lamina_msgs::SetIo::Request> pins() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return pins_;
  }
  bool isLit() const { return coupler->at(0) > 0; }

  std::unique_ptr<CouplerServer> coupler;
  ros::Publisher plan;
  lamina_msgs::ProcessReady ready;
  std::vector<lamina_msgs::ProcessState> states;
  std::vector<lamina_msgs::AlarmReport> alarms;
  std::vector<double> fans;
  std::atomic<bool> is_called{false};  ///< the service
  std::atomic<bool> hangs{false};      ///< the service, which answers once it no longer does

 private:
  bool setPin(const lamina_msgs::SetIo::Request& request, lamina_msgs::SetIo::Response& response) {
    is_called = true;
    while (hangs) ros::WallDuration(0.01).sleep();
    const std::lock_guard<std::mutex> lock(mutex_);
    pins_.push_back(request);
    response.success = true;
    return true;
  }

  std::string space_;
  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
  std::mutex mutex_;  ///< of the pins
  std::vector<lamina_msgs::SetIo::Request> pins_;
  ros::NodeHandle io_node_;
  ros::CallbackQueue io_queue_;
  ros::AsyncSpinner io_spinner_{1, &io_queue_};
  ros::ServiceServer service_;
};

TEST(ProcessIo, OutputsComeInOrderAndEndSafe) {
  ProcessCell cell("/in_order");
  const auto node = cell.start();
  ASSERT_TRUE(cell.becomesReady()) << cell.ready.reason;
  const double offset_s = SteadyClock().now() - ros::Time::now().toSec();
  const double begin_s = cell.run(kSteps, kStepS).toSec() + offset_s;
  ASSERT_TRUE(waitUntil([&] { return cell.isLit(); }));
  ASSERT_TRUE(waitUntil([&] { return !cell.isLit(); }));
  const std::vector<CouplerEvent> events = cell.laserEvents();
  EXPECT_EQ(events.back().value, 0);
  Lateness lateness;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    ASSERT_EQ(events[i].value % 10, 0);
    const int step = events[i].value / 10 - 100;
    ASSERT_TRUE(step >= 0 && step < kSteps) << step;
    EXPECT_TRUE(i == 0 || events[i].value > events[i - 1].value);
    lateness.add(events[i].time_s - (begin_s + kStepS * step - kDeadTime));
  }
  // By the device's own watchdog, if this host stood still meanwhile.
  EXPECT_LE(events.back().time_s, events[events.size() - 2].time_s + kStepS * kSteps + kWatchdog);
  std::printf(
      "%d steps, %zu sent; late by %.1f ms (50 %%), %.1f ms (99 %%), %.1f ms at most; safe %.1f ms after "
      "the end\n",
      kSteps, events.size() - 1, 1e3 * lateness.percentile(0.5), 1e3 * lateness.percentile(0.99),
      1e3 * lateness.worst(), 1e3 * (events.back().time_s - (begin_s + kStepS * kSteps - kDeadTime)));
  EXPECT_TRUE(waitUntil([&] { return !cell.fans.empty() && cell.fans.back() == 0.0; }));
  EXPECT_EQ(*std::max_element(cell.fans.begin(), cell.fans.end()), 0.5);
  ASSERT_TRUE(waitUntil([&] { return cell.pins().size() >= 3; }));
  EXPECT_EQ(cell.pins()[0].state, 0.0F);  // safe first
  EXPECT_EQ(cell.pins()[1].state, 1.0F);
  EXPECT_EQ(cell.pins()[1].fun, 1);
  EXPECT_EQ(cell.pins()[1].pin, 4);
  EXPECT_EQ(cell.pins()[2].state, 0.0F);
  const double states_s = (cell.states.back().header.stamp - cell.states.front().header.stamp).toSec();
  EXPECT_LE(static_cast<double>(cell.states.size()), 1.2 * kStateHz * states_s + 2.0)
      << "no oftener than it says";
  const auto lit = std::find_if(cell.states.begin(), cell.states.end(),
                                [](const auto& state) { return state.laser && state.laser_power > 200.0; });
  ASSERT_NE(lit, cell.states.end());
  EXPECT_NEAR(lit->wire_speed, 0.03, 1e-9);
  EXPECT_TRUE(lit->wire && lit->gas);
  EXPECT_FALSE(lit->powder);
  EXPECT_TRUE(std::isnan(lit->screw_speed) && std::isnan(lit->powder_rate) && std::isnan(lit->gas_rate));
  EXPECT_EQ(lit->fan, 0.5);
  ASSERT_EQ(lit->outputs.size(), 4U);
  EXPECT_EQ(lit->outputs[0].name, "laser");
  EXPECT_EQ(lit->outputs[0].quantity, "laser_power_w");
  EXPECT_EQ(lit->outputs[0].measured, lit->laser_power);
  EXPECT_GT(lit->outputs[0].expected, 100.0);
  EXPECT_GT(lit->outputs[0].commanded, 100.0);
  EXPECT_EQ(node->end(SIGINT), 0);
}

TEST(ProcessIo, ALostDeviceMakesTheOthersSafeAndIsAnAlarm) {
  ProcessCell cell("/lost");
  const auto node = cell.start();
  ASSERT_TRUE(cell.becomesReady()) << cell.ready.reason;
  cell.run(1000, 1.0);
  ASSERT_TRUE(
      waitUntil([&] { return cell.isLit() && !cell.pins().empty() && cell.pins().back().state == 1.0F; }));
  cell.coupler.reset();
  ASSERT_TRUE(waitUntil([&] { return !cell.ready.ready; }));
  EXPECT_NE(cell.ready.reason.find("coupler"), std::string::npos) << cell.ready.reason;
  EXPECT_TRUE(waitUntil(
      [&] { return cell.pins().back().state == 0.0F && !cell.fans.empty() && cell.fans.back() == 0.0; }));
  ASSERT_TRUE(waitUntil([&] { return !cell.alarms.empty() && !cell.alarms.back().is_gone; }));
  EXPECT_EQ(cell.alarms.back().id, 5102);
  EXPECT_EQ(cell.alarms.back().source, "process_io") << "which alone says that it is gone";
  EXPECT_EQ(cell.alarms.back().message, cell.ready.reason);
}

TEST(ProcessIo, GoesOnAsPlannedWhereAPlanStatesATimeThatNoClockGives) {
  ProcessCell cell("/garbled");
  const auto node = cell.start();
  ASSERT_TRUE(cell.becomesReady()) << cell.ready.reason;
  cell.run(1000, 1.0);
  ASSERT_TRUE(waitUntil([&] { return cell.isLit(); }));
  lamina_msgs::ProcessTrajectory garbled;
  garbled.header.stamp = ros::Time(4294967295, 0);
  garbled.points.resize(1);
  cell.plan.publish(garbled);
  cell.run(1, 0.2);
  EXPECT_TRUE(waitUntil([&] { return !cell.fans.empty() && cell.fans.back() == 0.0 && !cell.isLit(); }));
  EXPECT_EQ(node->end(SIGTERM), 0) << "a node that dies leaves devices without a watchdog on";
}

TEST(ProcessIo, EndsSafeAndIsSafeByTheDeviceWhenItIsKilled) {
  ProcessCell cell("/ended");
  auto node = cell.start();
  ASSERT_TRUE(cell.becomesReady()) << cell.ready.reason;
  cell.run(1000, 1.0);
  ASSERT_TRUE(waitUntil([&] { return cell.isLit(); }));
  EXPECT_EQ(node->end(SIGTERM), 0);
  EXPECT_FALSE(cell.isLit());
  // What is sent before its link is gone would go to the one that ended.
  ASSERT_TRUE(waitUntil([&] { return cell.plan.getNumSubscribers() == 0; }));
  cell.ready = {};
  node = cell.start();
  ASSERT_TRUE(cell.becomesReady()) << cell.ready.reason;
  cell.run(1000, 1.0);
  ASSERT_TRUE(waitUntil([&] { return cell.isLit(); }));
  node->end(SIGKILL);
  ASSERT_TRUE(waitUntil([&] { return !cell.isLit(); }));
  EXPECT_EQ(cell.laserEvents().back().cause, CouplerEvent::Cause::Watchdog);
}

TEST(ProcessIo, EndsWhileAServiceDoesNotAnswer) {
  ProcessCell cell("/hung");
  cell.set("devices/controller/timeout_s", 0.5);
  cell.hangs = true;
  const auto node = cell.start();
  EXPECT_TRUE(waitUntil([&] { return cell.is_called.load(); }));
  EXPECT_EQ(node->end(SIGTERM), 0);
  cell.hangs = false;
}

TEST(ProcessIo, RefusesTablesThatDoNotFit) {
  ProcessCell cell("/refused");
  cell.set("channels/laser/device", "nowhere");
  EXPECT_EQ(cell.start()->wait(), 1);
}

/// Says whether the process can be run, ten times a second.
class SaidReady {
 public:
  explicit SaidReady(ros::NodeHandle node)
      : publisher_(node.advertise<lamina_msgs::ProcessReady>(names::kProcessReady, 10)),
        thread_([this] { run(); }) {}
  ~SaidReady() {
    is_ending_ = true;
    thread_.join();
  }
  void say(bool is_ready) { is_ready_ = is_ready; }
  void fallSilent() { is_silent_ = true; }

 private:
  void run() {
    for (; !is_ending_; ros::WallDuration(0.1).sleep()) {
      if (is_silent_) continue;
      lamina_msgs::ProcessReady message;
      message.header.stamp = ros::Time::now();
      message.ready = is_ready_;
      message.reason = is_ready_ ? "" : "no cooling water";
      publisher_.publish(message);
    }
  }
  ros::Publisher publisher_;
  std::atomic<bool> is_ready_{false};
  std::atomic<bool> is_silent_{false};
  std::atomic<bool> is_ending_{false};
  std::thread thread_;
};

Toolpath longBead() {
  Path path;
  path.role = PathRole::Infill;
  path.bead = Bead{1.0, 0.5};
  path.feed_mm_s = 2.0;
  path.points = {{-20, 0, 0.5}, {20, 0, 0.5}};
  path.values = {{"laser_power_w", 900.0}, {"wire_speed_mm_s", 12.0}};
  return {"bead", {{0.5, 0.5, {path}}}};
}

TEST(ProcessIo, ADriverThatNeedsItWaitsForItAndHoldsWithoutIt) {
  DriveCell cell("driven", "five_axis_head_table");
  SaidReady said(ros::NodeHandle("driven"));
  cell.drive(longBead());
  const std::size_t before = cell.processes;
  ASSERT_TRUE(waitUntil([&] { return cell.state == "Starting"; })) << cell.state;
  EXPECT_EQ(cell.processes, before);
  said.say(true);
  ASSERT_TRUE(waitUntil([&] { return cell.isDepositing(); }));
  ASSERT_TRUE(waitUntil([&] { return cell.reports.back().process.laser_power > 0.0; }));
  EXPECT_EQ(cell.reports.back().process.laser_power, 900.0);
  EXPECT_TRUE(waitUntil([&] { return std::abs(cell.reports.back().process.wire_speed - 0.012) < 1e-9; }));
  said.say(false);
  ASSERT_TRUE(cell.comesTo("Held")) << cell.state;
  EXPECT_TRUE(cell.staysSafe());
  EXPECT_FALSE(cell.calls(names::kResume));
  said.say(true);
  bool is_resumed = false;
  ASSERT_TRUE(waitUntil([&] { return is_resumed = is_resumed || cell.calls(names::kResume); }));
  ASSERT_TRUE(cell.comesTo("Execute")) << cell.state;
  ASSERT_TRUE(waitUntil([&] { return cell.isDepositing(); }));
  said.fallSilent();
  ASSERT_TRUE(cell.comesTo("Held")) << cell.state;
  EXPECT_TRUE(cell.calls(names::kAbort));
  EXPECT_TRUE(cell.ends());
}

TEST(ProcessIo, TheLaunchFileStartsIt) {
  ros::NodeHandle node("launched");
  bool is_ready = false;
  const boost::function<void(const lamina_msgs::ProcessReadyConstPtr&)> on_ready = [&](const auto& message) {
    is_ready = message->ready;
  };
  const ros::Subscriber subscriber =
      node.subscribe<lamina_msgs::ProcessReady>(names::kProcessReady, 10, on_ready);
  EXPECT_TRUE(waitUntil([&] { return is_ready; }));
}

TEST(ProcessIo, TheEmulatedCouplerIsADevice) {
  int port = 0;
  ASSERT_TRUE(waitUntil([&] { return ros::param::get("/coupled/emulated_coupler/port", port) && port > 0; }));
  DeviceTable table;
  table.device.name = "coupler";
  table.device.kind = DeviceKind::ModbusTcp;
  table.device.address = "127.0.0.2:" + std::to_string(port);
  table.device.timeout_s = 5.0;
  table.device.watchdog_register = kCouplerWatchdog;
  table.channels.resize(1);
  table.channels[0].write = "3";
  table.channels[0].high = 1000.0;
  table.inputs.resize(2);
  table.inputs[0].read = kCouplerEffects + 3;
  table.inputs[1].read = kCouplerReady;
  const auto device = makeProcessDevice(table);
  EXPECT_EQ(device->open(), "");
  EXPECT_EQ(device->exchange({700.0}), (std::vector<double>{700.0, 0.0}));
}

}  // namespace
}  // namespace lamina
