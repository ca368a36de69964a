// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether a region has an interior angle of less than 60 degrees. Outward offsets cut such corners off
/// square.
bool hasSharpCorner(const Region& region);

/// A region without the tips of its sharp corners, and those tips.
struct TipCut {
  Region rest;
  Regions tips;  ///< in the order of the corners
};

/// Cuts off the tips of an area beyond its core grown by `reach_mm`: square, at that distance from each sharp
/// corner of the core. The core must be the area shrunk by that same distance. The result equals the
/// difference of the area and its grown core, but takes only the time of a walk along the border. Nothing if
/// a tip is not a single piece of the border between two others.
std::optional<TipCut> cutSharpTips(const Region& area, const Region& core, double reach_mm);

}  // namespace lamina
