// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/emulator/emulated_firmware.hpp"

namespace lamina {

/// Ports of an emulated machine besides its pseudo-terminal.
struct EmulatedPorts {
  std::string pty_link;  ///< stable path to the pseudo-terminal, a symbolic link; empty for none
  std::optional<std::uint16_t> tcp_port;  ///< on the loopback interface; 0 for any free one
};

/// An emulated machine with Marlin firmware at a pseudo-terminal and a TCP port, in a thread of its own.
/// Replies go to the port that sent last.
class EmulatedMachine {
 public:
  /// @param observer  called from the machine's thread
  /// @throws DeviceError if there is no pseudo-terminal or the TCP port is taken
  /// @throws FileError if the link cannot be made, or its path holds something that is no symbolic link
  EmulatedMachine(const EmulatedSettings& settings, std::vector<Fault> faults, const EmulatedPorts& ports,
                  EmulatedObserver observer);
  /// Removes the link.
  ~EmulatedMachine();
  EmulatedMachine(const EmulatedMachine&) = delete;
  EmulatedMachine& operator=(const EmulatedMachine&) = delete;

  /// The link if there is one, otherwise the pseudo-terminal itself, which a disconnect replaces by another.
  std::string pty() const;
  std::uint16_t tcpPort() const;  ///< 0 if there is none

  /// Its counts, and whether it is done with all that it received; from any thread.
  EmulatedCounts counts() const;
  bool isIdle() const;
  Point3 position() const;
  double nozzleTarget() const;  ///< [°C]; 0 is off
  double bedTarget() const;     ///< [°C]; 0 is off

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lamina
