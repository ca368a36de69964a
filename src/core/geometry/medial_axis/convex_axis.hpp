// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// The medial axis of a convex region of few corners, exact: its edges move inwards together, and the axis is
/// what their ends leave until each edge has shrunk to a point. Nothing for other regions. Saves small rests,
/// of which there are thousands in a part, the Voronoi diagram.
std::optional<MedialAxis> convexAxis(const Region& region);

}  // namespace lamina
