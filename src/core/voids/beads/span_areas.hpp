// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "voids/beads/scan_rows.hpp"

namespace lamina {

/// A connected area: spans that overlap those of the next row.
struct SpanArea {
  Region outline;  ///< true within half a row's spacing
  double area_mm2 = 0.0;
};

/// The connected areas of at least the least size, ordered by their lowest row and then by x.
std::vector<SpanArea> connectedAreas(const std::vector<Spans>& spans, const ScanRows& rows, double least_mm2);

}  // namespace lamina
