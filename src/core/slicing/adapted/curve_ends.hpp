// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// An open curve without the parts at its ends that are lower than a height, cut where it is as high.
/// @return without points if all of it is lower; closed curves as they are
AdaptedCurve withoutThinEnds(const AdaptedCurve& curve, double least_mm);

}  // namespace lamina
