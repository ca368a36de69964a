// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {

/// Detects a reset of the firmware whose greeting was not seen: it then requests lines that it must have run
/// already. An ok alone is no proof of a line, since noise may have turned the answer to a refused line into
/// one.
class LineProof {
 public:
  /// States that the firmware requests this line, so that it has those before.
  void asked(std::uint64_t line);
  /// States that the ok of a line has arrived.
  void acknowledged();
  /// Allows for that number of oks that were counted for lines which the firmware has not run.
  void doubt(int stray_oks);
  /// Allows for a reply that noise may have made of a request to resend, whose ok then counts for a line.
  void hear(const FirmwareReply& reply);

  /// Whether the firmware requests a line that it must have run already: it was reset, or noise has changed
  /// the number.
  /// @param taken  the last line acknowledged
  bool contradicts(std::uint64_t wanted, std::uint64_t taken) const;

 private:
  std::uint64_t proven_ = 0;  ///< the highest line asked for
  int stray_oks_ = 0;
  int clean_oks_ = 0;  ///< since there was a reason to doubt
};

}  // namespace lamina
