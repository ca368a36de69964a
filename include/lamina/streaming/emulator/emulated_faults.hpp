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
  LostOk,          ///< the line is run, its ok is never sent
  DelayedOk,       ///< the ok, and all that follows, comes later
  LostLine,        ///< the line is not received at all
  CorruptedLine,   ///< the line is received with one character changed
  SpuriousResend,  ///< a resend of the next line is requested after the ok of a good one
  Silence,         ///< the firmware neither reads nor writes for a while
  Disconnect,      ///< the link goes away with the line on it, and comes back later
  Reset,           ///< the firmware starts anew and forgets everything
};

/// The kind as written on the command line: "lost_ok".
const char* toString(FaultKind kind);
/// Every kind there is.
const std::vector<FaultKind>& allFaultKinds();

/// When a fault strikes: at the first arrival of given lines, or at any numbered line with a probability.
struct Fault {
  FaultKind kind = FaultKind::LostOk;
  double rate = 0.0;                 ///< 0 to 1
  std::vector<std::uint64_t> lines;  ///< numbers; the first line of a program is 1
};

/// Reads "lost_ok=0.01" (a rate: with a decimal point, up to 1.0) or "corrupted_line=12,40" (line numbers).
/// @throws InvalidConfig naming what is wrong
Fault faultFromText(const std::string& text);

/// Decides which lines faults strike. The same seed and lines give the same faults.
class FaultInjector {
 public:
  FaultInjector(std::vector<Fault> faults, std::uint64_t seed);

  /// Whether a fault of that kind strikes the line that has arrived.
  bool strikes(FaultKind kind, std::uint64_t line);
  /// The line with one character of it changed to another printable one.
  std::string corrupted(std::string line);

 private:
  std::vector<Fault> faults_;
  Random random_;
};

}  // namespace lamina
