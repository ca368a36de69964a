// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Size of the gyroid's cubic cell [mm] at which level cuts have on average that length of curves in an area
/// [1/mm]. Single cuts have 6 % less to 17 % more.
double gyroidCell(double length_per_area);

/// Level cuts through one gyroid that stands in the part, `InfillRequest::part_from_plan`, whatever the plane
/// of the layer; at the length of curves in an area, on the mean of heights, that a zigzag's lines have.
/// Curves are exact within 0.01 mm. A solid fill is a zigzag.
std::vector<FillPath> gyroid(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
