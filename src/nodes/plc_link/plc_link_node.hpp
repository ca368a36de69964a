// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/modbus/modbus_server.hpp"
#include "lamina/modbus/plc_link.hpp"
#include "lamina/modbus/repeat_watch.hpp"
#include "link_settings.hpp"
#include "node_diagnostics.hpp"
#include "order_desk.hpp"
#include "plc_diagnostics.hpp"
#include "unit_view.hpp"

namespace lamina {

/// The PLC link on ROS: shows the unit in registers, passes on the PLC's requests, and publishes its inputs.
/// Its topics and parameters: docs/nodes/plc_link.md.
class PlcLinkNode {
 public:
  /// @throws DeviceError if it cannot listen
  PlcLinkNode(const ros::NodeHandle& node, const LinkSettings& settings);

  std::uint16_t port() const { return server_->port(); }

 private:
  template <class Message>
  void view(const char* topic, Message UnitView::*place);
  void onStatus(const lamina_msgs::PackmlStatusConstPtr& status);
  void onProcess(const lamina_msgs::ProcessStateConstPtr& process);
  void onPrinted(const lamina_msgs::PrintProgressConstPtr& printed);
  void onHeaters(const lamina_msgs::HeaterStateConstPtr& heaters);
  void onCorrection(const lamina_msgs::CorrectionMapConstPtr& map);
  void onTick();
  void followUnit();

  std::string answer(int connection, const ModbusRequest& request);
  void onClosed(int connection);
  void onBroken(const std::string& address, const std::string& reason);
  void onAnswered(const PlcOrder& order, CommandResult result, const std::string& message);

  void followHeartbeat(double now_s);
  void refreshRegisters(double now_s);
  lamina_msgs::PlcInputs inputsNow();
  void publishInputs();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);
  void raise(int alarm, double value, const std::string& message);

  ros::NodeHandle node_;
  LinkSettings settings_;
  SteadyClock clock_;
  ros::Publisher inputs_;
  ros::Publisher alarms_;
  NodeDiagnostics diagnostics_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer timer_;

  std::mutex mutex_;  ///< guards everything below except the server and the desk
  PlcLink link_;
  UnitView view_;
  std::string corrected_;  ///< toolpath of the maps in `view_`
  PlcHeartbeat heartbeat_ = PlcHeartbeat::Unarmed;
  ros::Time linked_;
  std::uint32_t sequence_ = 0;
  std::uint32_t published_news_ = 0;
  double published_s_ = 0.0;
  bool is_unit_here_ = false;
  bool is_reach_reported_ = false;  ///< whether the unit was told that other hosts can reach the link
  RepeatWatch broken_frames_;
  RepeatWatch refusals_;
  std::string refusal_;  // the last
  PlcReach reach_;

  // Last, so that their threads end before what they use.
  std::unique_ptr<OrderDesk> desk_;
  std::unique_ptr<ModbusServer> server_;
};

}  // namespace lamina
