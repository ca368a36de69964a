// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_io/devices/serial_text_device.hpp"

#include <boost/asio/io_context.hpp>
#include <chrono>

#include "base/decimals.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/streaming/transport/transport.hpp"

namespace lamina {
namespace {

constexpr double kRepeat = 0.25;  // s after which a line is sent again: devices may have a watchdog
constexpr std::string_view kPlace = "{value}";
constexpr std::size_t kMostWaiting = 4096;  // bytes of answers that are kept

class SerialTextDevice final : public ProcessDevice {
 public:
  explicit SerialTextDevice(const DeviceTable& table) : table_(table) {
    for (const OutputChannel& channel : table.channels)
      if (channel.write.find(kPlace) == std::string::npos)
        throw InvalidConfig("channels." + channel.name + ": write is '" + channel.write +
                            "'; must be a line with {value}");
    sent_.resize(table.channels.size());
  }

  std::string open() override {
    close();
    context_.restart();
    auto transport = makeTransport(context_, table_.device.address, table_.device.baud);
    TransportEvents events;
    events.received = [this](std::string_view bytes) {
      received_.append(bytes);
      if (received_.size() > kMostWaiting) received_.erase(0, received_.size() - kMostWaiting);
    };
    events.closed = [this](const std::string& why) { closed_ = why.empty() ? "closed" : why; };
    transport->open(std::move(events));
    transport_ = std::move(transport);
    for (Sent& each : sent_) each = {};
    if (!table_.device.answer.empty()) return {};
    return table_.device.name + " answers nothing: a device that is not there is not noticed";
  }

  std::vector<double> exchange(const std::vector<double>& raw) override {
    try {
      for (std::size_t i = 0; i < raw.size(); ++i) {
        const std::string line = lineOf(table_.channels[i], raw[i]);
        if (line == sent_[i].line && clock_.now() - sent_[i].time_s < kRepeat) continue;
        say(line);
        sent_[i] = {line, clock_.now()};
      }
    } catch (const Disconnected&) {
      saySafeValues();
      close();
      throw;
    }
    return {};
  }

  void close() override {
    if (transport_) transport_->close();
    transport_.reset();
    context_.restart();
    context_.poll();
    received_.clear();
    closed_.clear();
  }

 private:
  struct Sent {
    std::string line;
    double time_s = 0.0;
  };

  static std::string lineOf(const OutputChannel& channel, double raw) {
    std::string line = channel.write;
    line.replace(line.find(kPlace), kPlace.size(), trimmedDecimals(raw, 3));
    return line;
  }

  /// A device that does not take one line may take others: no beam stays on for the sake of a fan.
  void saySafeValues() {
    if (!transport_ || !closed_.empty()) return;
    for (const OutputChannel& channel : table_.channels)
      transport_->send(lineOf(channel, rawOf(channel, channel.safe)) + "\n");
    const double give_up_s = clock_.now() + table_.device.timeout_s;
    while (transport_->isSending() && closed_.empty() && clock_.now() < give_up_s)
      runFor(give_up_s - clock_.now());
  }

  void runFor(double longest_s) {
    context_.restart();
    context_.run_one_for(std::chrono::microseconds(static_cast<long>(1e6 * longest_s) + 1));
  }

  void say(const std::string& line) {
    if (!transport_) throw Disconnected(table_.device.name + " is not open");
    received_.clear();
    transport_->send(line + "\n");
    const std::string& answer = table_.device.answer;
    const double give_up_s = clock_.now() + table_.device.timeout_s;
    while (transport_->isSending() || (!answer.empty() && received_.find(answer) == std::string::npos)) {
      const double left_s = give_up_s - clock_.now();
      if (!closed_.empty() || left_s <= 0.0) lose(line);
      runFor(left_s);
    }
  }

  [[noreturn]] void lose(const std::string& line) const {
    const std::string why =
        closed_.empty() ? "no answer within " + numberText(table_.device.timeout_s) + " s" : closed_;
    throw Disconnected(table_.device.name + " at " + table_.device.address + " does not take '" + line +
                       "': " + why);
  }

  DeviceTable table_;
  SteadyClock clock_;
  boost::asio::io_context context_;
  std::unique_ptr<Transport> transport_;
  std::vector<Sent> sent_;
  std::string received_;
  std::string closed_;
};

}  // namespace

std::unique_ptr<ProcessDevice> makeSerialTextDevice(const DeviceTable& table) {
  return std::make_unique<SerialTextDevice>(table);
}

}  // namespace lamina
