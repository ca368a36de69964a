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

/// Source of the count of starvations: stops of the machine because the next line had not arrived.
enum class StarvationSource : std::uint8_t {
  Streamer,  ///< counted by the streamer, which sends line by line
  Machine,   ///< counted by the machine, without durations and lines
  Nobody,    ///< not counted
};

/// Count of the stops of the machine because the next line had not arrived.
struct Starvation {
  StarvationSource source = StarvationSource::Streamer;
  std::uint64_t count = 0;
  double longest_s = 0.0;
  std::uint64_t line = 0;  ///< number of the line that was late in the longest case
};

/// The progress of a job and the last reports of the machine.
struct StreamStatus {
  PackmlState state = PackmlState::Idle;
  std::uint64_t lines_total = 0;
  std::uint64_t lines_sent = 0;          ///< each line counted once
  std::uint64_t lines_acknowledged = 0;  ///< accepted by the machine; exact after each resend and at the end
  std::uint64_t resends = 0;             ///< requests to send lines again that were obeyed
  std::uint64_t probes = 0;              ///< times that the machine had to be asked for its last line
  std::uint64_t commands_not_done = 0;   ///< commands not run: unknown, or extrusion by a cold nozzle
  std::string first_not_done;            ///< answer of the firmware to the first command that was not run
  std::string firmware_name;             ///< name that the machine has given; empty as long as it gave none
  Starvation starvation;
  std::int32_t layer = -1;  ///< of the last line acknowledged; -1 before the first
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;
  std::string message;  ///< last warning of the firmware, or its last echo of an unknown command
  /// Warning given before the first line: how this machine may deviate from the intended program; empty if
  /// there is none.
  std::string warning;
  std::string wait;  ///< person for whom the machine waits, and what ends the wait; empty if there is none
  Failure failure;   ///< reason why the job was aborted
};

/// Called with each line that the machine sends, on arrival.
using ReplyListener = std::function<void(const FirmwareReply&)>;

/// Interface of a job: the streaming of one program to a machine by one protocol. It is a state machine that
/// does no input or output and reads no clock: received bytes, times and commands are passed in, and bytes to
/// send are taken out. Times are seconds since any start and never go back.
class StreamJob {
 public:
  virtual ~StreamJob() = default;

  virtual void start(double now) = 0;
  /// Accepts bytes from the machine, in pieces of any length.
  virtual void receive(std::string_view bytes, double now) = 0;
  /// Advances to a time; to be called at `nextDeadline` at the latest.
  virtual void elapse(double now) = 0;
  /// States that the link is lost. The job goes to Aborting, where it waits for the link in order to send the
  /// safe stop; if the link is not back after `stream.safe_stop_timeout_s`, the job is over.
  virtual void disconnect(const std::string& why, double now) = 0;
  /// States that the link is back: the rest of the safe stop is sent. Without effect unless offline.
  virtual void reconnect(double now) = 0;
  /// Whether the link is lost and the safe stop waits for it.
  virtual bool isOffline() const = 0;

  /// Holds the job. A job in Starting holds before its first line; on a print server as soon as it prints.
  /// @return false, without effect, unless the job is in Starting or Execute
  virtual bool pause(double now) = 0;
  /// Continues the job; in Starting it cancels a hold to come.
  /// @return false, without effect, unless the job is in Starting, Holding or Held; also if the machine
  ///   cannot continue, for example because its door is open
  virtual bool resume(double now) = 0;
  /// Changes a setting of the running job, between two of its lines.
  /// @return empty if the change is accepted; else the reason in words: the firmware has no such setting, or
  ///   the job is neither in Execute nor held
  virtual std::string change(const LiveChange& change, double /*now*/) {
    return notOf("this firmware", change.setting);
  }
  /// Sends the machine a question between two lines of the running job, without a line number. The job
  /// continues even if no answer comes.
  /// @param command  command that changes nothing and is answered by `ok`
  /// @return false if this protocol has no questions, the job is neither in Execute nor held, or the previous
  ///   question is not answered yet
  virtual bool ask(const std::string& /*command*/, double /*now*/) { return false; }
  /// Begins a safe stop, after which the job is Aborted. Without effect once the job is over or is aborting.
  virtual void abort(const Failure& why, double now) = 0;

  /// Bytes to send to the machine that have accrued since the last call.
  virtual std::string takeOutput() = 0;
  /// Time at which `elapse` is due next; infinite if nothing is.
  virtual double nextDeadline() const = 0;
  virtual const StreamStatus& status() const = 0;
  /// The states entered since the last call, in order.
  virtual std::vector<PackmlState> takeStateChanges() = 0;
};

}  // namespace lamina
