// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {

/// What is known of the lines that the firmware has run, to find a reset whose greeting was not seen: then it
/// asks for lines that it must have run. An ok alone proves little, since noise may have made one of the
/// answer to a line that was refused.
class LineProof {
 public:
  /// The firmware asks for this line, so that it has those before.
  void asked(std::uint64_t line);
  /// The ok of a line came.
  void acknowledged();
  /// Makes allowance for oks that are taken for those of lines which the firmware has not run.
  void doubt(int stray_oks);
  /// Doubts where noise may have made the reply of a request to resend, whose ok then counts for a line.
  void hear(const FirmwareReply& reply);

  /// Whether the firmware asks for a line that it must have run: it was reset and counts anew, or noise has
  /// changed the number.
  /// @param taken  the last line acknowledged
  bool contradicts(std::uint64_t wanted, std::uint64_t taken) const;

 private:
  std::uint64_t proven_ = 0;  ///< the highest line asked for
  int stray_oks_ = 0;
  int clean_oks_ = 0;  ///< since there was a reason to doubt
};

}  // namespace lamina
