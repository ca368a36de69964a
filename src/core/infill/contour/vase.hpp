// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// One bead along each outline, counter-clockwise around regions and clockwise around holes; the area inside
/// stays empty. The planner, which knows the other layers, decides which regions are printed so.
std::vector<FillPath> vase(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
