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

/// Sends the pulses of this process to a Unix socket of this host, in a thread of its own, twenty times a
/// second. As long as nobody listens, it tries to connect again and again. However the process ends, the
/// system closes the connection.
class PulseSender {
 public:
  /// @param socket  path of the listener's socket; empty for sending nothing
  /// @param pulse   returns the present pulse; called from the sender's thread
  /// @throws InvalidInput if the path is longer than that of a Unix socket may be
  PulseSender(const std::string& socket, std::function<MachinePulse()> pulse);
  ~PulseSender();
  PulseSender(const PulseSender&) = delete;
  PulseSender& operator=(const PulseSender&) = delete;

  /// Whether a listener is connected; true if nothing is to be sent.
  bool isHeard() const;
  /// Sends a pulse now; for a pulse that has changed.
  void send();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// A pulse that a listener has received from a process, or the end of that process's connection.
struct HeardPulse {
  int process = 0;                    ///< process number (PID), as the system gives it
  std::optional<MachinePulse> pulse;  ///< nothing if the connection has ended, as when the process dies
};

/// Receives pulses at a Unix socket that only processes of the same user, and of root, can reach. Makes the
/// folder of the socket if it is missing.
class PulseListener {
 public:
  /// @param socket  path of the socket
  /// @throws InvalidInput if the path is longer than that of a Unix socket may be
  /// @throws DeviceError if another process listens there, or the socket cannot be made
  explicit PulseListener(std::string socket);
  ~PulseListener();
  PulseListener(const PulseListener&) = delete;
  PulseListener& operator=(const PulseListener&) = delete;

  /// Waits until a pulse or the end of a connection arrives, and returns all that have arrived, process by
  /// process; empty after the time-out or `wake`. A connection that sends anything but pulses is closed.
  std::vector<HeardPulse> wait(double timeout_s);
  /// Ends the present call of `wait`, or the next one if there is none; may be called from any thread.
  void wake();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lamina
