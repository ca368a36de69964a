// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {

/// Streams one program by the protocol that `stream.firmware` names; with `auto`, by the protocol of the
/// firmware that answers.
///
/// States: Idle until `start`; Starting, while the firmware is identified and the protocol is set up and
/// confirmed; Execute; Completing, when the machine has all lines and finishes its motions; Complete. `pause`
/// leads to Holding until the lines under way are acknowledged, then to Held; from Starting, as soon as the
/// first line could be sent. `abort` and every failure lead to Aborting, a safe stop that the machine has to
/// confirm, then to Aborted. A machine that has got no line of the program gets no safe stop, since it may be
/// in use by others.
///
/// Either no line is lost or run twice, or the job ends in Aborted. Each protocol ensures this by its own
/// means.
class Streamer final : public StreamJob {
 public:
  /// @param heard  may be empty
  /// @throws InvalidConfig as `requireConsistent` of the settings
  /// @throws InvalidProgram if the firmware that the settings name would misread the program
  Streamer(const StreamableProgram& program, const StreamSettings& settings, ReplyListener heard = {});
  /// @throws InvalidConfig, InvalidProgram as the constructor above
  /// @throws InvalidConfig also if the protocol cannot resume an unfinished job or revise lines, as the order
  ///   asks, or the firmware of an unfinished job is `auto`
  explicit Streamer(StreamOrder order);
  ~Streamer() override;
  Streamer(const Streamer&) = delete;
  Streamer& operator=(const Streamer&) = delete;

  void start(double now) override;
  void receive(std::string_view bytes, double now) override;
  void elapse(double now) override;
  void disconnect(const std::string& why, double now) override;
  void reconnect(double now) override;
  bool isOffline() const override;
  bool pause(double now) override;
  bool resume(double now) override;
  std::string change(const LiveChange& change, double now) override;
  bool ask(const std::string& command, double now) override;
  void abort(const Failure& why, double now) override;
  std::string takeOutput() override;
  double nextDeadline() const override;
  const StreamStatus& status() const override;
  /// Name of the protocol in `firmwareProtocols`; `auto` until the firmware is identified.
  const std::string& protocol() const { return order_.settings.firmware; }
  std::vector<PackmlState> takeStateChanges() override;

 private:
  void adopt(double now);

  StreamOrder order_;
  bool is_hold_due_ = false;  ///< whether the job is to hold as soon as the firmware is known
  std::unique_ptr<class Identification> identification_;  ///< null if the settings name the firmware
  std::unique_ptr<StreamJob> job_;                        ///< null until the firmware is known
};

}  // namespace lamina
