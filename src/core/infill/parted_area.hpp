// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon.hpp"

namespace lamina {

/// An area parted by how much room it has for beads side by side.
struct PartedArea {
  Regions wide;    ///< what a bead along the border fills and leaves a pitch of thickness at least
  Regions narrow;  ///< the rest, without hairs along the border
};

/// Parts an area that the functions of `offset.hpp` returned.
PartedArea partByWidth(const Regions& area, double pitch_mm);

}  // namespace lamina
