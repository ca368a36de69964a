// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// An open curve without those parts at its ends where the bead is lower than a height; it is cut where the
/// bead has exactly that height. A closed curve is returned unchanged.
/// @return without points if all of the curve is lower
AdaptedCurve withoutThinEnds(const AdaptedCurve& curve, double least_mm);

}  // namespace lamina
