// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Name of the process value that states which share of a path's retraction is made during the path's motions
/// (a wipe).
inline constexpr char kWipeShare[] = "wipe_share";

/// The share of a path's retraction that is made during its motions. 0 if the path states none: the whole
/// retraction is made before its first motion.
inline double wipeShare(const Path& path) {
  for (const ProcessValue& value : path.values)
    if (value.name == kWipeShare) return value.value.at(0);
  return 0.0;
}

}  // namespace lamina
