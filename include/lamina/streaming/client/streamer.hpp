// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/streaming/client/packml.hpp"
#include "lamina/streaming/client/stream_settings.hpp"
#include "lamina/streaming/client/streamable_program.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {

/// How far a job is and what the machine last reported.
struct StreamStatus {
  PackmlState state = PackmlState::Idle;
  std::uint64_t lines_total = 0;
  std::uint64_t lines_sent = 0;          ///< different lines, however often each
  std::uint64_t lines_acknowledged = 0;  ///< taken by the machine; exact after each resend and at the end
  std::uint64_t resends = 0;             ///< requests to send again that were followed
  std::uint64_t probes = 0;              ///< times the machine had to be asked which line it has
  std::uint64_t commands_not_done = 0;   ///< unknown to the firmware, or extrusion with a cold nozzle
  std::string first_not_done;            ///< what the firmware said of the first of these
  std::string firmware_name;             ///< as the machine gave it; empty before, or if it gave none
  std::int32_t layer = -1;               ///< of the last line acknowledged; -1 before the first
  std::optional<MarlinTemperatures> temperatures;
  std::optional<MarlinPosition> position;
  std::string message;  ///< last warning or unknown-command echo of the firmware
  Failure failure;      ///< why the job was aborted
};

/// Given every line the machine says, as it comes.
using ReplyListener = std::function<void(const MarlinReply&)>;

/// Streams one program to firmware (`stream.firmware`): a state machine without input, output or time of its
/// own. Bytes, times and commands go in, bytes to send come out; times are seconds since any start and never
/// go back.
///
/// Life: Idle, `start`, Starting (who is there is asked; line numbers are set and confirmed), Execute,
/// Completing (the machine has every line and finishes its motions), Complete. `pause` leads through Holding,
/// when the lines under way are taken, to Held; `abort` and every failure lead through Aborting, a safe stop
/// that the machine confirms, to Aborted. A machine that got no line of the program gets no safe stop either:
/// what it does is somebody else's.
///
/// No line is lost and none is run twice, or the job ends in Aborted: every line carries its number, the
/// firmware takes them in order only, before Complete it has reported that it has the last one, and one that
/// asks for lines which it had taken was reset.
class Streamer {
 public:
  /// @param heard  may be empty
  /// @throws InvalidConfig as `validate` of the settings
  Streamer(const StreamableProgram& program, const StreamSettings& settings, ReplyListener heard = {});
  ~Streamer();
  Streamer(const Streamer&) = delete;
  Streamer& operator=(const Streamer&) = delete;

  void start(double now);
  /// Bytes from the machine, cut anywhere.
  void receive(std::string_view bytes, double now);
  /// Time went by; to be called at `nextDeadline` at the latest.
  void elapse(double now);
  /// The link is gone: the job is Aborting, and over unless the link comes back for the safe stop before
  /// `stream.safe_stop_timeout_s` are over.
  void disconnect(const std::string& why, double now);
  /// The link is back: the lines that the machine still lacks are sent. Without effect unless offline.
  void reconnect(double now);
  /// Whether the safe stop waits for the link.
  bool isOffline() const;

  /// @return false if the job is not in Execute
  bool pause(double now);
  /// @return false if the job is not in Holding or Held
  bool resume(double now);
  /// Safe stop. Without effect once the job is over or is being aborted.
  void abort(const Failure& why, double now);

  /// Bytes to send since the last call.
  std::string takeOutput();
  /// Time of the next `elapse`; infinite if nothing is waited for.
  double nextDeadline() const;
  const StreamStatus& status() const;
  /// The states entered since the last call, in order.
  std::vector<PackmlState> takeStateChanges();

 private:
  class Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace lamina
