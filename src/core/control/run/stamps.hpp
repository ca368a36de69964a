// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace lamina {

/// Time from one time stamp to another [s].
inline double secondsFrom(std::int64_t begin_ns, std::int64_t end_ns) {
  return static_cast<double>(end_ns - begin_ns) / 1e9;
}

/// A duration as a difference of time stamps, rounded to whole nanoseconds.
inline std::int64_t nanoseconds(double duration_s) { return std::llround(1e9 * duration_s); }

}  // namespace lamina
