// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {

/// Detects a reset of the firmware whose greeting was missed: the firmware then requests lines that it must
/// have run already. An ok alone does not prove that a line was accepted, as noise may have turned the answer
/// to a refused line into an ok.
class LineProof {
 public:
  /// States that the firmware requests this line: it has accepted all lines before.
  void asked(std::uint64_t line);
  /// States that the ok of a line has arrived.
  void acknowledged();
  /// Allows for `stray_oks` oks that were counted for lines which the firmware has not run.
  void doubt(int stray_oks);
  /// Evaluates a reply. Allows for a reply that may be a request to resend garbled by noise: the ok after the
  /// request is then counted for a line.
  void hear(const FirmwareReply& reply);

  /// Whether the firmware requests a line that it must have run already: it was reset, or noise has changed
  /// the number.
  /// @param taken  the last line acknowledged
  bool contradicts(std::uint64_t wanted, std::uint64_t taken) const;

 private:
  std::uint64_t proven_ = 0;  ///< highest number of a line requested
  int stray_oks_ = 0;
  int clean_oks_ = 0;  ///< number of oks since there was a reason for doubt
};

}  // namespace lamina
