// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/geometry/mesh.hpp"
#include "slicing/growth.hpp"

namespace lamina {

/// Refuses a curve that leaves places of the closed curve beneath it farther away than twice the height it
/// should have over them.
/// @param layer  its number, for the message
/// @param mesh   the part, whose faces around the gap are the region
/// @throws Unsliceable naming the gap and where it is
void requireNoGap(const AdaptedCurve& curve, const PlacedCurve& beneath, double height_mm, std::size_t layer,
                  const Mesh& mesh);

}  // namespace lamina
