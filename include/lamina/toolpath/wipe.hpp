// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Name of the process value that says which share of a retraction happens on the way along a path.
inline constexpr char kWipeShare[] = "wipe_share";

/// That share, 0 of paths without: the whole retraction comes before their first motion.
inline double wipeShare(const Path& path) {
  for (const ProcessValue& value : path.values)
    if (value.name == kWipeShare) return value.value.at(0);
  return 0.0;
}

}  // namespace lamina
