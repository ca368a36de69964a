// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace lamina {

/// The time of day by the clock of the host [s since 1970, UTC]. It may jump; use `Clock` to measure
/// durations.
inline double utcNow() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace lamina
