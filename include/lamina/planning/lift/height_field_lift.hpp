// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/lift/chart_lift.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/slicing/height_field/height_field_slicer.hpp"

namespace lamina {

/// Lifts layers planned in xy onto the curved layers from which they were cut. The chart of a layer exists
/// only while it is lifted.
/// @param slices  must outlive the result
/// @param settings  with `ToolAxis::Down` for machines that cannot tilt
LayerLift heightFieldLift(const HeightFieldSlices& slices, const LiftSettings& settings,
                          const TravelSettings& travel);

}  // namespace lamina
