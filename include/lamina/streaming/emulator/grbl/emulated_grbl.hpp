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
  LostOk,       ///< the line is run, but its answer is never sent
  DelayedOk,    ///< the answer to the line, and every answer after it, is sent late
  LostByte,     ///< one byte of the line, which may be its line feed, is not received
  ChangedByte,  ///< one byte of the line, which may be its line feed, is received with one bit changed
  Error,        ///< the line is refused, though it is correct
  Alarm,        ///< the machine locks itself instead of running the line
  Reset,        ///< the firmware restarts and loses its state and all that it has received
  Silence,      ///< the firmware neither reads nor writes for a while
  Disconnect,   ///< the link is cut and the line on it lost; the link is back at once
};

/// A fault and when it strikes: at given lines, or with a probability at each line. Only lines that begin
/// with 'G' are struck; all lines that do not begin with '$' are counted, in the order of their arrival.
struct GrblFault {
  GrblFaultKind kind = GrblFaultKind::LostOk;
  double rate = 0.0;                 ///< probability at each line, 0 to 1
  std::vector<std::uint64_t> lines;  ///< numbers of the lines struck, counted from 1
};

/// Properties of the machine, and sizes of the firmware's buffers.
struct EmulatedGrblSettings {
  int blocks = 15;               ///< capacity of the motion queue
  int receive_bytes = 128;       ///< capacity of the receive buffer; bytes beyond it are lost
  double rapid_mm_min = 5000.0;  ///< speed of rapid motions
  double hold_s = 0.05;          ///< time from a feed hold until the axes are at rest
  double delay_s = 1.0;          ///< time by which a delayed answer is late
  double silence_s = 5.0;        ///< duration of a silence
  bool is_locked = false;        ///< whether the machine starts in the state Alarm
  bool obeys_holds = true;       ///< whether a feed hold has an effect
  std::uint64_t seed = 1;        ///< seed of the random faults
  std::string greeting = "Grbl 1.1h ['$' for help]";
  std::string version = "[VER:1.1h.20190830:]";
  std::string options = "[OPT:V,15,128]";  ///< answer to `$I`; need not agree with the capacities above
};

/// Emulated grbl 1.1 without a machine: it receives bytes and gives answers. The duration of a motion is its
/// length over its feed, without acceleration. It does no input or output and reads no clock; times are
/// passed in, in seconds since any start, and never go back.
///
/// Supported: G0 to G4, G20, G21, G90 to G92, M0, M2 to M5, M8, M9, M30, and codes that would change nothing
/// here; `$$`, `$G`, `$I`, `$X`; '?', '!', '~', ctrl-X, and the overrides; only the spindle's override has an
/// effect. The reported position advances only when a motion has ended.
class EmulatedGrbl {
 public:
  /// Called with each line of G-code that was accepted, as it was received.
  using Observer = std::function<void(const std::string& line)>;

  EmulatedGrbl(EmulatedGrblSettings settings, std::vector<GrblFault> faults, Observer observer);
  ~EmulatedGrbl();
  EmulatedGrbl(const EmulatedGrbl&) = delete;
  EmulatedGrbl& operator=(const EmulatedGrbl&) = delete;

  /// Receives bytes from the host, in pieces of any length.
  void receive(std::string_view bytes, double now);
  /// Advances to a time; to be called at `nextDeadline` at the latest.
  void elapse(double now);
  /// Bytes that the firmware has written since the last call.
  std::string takeOutput();
  /// Time [s] at which `elapse` is due next; infinite if nothing is.
  double nextDeadline() const;
  /// Whether a fault has cut the link since the last call.
  bool takeDisconnect();

  /// Position of the tool at the end of the last motion [mm, machine coordinates].
  Point3 position() const;
  double spindleSpeed() const;  ///< [rpm]; 0 is off
  bool isInMotion() const;
  std::uint64_t faults() const;     ///< number of faults that have struck
  std::uint64_t bytesLost() const;  ///< number of bytes that arrived while the receive buffer was full

 private:
  class Board;
  std::unique_ptr<Board> board_;
};

}  // namespace lamina
