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

#include "lamina/streaming/emulator/emulated_faults.hpp"
#include "lamina/streaming/emulator/emulated_motion.hpp"
#include "lamina/streaming/emulator/emulated_settings.hpp"

namespace lamina {

/// A line that the emulated firmware has run.
struct ExecutedLine {
  std::string command;                  ///< the line without number and checksum
  std::optional<std::uint64_t> number;  ///< number that the host gave it; nothing if it gave none
};

/// Callbacks of an emulated machine; each may be empty.
struct EmulatedObserver {
  std::function<void(const ExecutedLine&)> line;      ///< called when the firmware begins to run a line
  std::function<void(const ExecutedMotion&)> motion;  ///< called when a motion has ended, in order
};

/// Counts of an emulated machine.
struct EmulatedCounts {
  std::uint64_t lines_run = 0;
  std::uint64_t lines_refused = 0;
  std::uint64_t bytes_lost = 0;  ///< bytes that arrived while the receive buffer was full
  std::uint64_t faults = 0;      ///< faults that have struck
  std::size_t starvations = 0;   ///< times that the motion queue ran empty
  double machine_time_s = 0.0;
};

/// Emulated Marlin firmware without a machine: it receives bytes, gives replies and runs motions in machine
/// time. It does no input or output and reads no clock; wall times are passed in, in seconds since any start,
/// and never go back.
///
/// Machine time runs `speed_up` times as fast as wall time. If that is faster than wall time, the machine
/// waits for a host that is still sending: a motion begins only when the queue is full, the host has sent
/// nothing for 50 ms, or the host waits for the end of the motions. So a program gives the same motions on a
/// busy computer as on an idle one.
///
/// Supported: N and checksum, G0 to G4, G20, G21, G28, G29 (prints a height map), G90 to G92, M18, M82 to
/// M84, M104, M105, M108, M109, M110, M112, M114, M115, M119 (reports the homed axes), M140, M154, M155,
/// M190, M220, M221, M400, M410; with a dryer M141 and M191; with vacuum zones M42 and M43. Commands for
/// fans and limits are accepted without effect. Any other is answered by "echo:Unknown command" and ok.
class EmulatedFirmware {
 public:
  EmulatedFirmware(const EmulatedSettings& settings, std::vector<Fault> faults, EmulatedObserver observer);
  ~EmulatedFirmware();
  EmulatedFirmware(const EmulatedFirmware&) = delete;
  EmulatedFirmware& operator=(const EmulatedFirmware&) = delete;

  /// Receives bytes from the host, in pieces of any length.
  void receive(std::string_view bytes, double wall_s);
  /// Advances to a wall time; to be called at `nextDeadline` at the latest.
  void elapse(double wall_s);
  /// Bytes that the firmware has written since the last call.
  std::string takeOutput();
  /// Wall time [s] at which `elapse` is due next; infinite if nothing is.
  double nextDeadline() const;
  /// Whether a fault has cut the link since the last call.
  bool takeDisconnect();

  /// Whether all lines received were run and the nozzle is at rest.
  bool isIdle() const;
  EmulatedCounts counts() const;
  /// Present position of the nozzle [mm, frame of the bed].
  Point3 position() const;
  double nozzleTarget() const;  ///< [°C]; 0 is off
  double bedTarget() const;     ///< [°C]; 0 is off

 private:
  class Board;
  std::unique_ptr<Board> board_;
};

}  // namespace lamina
