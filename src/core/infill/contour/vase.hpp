// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// One bead along each outline, counter-clockwise round regions and clockwise round holes; what it surrounds
/// stays empty. Which regions make a vase is for the planner to say, which knows the other layers.
std::vector<FillPath> vase(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
