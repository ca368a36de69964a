// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// An area divided by another one.
struct DividedArea {
  Regions common;  ///< inside the other area
  Regions rest;    ///< outside the other area
};

/// `intersection` and `difference` of two areas together, in little more time than either takes alone.
DividedArea divided(const Regions& area, const Regions& by);

}  // namespace lamina
