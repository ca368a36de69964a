// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/streaming/job/firmware_reply.hpp"
#include "lamina/streaming/job/live_change.hpp"
#include "lamina/streaming/job/packml.hpp"

namespace lamina {

/// Who says how often the machine stood still for want of a line.
enum class StarvationSource : std::uint8_t {
  Streamer,  ///< the streamer, which feeds it line by line
  Machine,   ///< the machine counts, and gives neither lengths nor lines
  Nobody,    ///< it is not reported by this firmware
};

/// How often the machine stood still for want of a line.
struct Starvation {
  StarvationSource source = StarvationSource::Streamer;
  std::uint64_t count = 0;
  double longest_s = 0.0;
  std::uint64_t line = 0;  ///< that came late, of the longest
};

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
  Starvation starvation;
  std::int32_t layer = -1;  ///< of the last line acknowledged; -1 before the first
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;
  std::string message;  ///< last warning or unknown-command echo of the firmware
  std::string warning;  ///< what this machine will do with the program that may not be meant, found before
                        ///< the first line; empty if nothing was
  Failure failure;      ///< why the job was aborted
};

/// Given every line the machine says, as it comes.
using ReplyListener = std::function<void(const FirmwareReply&)>;

/// A program on its way to a machine, as one kind of firmware wants it: a state machine without input, output
/// or time of its own. Bytes, times and commands go in, bytes to send come out; times are seconds since any
/// start and never go back.
class StreamJob {
 public:
  virtual ~StreamJob() = default;

  virtual void start(double now) = 0;
  /// Bytes from the machine, cut anywhere.
  virtual void receive(std::string_view bytes, double now) = 0;
  /// Time went by; to be called at `nextDeadline` at the latest.
  virtual void elapse(double now) = 0;
  /// The link is gone: the job is Aborting, and over unless the link comes back for the safe stop before
  /// `stream.safe_stop_timeout_s` are over.
  virtual void disconnect(const std::string& why, double now) = 0;
  /// The link is back: what the safe stop still lacks is sent. Without effect unless offline.
  virtual void reconnect(double now) = 0;
  /// Whether the safe stop waits for the link.
  virtual bool isOffline() const = 0;

  /// @return false if the job is not in Execute
  virtual bool pause(double now) = 0;
  /// @return false if the job is not in Holding or Held
  virtual bool resume(double now) = 0;
  /// Changes how the job runs, between two of its lines.
  /// @return why it is refused, in words: the firmware has no such change, or the job is neither in Execute
  ///   nor held; empty if it is taken
  virtual std::string change(const LiveChange& change, double /*now*/) {
    return notOf("this firmware", change.setting);
  }
  /// Safe stop. Without effect once the job is over or is being aborted.
  virtual void abort(const Failure& why, double now) = 0;

  /// Bytes to send since the last call.
  virtual std::string takeOutput() = 0;
  /// Time of the next `elapse`; infinite if nothing is waited for.
  virtual double nextDeadline() const = 0;
  virtual const StreamStatus& status() const = 0;
  /// The states entered since the last call, in order.
  virtual std::vector<PackmlState> takeStateChanges() = 0;
};

}  // namespace lamina
