// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "order_desk.hpp"

#include <algorithm>
#include <utility>

#include "names.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

const ros::Duration kOrderLasts(3.0);  // a PLC that has no answer by then does not wait for it

/// Whether an order stops the unit: it does not wait behind others.
bool isUrgent(const WrittenOrder& written) {
  if (written.order.kind != PlcOrder::Kind::Command) return false;
  const auto command = unitCommand(static_cast<int>(written.order.value));
  return command && precedence(*command) <= precedence(UnitCommand::Hold);
}

/// None that moves outlives one that stops, and of one kind the last counts; alarms are acknowledged one by
/// one.
bool overtakes(const WrittenOrder& written, const WrittenOrder& old) {
  using Kind = PlcOrder::Kind;
  if (old.order.kind != written.order.kind) return false;
  if (isUrgent(written) && !isUrgent(old)) return true;
  const bool is_each_kept = isUrgent(old) || old.order.kind == Kind::Acknowledge;
  return !is_each_kept || old.order.value == written.order.value;
}

}  // namespace

OrderDesk::OrderDesk(const ros::NodeHandle& node,
                     std::function<void(const PlcOrder&, CommandResult, const std::string&)> answered)
    : node_(node), answered_(std::move(answered)), thread_([this] { run(); }) {}

OrderDesk::~OrderDesk() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void OrderDesk::give(const std::vector<WrittenOrder>& orders) {
  std::vector<WrittenOrder> overtaken;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const WrittenOrder& written : orders)
      for (WrittenOrder& old : queue(written)) overtaken.push_back(std::move(old));
  }
  for (const WrittenOrder& old : overtaken)
    answered_(old.order, CommandResult::Busy, "overtaken by a later order before the unit had it");
  changed_.notify_all();
}

/// Queues an order. @return those that it overtakes
std::vector<WrittenOrder> OrderDesk::queue(const WrittenOrder& written) {
  const auto overtaken =
      std::stable_partition(orders_.begin(), orders_.end(),
                            [&written](const WrittenOrder& old) { return !overtakes(written, old); });
  std::vector<WrittenOrder> gone(overtaken, orders_.end());
  orders_.erase(overtaken, orders_.end());
  const auto place =
      isUrgent(written) ? std::find_if_not(orders_.begin(), orders_.end(), isUrgent) : orders_.end();
  orders_.insert(place, written);
  return gone;
}

void OrderDesk::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_ending_ || !orders_.empty(); });
    if (is_ending_) return;
    const WrittenOrder written = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    const Answer answer = pass(written);
    answered_(written.order, answer.result, answer.message);
    lock.lock();
  }
}

OrderDesk::Answer OrderDesk::pass(const WrittenOrder& written) {
  const std::string source = written.inputs.badge.empty() ? "plc" : "plc: " + written.inputs.badge;
  switch (written.order.kind) {
    case PlcOrder::Kind::Command:
      return command(written, source);
    case PlcOrder::Kind::Mode: {
      lamina_msgs::SetUnitMode call;
      call.request.mode = static_cast<std::uint8_t>(std::min<std::uint32_t>(255, written.order.value));
      call.request.source = source;
      if (!callService(node_.resolveName(names::kSetUnitMode), call)) return {};
      return {static_cast<CommandResult>(call.response.result), call.response.message};
    }
    case PlcOrder::Kind::Job: {
      lamina_msgs::ChangeQueue call;
      call.request.change = lamina_msgs::ChangeQueue::Request::MOVE_TO_FRONT;
      call.request.job = written.order.value;
      call.request.source = source;
      if (!callService(node_.resolveName(names::kChangeQueue), call)) return {};
      const bool is_moved = call.response.status.code == lamina_msgs::Status::OK;
      return {is_moved ? CommandResult::Accepted : CommandResult::NoSuchJob, call.response.status.message};
    }
    case PlcOrder::Kind::Acknowledge: {
      lamina_msgs::AcknowledgeAlarm call;
      call.request.id = static_cast<std::uint16_t>(written.order.value);
      call.request.source = source;
      if (!callService(node_.resolveName(names::kAcknowledgeAlarm), call)) return {};
      return {static_cast<CommandResult>(call.response.result), call.response.message};
    }
  }
  return {};
}

/// A call that fails is not given once more: the unit may have followed it.
OrderDesk::Answer OrderDesk::command(const WrittenOrder& written, const std::string& source) {
  // The connection is kept, so that no order waits for one; it ends with the unit's process.
  if (!command_.isValid())
    command_ = node_.serviceClient<lamina_msgs::PackmlCommand>(names::kPackmlCommand, true);
  lamina_msgs::PackmlCommand call;
  call.request.command = static_cast<std::uint8_t>(written.order.value);
  call.request.source = source;
  call.request.expected_sequence = -1;
  if (!isUrgent(written)) call.request.expires = written.inputs.header.stamp + kOrderLasts;
  call.request.plc.push_back(written.inputs);
  if (!command_.call(call)) {
    command_ = {};
    return {};
  }
  return {static_cast<CommandResult>(call.response.result), call.response.message};
}

}  // namespace lamina
