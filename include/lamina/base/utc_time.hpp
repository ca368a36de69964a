// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace lamina {

/// The time of day, by the host's clock [s since 1970, UTC]. May be set back; `Clock` is what times are
/// measured by.
inline double utcNow() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace lamina
