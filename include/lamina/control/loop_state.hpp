// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// State of the loop.
enum class LoopState : std::uint8_t {
  Off,
  Identifying,  ///< learns, but corrects nothing
  Active,
  Coasting,  ///< no usable measurement: corrects by the gain learnt, not by the error
  Open,      ///< the loop has given up: it corrects nothing
  Blocked    ///< the loop may not start: it is not calibrated, or its settings are not stable
};

/// Name of a state: `off`, `identifying`, `active`, `coasting`, `open`, `blocked`.
const char* toString(LoopState state);

/// Whether the loop changes what is deposited.
bool isCorrecting(LoopState state);

}  // namespace lamina
