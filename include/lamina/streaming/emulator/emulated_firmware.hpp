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

/// A line that the emulated firmware has run, without number and checksum.
struct ExecutedLine {
  std::string command;
  std::optional<std::uint64_t> number;  ///< as the host numbered it
};

/// Callbacks of an emulated machine; each may be empty.
struct EmulatedObserver {
  std::function<void(const ExecutedLine&)> line;      ///< when the line begins to be run
  std::function<void(const ExecutedMotion&)> motion;  ///< when the motion has ended, in order
};

/// Counts of an emulated machine.
struct EmulatedCounts {
  std::uint64_t lines_run = 0;
  std::uint64_t lines_refused = 0;
  std::uint64_t bytes_lost = 0;  ///< that arrived while the receive buffer was full
  std::uint64_t faults = 0;      ///< that have struck
  std::size_t starvations = 0;   ///< times the motion queue ran empty
  double machine_time_s = 0.0;
};

/// Marlin firmware without a machine: it takes bytes, gives replies and runs motions in machine time. It has
/// no input, output or clock of its own; wall times are seconds since any start and never go back.
///
/// Machine time runs `speed_up` times as fast as wall time. If it is faster, it waits for a host that is
/// still sending: a motion begins only when the queue is full, the host was quiet for 50 ms, or the host
/// waits for the end of the motions. The same program therefore gives the same motions on a busy computer
/// too.
///
/// Supported: N and checksum, G0 to G4, G20, G21, G28, G29 (prints a height map), G90 to G92, M18, M82 to
/// M84, M104, M105, M108, M109, M110, M112, M114, M115, M119 (reports the homed axes), M140, M154, M155,
/// M190, M220, M221, M400, M410; with a dryer M141 and M191; with vacuum zones M42 and M43; and those that
/// change nothing here (fans, limits). Anything else is answered by "echo:Unknown command" and ok.
class EmulatedFirmware {
 public:
  EmulatedFirmware(const EmulatedSettings& settings, std::vector<Fault> faults, EmulatedObserver observer);
  ~EmulatedFirmware();
  EmulatedFirmware(const EmulatedFirmware&) = delete;
  EmulatedFirmware& operator=(const EmulatedFirmware&) = delete;

  void receive(std::string_view bytes, double wall_s);
  /// States the time; to be called at `nextDeadline` at the latest.
  void elapse(double wall_s);
  /// Bytes to send since the last call.
  std::string takeOutput();
  double nextDeadline() const;
  /// Whether a fault has cut the link since the last call.
  bool takeDisconnect();

  /// True when every line received was run and the nozzle is at rest.
  bool isIdle() const;
  EmulatedCounts counts() const;
  /// The nozzle now [mm, bed].
  Point3 position() const;
  double nozzleTarget() const;  ///< [°C]; 0 is off
  double bedTarget() const;     ///< [°C]; 0 is off

 private:
  class Board;
  std::unique_ptr<Board> board_;
};

}  // namespace lamina
