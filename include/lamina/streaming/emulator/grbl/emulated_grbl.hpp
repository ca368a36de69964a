// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A fault of an emulated grbl or its link.
enum class GrblFaultKind : std::uint8_t {
  LostOk,       ///< the line is run, its answer is never sent
  DelayedOk,    ///< the answer, and all that follows, comes later
  LostByte,     ///< one byte of the line, its end included, is not received
  ChangedByte,  ///< one byte of the line, its end included, is received with one bit changed
  Error,        ///< the line is refused, though it is right
  Alarm,        ///< the machine locks itself instead of running the line
  Reset,        ///< the firmware starts anew and forgets everything
  Silence,      ///< the firmware neither reads nor writes for a while
  Disconnect,   ///< the link goes away with the line on it, and is back at once
};

/// One fault: at given lines, counted as they arrive, or at any line with a probability. Lines that begin
/// with '$' or "M115" are not counted.
struct GrblFault {
  GrblFaultKind kind = GrblFaultKind::LostOk;
  double rate = 0.0;                 ///< 0 to 1
  std::vector<std::uint64_t> lines;  ///< from 1
};

/// Properties of the machine and sizes of the firmware's buffers.
struct EmulatedGrblSettings {
  int blocks = 15;          ///< of the motion queue
  int receive_bytes = 128;  ///< of the receive buffer; more are lost
  double rapid_mm_min = 5000.0;
  double hold_s = 0.05;     ///< until the axes are at rest
  double delay_s = 1.0;     ///< of a delayed answer
  double silence_s = 5.0;   ///< of a silence
  bool is_locked = false;   ///< at the start
  bool obeys_holds = true;  ///< whether a feed hold has an effect
  std::uint64_t seed = 1;   ///< of faults
  std::string greeting = "Grbl 1.1h ['$' for help]";
  std::string version = "[VER:1.1h.20190830:]";
  std::string options = "[OPT:V,15,128]";  ///< need not agree with `blocks` and `receive_bytes`
};

/// grbl 1.1 without a machine: it takes bytes, gives answers, and each motion takes the time of its length at
/// its feed. It has no input, output or clock of its own; times are seconds since any start and never go
/// back.
///
/// Supported: G0 to G4, G20, G21, G90 to G92, M0, M2 to M5, M8, M9, M30 and what changes nothing here; `$$`,
/// `$G`, `$I`, `$X`; '?', '!', '~', ctrl-X and the overrides, of which only that of the spindle has an
/// effect. Positions are reported at the ends of motions only.
class EmulatedGrbl {
 public:
  /// Called with every line of G-code that was accepted, as it was read.
  using Observer = std::function<void(const std::string& line)>;

  EmulatedGrbl(EmulatedGrblSettings settings, std::vector<GrblFault> faults, Observer observer);
  ~EmulatedGrbl();
  EmulatedGrbl(const EmulatedGrbl&) = delete;
  EmulatedGrbl& operator=(const EmulatedGrbl&) = delete;

  void receive(std::string_view bytes, double now);
  /// States the time; to be called at `nextDeadline` at the latest.
  void elapse(double now);
  /// Bytes to send since the last call.
  std::string takeOutput();
  double nextDeadline() const;
  /// Whether a fault has cut the link since the last call.
  bool takeDisconnect();

  /// The tool's place in the machine's coordinates at the end of the last motion [mm].
  Point3 position() const;
  double spindleSpeed() const;  ///< [rpm]; 0 is off
  bool isInMotion() const;
  std::uint64_t faults() const;     ///< that have struck
  std::uint64_t bytesLost() const;  ///< that came while the receive buffer was full

 private:
  class Board;
  std::unique_ptr<Board> board_;
};

}  // namespace lamina
