// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

inline constexpr double kJogPatience = 5.0;  ///< [s] that the controller may need to come to rest

/// Observed state of a jog for which a job waits.
struct JogSight {
  bool is_at_rest = false;
  bool is_cancelled = false;  ///< whether the job is no longer wanted
};

/// Whether a job may begin after a jog.
/// @param waited_s  [s] since the job was asked for
/// @throws Cancelled at once if the job is no longer wanted
/// @throws DeviceError if the controller does not come to rest within `kJogPatience`
inline bool isJogOver(const JogSight& seen, double waited_s) {
  if (seen.is_cancelled) throw Cancelled("cancelled while the end of a jog was waited for");
  if (seen.is_at_rest) return true;
  if (waited_s <= kJogPatience) return false;
  throw DeviceError("the controller has not ended a jog within " + numberText(waited_s) +
                    " s; expected it at rest within " + numberText(kJogPatience) + " s");
}

}  // namespace lamina
