// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/missed_map.hpp"

#include "base/decimals.hpp"

namespace lamina {

std::string reasonOf(const MissedMap& missed) {
  return "layer " + std::to_string(missed.layer) + " is deposited " +
         (missed.is_coasting ? "by its coasting map" : "as planned") + ", not by its map: " +
         (missed.reason.empty() ? "none came within " + significantText(missed.waited_s, 3) + " s"
                                : missed.reason);
}

}  // namespace lamina
