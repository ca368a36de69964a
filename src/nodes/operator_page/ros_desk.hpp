// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/Image.h>

#include <mutex>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/web/cell_desk.hpp"
#include "lamina/web/node_lanes.hpp"
#include "lamina/web/order_lane.hpp"
#include "lamina/web/program_preview.hpp"
#include "messages.hpp"
#include "program_layers.hpp"

namespace lamina {

/// The cell over ROS: its state from topics, and services that take orders.
class RosDesk final : public CellDesk {
 public:
  /// @param patience_s  for an answer of the cell
  RosDesk(ros::NodeHandle node, double patience_s);

  void setCamera(bool is_there);

  CellSnapshot snapshot() const override;
  ShownDeviation deviation() const override;
  ShownPreview preview(std::int32_t layer) override;

  DeskAnswer command(const DeskCommand& command) override;
  DeskAnswer changeMode(int mode, const std::string& source) override;
  DeskAnswer setPlcAccess(PlcAccess access, const std::string& source) override;
  DeskAnswer moveByHand(const DeskManual& order) override;
  DeskAnswer enqueue(const DeskProgram& program) override;
  DeskAnswer enqueueMesh(const DeskMesh& mesh) override;
  DeskAnswer changeQueue(QueueChange change, std::int64_t job, const std::string& source) override;
  DeskAnswer moveJob(std::int64_t job, std::int64_t place, const std::string& source) override;
  DeskAnswer acknowledge(int alarm, const std::string& source) override;
  DeskAnswer confirmRemoval(const std::string& source) override;
  DeskAnswer judge(const DeskVerdict& verdict) override;
  DeskAnswer startup(StartupCommand command, const std::string& step) override;
  DeskAnswer setLoop(ShownLoopRequest request) override;
  void report(int alarm, double value, const std::string& message) override;

 private:
  void onStatus(const lamina_msgs::PackmlStatusConstPtr& status);
  void onAlarms(const lamina_msgs::CellAlarmsConstPtr& alarms);
  void onQueue(const lamina_msgs::JobQueueConstPtr& queue);
  void onMachine(const lamina_msgs::MachineStateConstPtr& machine);
  void onHeaters(const lamina_msgs::HeaterStateConstPtr& heaters);
  void onLoop(const lamina_msgs::LoopStateConstPtr& loop);
  void onManual(const lamina_msgs::ManualStateConstPtr& manual);
  void onLayer(const lamina_msgs::LayerHeightConstPtr& layer);
  void onDeviation(const sensor_msgs::ImageConstPtr& image);

  /// What an order is to its lane.
  struct Label {
    std::string kind;
    OrderEffect effect = OrderEffect::Other;
    const char* node = kUnitNode;
  };
  static constexpr const char* kUnitNode = "cell_controller";
  static constexpr const char* kStartupNode = "gcode_streamer";
  static constexpr const char* kLoopNode = "height_controller";
  template <class Service>
  DeskAnswer callUnit(const Label& label, const char* name, const Service& call);
  template <class Service>
  DeskAnswer callForStatus(const Label& label, const char* name, const Service& call);
  DeskAnswer callQueue(lamina_msgs::ChangeQueue call, std::int64_t job);

  ros::NodeHandle node_;
  double patience_s_;
  SteadyClock clock_;
  mutable std::mutex mutex_;  // guards received messages
  CellSnapshot seen_;
  ShownDeviation deviation_;
  ProgramPreview preview_{layersOf};
  ros::Publisher alarm_reports_;
  std::vector<ros::Subscriber> subscribers_;
  NodeLanes lanes_{{kUnitNode, kStartupNode, kLoopNode}};
  // Reading programs and slicing meshes takes minutes.
  OrderLane programs_;
  OrderLane meshes_;
};

}  // namespace lamina
