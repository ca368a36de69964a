// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {

/// Streams one program to the firmware that is there, or to the one that `stream.firmware` names.
///
/// Life: Idle, `start`, Starting (who is there is asked; what the protocol needs is set and confirmed),
/// Execute, Completing (the machine has every line and finishes its motions), Complete. `pause` leads through
/// Holding, when the lines under way are taken, to Held; `abort` and every failure lead through Aborting, a
/// safe stop that the machine confirms, to Aborted. A machine that got no line of the program gets no safe
/// stop either: what it does is somebody else's.
///
/// No line is lost and none is run twice, or the job ends in Aborted; how that is known is the protocol's.
class Streamer final : public StreamJob {
 public:
  /// @param heard  may be empty
  /// @throws InvalidConfig as `requireConsistent` of the settings
  Streamer(const StreamableProgram& program, const StreamSettings& settings, ReplyListener heard = {});
  /// @throws InvalidConfig also if a job is to go on that the protocol cannot go on with, or whose firmware
  /// is
  ///   not stated
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
  void abort(const Failure& why, double now) override;
  std::string takeOutput() override;
  double nextDeadline() const override;
  const StreamStatus& status() const override;
  /// What is spoken, in `firmwareProtocols`; `auto` until it is known.
  const std::string& protocol() const { return order_.settings.firmware; }
  std::vector<PackmlState> takeStateChanges() override;

 private:
  void adopt(double now);

  StreamOrder order_;
  std::unique_ptr<class Identification> identification_;  ///< until the machine is known
  std::unique_ptr<StreamJob> job_;                        ///< from then on
};

}  // namespace lamina
