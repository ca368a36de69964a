// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/guard/machine_pulse.hpp"

namespace lamina {

/// Sends the pulses of this process to a socket of this host, in a thread of its own, twenty times a second.
/// Nobody needs to listen: it is tried again and again. The system itself closes the connection when the
/// process dies, however it dies.
class PulseSender {
 public:
  /// @param socket  path of the listener's; empty for no pulses
  /// @param pulse   called from the sender's thread
  /// @throws InvalidInput if the path is longer than a socket's may be
  PulseSender(const std::string& socket, std::function<MachinePulse()> pulse);
  ~PulseSender();
  PulseSender(const PulseSender&) = delete;
  PulseSender& operator=(const PulseSender&) = delete;

  /// Whether somebody listens; true where no pulses are sent.
  bool isHeard() const;
  /// Sends one now: what it says has changed.
  void send();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a listener has heard of one process.
struct HeardPulse {
  int process = 0;                    ///< by the system's own word
  std::optional<MachinePulse> pulse;  ///< nothing: its connection has ended, as it does when the process dies
};

/// Hears pulses at a socket that only processes of the same user, and of root, reach. Its folder is made if
/// it is not there.
class PulseListener {
 public:
  /// @throws InvalidInput as `PulseSender`
  /// @throws DeviceError if another process listens there, or the socket cannot be made
  explicit PulseListener(std::string socket);
  ~PulseListener();
  PulseListener(const PulseListener&) = delete;
  PulseListener& operator=(const PulseListener&) = delete;

  /// Waits until something has come, and gives all that has, process by process; nothing after the time-out
  /// or `wake`. What is no pulse ends the connection.
  std::vector<HeardPulse> wait(double timeout_s);
  /// Ends the wait under way or the next one; from any thread.
  void wake();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lamina
