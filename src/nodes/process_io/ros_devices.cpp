// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_devices.hpp"

#include <ros/service.h>
#include <std_msgs/Float64.h>

#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "messages.hpp"

namespace lamina {
namespace {

constexpr std::int8_t kDigital = 1;
constexpr std::int8_t kAnalogue = 3;

bool isSwitch(ProcessQuantity quantity) {
  return quantity == ProcessQuantity::LaserOn || quantity == ProcessQuantity::WireOn ||
         quantity == ProcessQuantity::PowderOn || quantity == ProcessQuantity::GasOn;
}

std::int8_t pinOf(const OutputChannel& channel) {
  int pin = -1;
  const std::string& text = channel.write;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), pin);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || pin < 0 || pin > 127)
    throw InvalidConfig("channels." + channel.name + ": write is '" + text + "'; must be a pin in [0, 127]");
  return static_cast<std::int8_t>(pin);
}

/// A service that sets one output per call: those that have changed. A call waits for its answer, which may
/// take long; who sends values to it notices.
class SetIoDevice final : public ProcessDevice {
 public:
  SetIoDevice(const ros::NodeHandle& node, const DeviceTable& table) : node_(node), table_(table) {
    for (const OutputChannel& channel : table.channels) pinOf(channel);
  }

  std::string open() override {
    client_ = node_.serviceClient<lamina_msgs::SetIo>(table_.device.address, true);
    if (!client_.waitForExistence(ros::Duration(table_.device.timeout_s)) || !client_.isValid())
      throw Disconnected(table_.device.name + ": no service " + node_.resolveName(table_.device.address));
    sent_.assign(table_.channels.size(), std::nan(""));
    return table_.device.name + " cannot report what it does when its link is lost";
  }

  std::vector<double> exchange(const std::vector<double>& raw) override {
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] == sent_[i]) continue;
      const OutputChannel& channel = table_.channels[i];
      if (!set(channel, raw[i])) {
        setSafeValues();
        throw Disconnected(table_.device.name + ": " + node_.resolveName(table_.device.address) +
                           " does not set pin " + channel.write + " to " + numberText(raw[i]));
      }
      sent_[i] = raw[i];
    }
    if (!client_.isValid())
      throw Disconnected(table_.device.name + ": service " + node_.resolveName(table_.device.address) +
                         " is gone");
    return {};
  }

  void close() override { client_.shutdown(); }

 private:
  bool set(const OutputChannel& channel, double raw) {
    lamina_msgs::SetIo call;
    call.request.fun = isSwitch(channel.quantity) ? kDigital : kAnalogue;
    call.request.pin = pinOf(channel);
    call.request.state = static_cast<float>(raw);
    return client_.call(call) && call.response.success;
  }

  /// Where one pin cannot be set, others can: no beam stays on for the sake of a fan.
  void setSafeValues() {
    for (const OutputChannel& channel : table_.channels) set(channel, rawOf(channel, channel.safe));
  }

  ros::NodeHandle node_;
  DeviceTable table_;
  ros::ServiceClient client_;
  std::vector<double> sent_;
};

/// A topic per channel. Whoever acts upon it listens: without that the device is not there.
class TopicDevice final : public ProcessDevice {
 public:
  TopicDevice(ros::NodeHandle node, const DeviceTable& table) : table_(table) {
    for (const OutputChannel& channel : table.channels) {
      if (channel.write.empty())
        throw InvalidConfig("channels." + channel.name + ": write is empty; must be a topic");
      publishers_.push_back(node.advertise<std_msgs::Float64>(channel.write, kQueue));
    }
  }

  std::string open() override {
    requireListeners();
    return table_.device.name + " cannot report what it does when its link is lost";
  }

  std::vector<double> exchange(const std::vector<double>& raw) override {
    requireListeners();
    for (std::size_t i = 0; i < raw.size(); ++i) {
      std_msgs::Float64 message;
      message.data = raw[i];
      publishers_[i].publish(message);
    }
    return {};
  }

  void close() override {}

 private:
  static constexpr std::uint32_t kQueue = 100;

  /// Where one listener is gone, others are there: no beam stays on for the sake of a fan.
  void requireListeners() const {
    for (const ros::Publisher& publisher : publishers_) {
      if (publisher.getNumSubscribers() > 0) continue;
      publishSafeValues();
      throw Disconnected(table_.device.name + ": nobody listens to " + publisher.getTopic());
    }
  }

  void publishSafeValues() const {
    for (std::size_t i = 0; i < publishers_.size(); ++i) {
      std_msgs::Float64 message;
      message.data = rawOf(table_.channels[i], table_.channels[i].safe);
      publishers_[i].publish(message);
    }
  }

  DeviceTable table_;
  std::vector<ros::Publisher> publishers_;
};

}  // namespace

std::unique_ptr<ProcessDevice> makeRosDevice(const ros::NodeHandle& node, const DeviceTable& table) {
  switch (table.device.kind) {
    case DeviceKind::SetIo:
      return std::make_unique<SetIoDevice>(node, table);
    case DeviceKind::Topic:
      return std::make_unique<TopicDevice>(node, table);
    default:
      return makeProcessDevice(table);
  }
}

}  // namespace lamina
