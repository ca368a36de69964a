// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "lamina/modbus/plc_link.hpp"
#include "messages.hpp"

namespace lamina {

/// A request of the PLC, with the contents of its registers at that time.
struct WrittenOrder {
  PlcOrder order;
  lamina_msgs::PlcInputs inputs;
};

/// Passes the PLC's orders on to the unit, one after the other, in a thread of its own: answers to the PLC
/// never wait for the unit. Orders to stop overtake waiting orders; waiting commands to move are then
/// answered Busy and dropped.
class OrderDesk {
 public:
  /// @param answered  receives the outcome of an order; called from the desk's thread
  OrderDesk(const ros::NodeHandle& node,
            std::function<void(const PlcOrder&, CommandResult, const std::string&)> answered);
  /// Waits for the order under way; later orders are not sent.
  ~OrderDesk();
  OrderDesk(const OrderDesk&) = delete;
  OrderDesk& operator=(const OrderDesk&) = delete;

  void give(const std::vector<WrittenOrder>& orders);

 private:
  struct Answer {
    CommandResult result = CommandResult::Busy;
    std::string message = "the unit does not answer";
  };
  void run();
  std::vector<WrittenOrder> queue(const WrittenOrder& written);
  Answer pass(const WrittenOrder& written);
  Answer command(const WrittenOrder& written, const std::string& source);

  ros::NodeHandle node_;
  std::function<void(const PlcOrder&, CommandResult, const std::string&)> answered_;
  ros::ServiceClient command_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<WrittenOrder> orders_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
