// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/random.hpp"

namespace lamina {

/// A fault of an emulated machine or its link.
enum class FaultKind : std::uint8_t {
  LostOk,          ///< the line is run, but its ok is never sent
  DelayedOk,       ///< the ok of the line, and every reply after it, is sent late
  LostLine,        ///< the line is not received at all
  CorruptedLine,   ///< the line is received with one character changed
  SpuriousResend,  ///< a resend of the next line is requested after the ok of an undamaged line
  Silence,         ///< the firmware neither reads nor writes for a while
  Disconnect,      ///< the link is cut and the line on it lost; the link comes back later
  Reset,           ///< the firmware restarts, and the line and all its state are lost
};

/// The kind as it is written on the command line, such as "lost_ok".
const char* toString(FaultKind kind);
/// All kinds of fault.
const std::vector<FaultKind>& allFaultKinds();

/// A fault and when it strikes: at the first arrival of given lines, or with a probability at each arrival of
/// a numbered line.
struct Fault {
  FaultKind kind = FaultKind::LostOk;
  double rate = 0.0;                 ///< probability at each arrival of a numbered line, 0 to 1
  std::vector<std::uint64_t> lines;  ///< numbers of the lines struck; the first line of a program is 1
};

/// Parses a fault: "lost_ok=0.01" with a rate, which has a decimal point and is at most 1.0, or
/// "corrupted_line=12,40" with line numbers.
/// @throws InvalidConfig if the kind is unknown, or rate or numbers cannot be read
Fault faultFromText(const std::string& text);

/// Decides which lines are struck by faults. The same seed and the same lines give the same faults.
class FaultInjector {
 public:
  FaultInjector(std::vector<Fault> faults, std::uint64_t seed);

  /// Whether a fault of this kind strikes the line that has just arrived; to be called once per arrival.
  bool strikes(FaultKind kind, std::uint64_t line);
  /// The line with one of its characters, chosen at random, changed to another printable one.
  std::string corrupted(std::string line);

 private:
  std::vector<Fault> faults_;
  Random random_;
};

}  // namespace lamina
