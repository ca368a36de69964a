// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lamina/streaming/job/firmware_protocol.hpp"
#include "streaming/job/answer_timer.hpp"
#include "streaming/job/job_record.hpp"
#include "streaming/job/reply_lines.hpp"

namespace lamina {

/// The firmware that answers at a port.
struct FoundFirmware {
  std::string protocol;        ///< name in `firmwareProtocols`
  std::string firmware_name;   ///< as the firmware states it; empty if it states none
  bool hears_at_once = false;  ///< whether it states that it hears `M108` while it waits
};

/// The protocols that firmware with this name speaks. Firmware with a manufacturer's name, or without a name,
/// speaks Marlin's protocol, unless the name belongs to another one.
std::vector<std::string> protocolsSpokenBy(const std::string& firmware_name);

/// Identifies the firmware at a port before anything else is sent. It sends `M115`: firmware answers it by
/// its name, and the grbl family refuses it in a characteristic way. Nothing is changed in the machine.
class Identification {
 public:
  explicit Identification(const StreamOrder& order);

  void start(double now);
  void receive(std::string_view bytes, double now);
  void elapse(double now);
  void abort(const Failure& why);
  double nextDeadline() const;

  const std::optional<FoundFirmware>& found() const { return found_; }
  /// Number of oks still to come: questions sent, except for the one that was answered.
  int answersDue() const { return questions_ - 1; }
  /// Bytes received after the answer.
  std::string takeUnread() { return replies_.takeRest(); }
  std::string takeOutput() { return std::exchange(output_, {}); }
  const StreamStatus& status() const { return record_.status; }
  std::vector<PackmlState> takeStateChanges() { return record_.takeStateChanges(); }

 private:
  void ask(double now);
  void onReply(const FirmwareReply& reply, double now);
  void choose();
  bool isOver() const { return found_ || record_.status.state != PackmlState::Starting; }

  StreamSettings settings_;
  ReplyListener heard_;
  JobRecord record_;
  AnswerTimer timer_;
  std::optional<FoundFirmware> found_;
  std::string firmware_name_;
  bool hears_at_once_ = false;
  ReplyLines replies_;
  std::string output_;
  int questions_ = 0;
};

}  // namespace lamina
