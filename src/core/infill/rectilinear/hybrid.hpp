// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Perimeters first, then a zigzag inside of them [Flores2018, section 6.1.2].
std::vector<FillPath> hybrid(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
