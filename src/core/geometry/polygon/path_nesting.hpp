// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <polyclipping/clipper.hpp>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The regions of Clipper's flat result, in the order and with the holes of `fromTree`. Clipper's own tree
/// costs the square of the number of outlines where many of them touch.
/// @param paths  as `Execute` reports them, outer outlines counter-clockwise
/// @return nothing if it is not plain which outlines lie within which
std::optional<Regions> nestPaths(const ClipperLib::Paths& paths);

/// The regions that Clipper finds for what has been added to it.
Regions executed(ClipperLib::Clipper& clipper, ClipperLib::ClipType operation, ClipperLib::PolyFillType rule);

}  // namespace lamina
