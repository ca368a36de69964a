// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// The exact medial axis of a convex region with few corners, from moving its edges inwards together: the
/// axis is the trace of their ends until each edge has shrunk to a point. Nothing for other regions. It is
/// faster than the Voronoi diagram for small rests, and a part has thousands of these.
std::optional<MedialAxis> convexAxis(const Region& region);

}  // namespace lamina
