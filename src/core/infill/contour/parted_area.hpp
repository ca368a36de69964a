// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// An area parted by how much room it has for beads side by side.
struct PartedArea {
  Regions wide;    ///< what a bead along the border fills and leaves a pitch of thickness at least
  Regions narrow;  ///< the rest, without hairs along the border
};

/// Parts an area that the functions of `offset.hpp` returned.
PartedArea partByWidth(const Regions& area, double pitch_mm);

/// How much narrower than an area its core is on each side, in pitches: where there is core, it is wide.
constexpr double kCoreDepth = 1.5;

/// Parts an area that shrinks as a whole to `core`, `kCoreDepth` pitches from its border: nothing of it is
/// narrow then but the tips of sharp corners. Nothing where they are not that simple to cut.
std::optional<PartedArea> partByTips(const Region& area, const Region& core, double pitch_mm);

}  // namespace lamina
