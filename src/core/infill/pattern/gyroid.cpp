// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/gyroid.hpp"

#include "infill/pattern/gyroid_curves.hpp"
#include "infill/pattern/level_gyroid.hpp"
#include "infill/pattern/pattern_fill.hpp"
#include "infill/rectilinear/zigzag.hpp"

namespace lamina {
namespace {

/// Length of the curves in a square of one cell, mean over all heights of cut: by quadrature.
constexpr double kLengthInCell = 2.4586;
constexpr double kChordError = 1.0 / 16.0;  // of the pitch
constexpr double kStepsInCell = 16.0;

}  // namespace

double gyroidCell(double length_per_area) { return kLengthInCell / length_per_area; }

std::vector<FillPath> gyroid(const Regions& regions, const InfillRequest& request) {
  if (isSolid(request)) return zigzag(regions, request);
  return filledByPattern(regions, request, request.spacing_mm, [&](const Box2& box) {
    const double cell = gyroidCell(1.0 / request.spacing_mm);
    const GyroidSection section(request.part_from_plan, cell, patternAngle(request));
    const double chord_error_mm = kChordError * request.pitch_mm;
    if (section.isLevel()) return levelGyroidCurves(section, box, chord_error_mm);
    return gyroidCurves(section, box, cell / kStepsInCell, chord_error_mm);
  });
}

}  // namespace lamina
