// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/drops/drops_contour.hpp"

#include <limits>

#include "infill/drops/drop_fill.hpp"

namespace lamina {

std::vector<FillPath> dropsContour(const Regions& regions, const InfillRequest& request) {
  DropFill fill(regions, request.settings.drops);
  fill.addContours(regions, std::numeric_limits<std::size_t>::max());
  return std::move(fill).take();
}

}  // namespace lamina
