// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether a region has a corner of less than 60 degrees inside. Offsets outwards cut such corners square.
bool hasSharpCorner(const Region& region);

/// A region without the tips of its sharp corners, and those tips.
struct TipCut {
  Region rest;
  Regions tips;  ///< in the order of the corners
};

/// Cuts the tips of an area off where its core, grown again by `reach_mm`, ends: square, at that distance
/// from each sharp corner of the core. The core is what the area leaves, shrunk as a whole by that distance;
/// then this gives what the difference of the area and its grown core gives, in the time of a walk along the
/// border. Nothing where a tip is not a single piece of the border between two others.
std::optional<TipCut> cutSharpTips(const Region& area, const Region& core, double reach_mm);

}  // namespace lamina
