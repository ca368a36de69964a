// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether no two edges of all outlines meet, except neighbours in their common point. False also if this is
/// in doubt: within rounding, at a point that occurs twice, or if deciding takes more than about linear time.
bool areSurelyApart(const std::vector<Polygon>& outlines);

}  // namespace lamina
