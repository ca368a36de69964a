// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// An area shared out by another one.
struct DividedArea {
  Regions common;  ///< where the other is
  Regions rest;    ///< where it is not
};

/// The same as `intersection` and `difference`, for little more than one of them.
DividedArea divided(const Regions& area, const Regions& by);

}  // namespace lamina
