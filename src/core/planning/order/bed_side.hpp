// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/vector.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// The point of a layer's contours that is nearest to the bed; of several within 1e-6 mm the one of least x,
/// then of least y. None for an empty layer.
std::optional<Point2> bedSide(const Layer& layer, const BedPlane& bed);

}  // namespace lamina
