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

/// Ways to reach an emulated machine, besides its pseudo-terminal itself.
struct EmulatedPorts {
  std::string pty_link;  ///< path of a symbolic link to the pseudo-terminal; empty for none
  /// TCP port on the loopback interface; 0 for any free one, nothing for none.
  std::optional<std::uint16_t> tcp_port;
};

/// An emulated machine with Marlin firmware, reached at a pseudo-terminal and a TCP port; it runs in a thread
/// of its own. Replies go to where the last bytes came from.
class EmulatedMachine {
 public:
  /// @param observer  called from the machine's thread
  /// @throws DeviceError if no pseudo-terminal can be had or the TCP port is in use
  /// @throws FileError if the link cannot be made, or its path is taken by anything but a symbolic link
  EmulatedMachine(const EmulatedSettings& settings, std::vector<Fault> faults, const EmulatedPorts& ports,
                  EmulatedObserver observer);
  /// Ends the thread and removes the symbolic link.
  ~EmulatedMachine();
  EmulatedMachine(const EmulatedMachine&) = delete;
  EmulatedMachine& operator=(const EmulatedMachine&) = delete;

  /// Path of the symbolic link if there is one, otherwise of the pseudo-terminal itself, which changes after
  /// a disconnect.
  std::string pty() const;
  std::uint16_t tcpPort() const;  ///< 0 if there is none

  // The following may be called from any thread.
  EmulatedCounts counts() const;
  /// Whether all lines received were run and the nozzle is at rest.
  bool isIdle() const;
  Point3 position() const;      ///< of the nozzle [mm, frame of the bed]
  double nozzleTarget() const;  ///< [°C]; 0 is off
  double bedTarget() const;     ///< [°C]; 0 is off

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lamina
