// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Name of the process value of a path that states the share of its retraction that is made during its
/// motions (a wipe).
inline constexpr char kWipeShare[] = "wipe_share";

/// That share of a path. 0 if the path does not state it: the whole retraction is made before its first
/// motion.
inline double wipeShare(const Path& path) {
  for (const ProcessValue& value : path.values)
    if (value.name == kWipeShare) return value.value.at(0);
  return 0.0;
}

}  // namespace lamina
