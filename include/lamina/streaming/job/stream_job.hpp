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

/// Who counts how often the machine stood still for want of a line.
enum class StarvationSource : std::uint8_t {
  Streamer,  ///< the streamer, which sends line by line
  Machine,   ///< the machine, without durations and lines
  Nobody,    ///< this firmware does not report it
};

/// How often the machine stood still for want of a line.
struct Starvation {
  StarvationSource source = StarvationSource::Streamer;
  std::uint64_t count = 0;
  double longest_s = 0.0;
  std::uint64_t line = 0;  ///< that came late in the longest case
};

/// The progress of a job and the last reports of the machine.
struct StreamStatus {
  PackmlState state = PackmlState::Idle;
  std::uint64_t lines_total = 0;
  std::uint64_t lines_sent = 0;          ///< each line counted once
  std::uint64_t lines_acknowledged = 0;  ///< taken by the machine; exact after each resend and at the end
  std::uint64_t resends = 0;             ///< requests to send again that were obeyed
  std::uint64_t probes = 0;              ///< times that the machine had to be asked for its last line
  std::uint64_t commands_not_done = 0;   ///< unknown to the firmware, or extrusion with a cold nozzle
  std::string first_not_done;            ///< answer of the firmware to the first of these
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

/// Called with every line of the machine as it arrives.
using ReplyListener = std::function<void(const FirmwareReply&)>;

/// The streaming of one program to a machine by one protocol: a state machine without input, output or clock
/// of its own. It takes bytes, times and commands, and gives bytes to send. Times are seconds since any start
/// and never go back.
class StreamJob {
 public:
  virtual ~StreamJob() = default;

  virtual void start(double now) = 0;
  /// Takes bytes from the machine, in pieces of any length.
  virtual void receive(std::string_view bytes, double now) = 0;
  /// States the time; to be called at `nextDeadline` at the latest.
  virtual void elapse(double now) = 0;
  /// States that the link is lost. The job is Aborting until the link is back for the safe stop, or is over
  /// after `stream.safe_stop_timeout_s`.
  virtual void disconnect(const std::string& why, double now) = 0;
  /// States that the link is back: the rest of the safe stop is sent. Without effect unless offline.
  virtual void reconnect(double now) = 0;
  /// Whether the safe stop waits for the link.
  virtual bool isOffline() const = 0;

  /// A job that is Starting holds before its first line; on a print server as soon as it prints.
  /// @return false if the job is neither Starting nor in Execute
  virtual bool pause(double now) = 0;
  /// @return false if the job is not in Holding or Held, and not Starting either
  virtual bool resume(double now) = 0;
  /// Changes a setting of the running job, between two of its lines.
  /// @return why it is refused, in words: the firmware has no such change, or the job is neither in Execute
  ///   nor held; empty if it is taken
  virtual std::string change(const LiveChange& change, double /*now*/) {
    return notOf("this firmware", change.setting);
  }
  /// Asks the machine something between two lines of the running job, without a number; a question that is
  /// not answered is given up.
  /// @param command  changes nothing, and is answered by `ok`
  /// @return false if this firmware is not asked, the job is neither in Execute nor held, or a question waits
  virtual bool ask(const std::string& /*command*/, double /*now*/) { return false; }
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
