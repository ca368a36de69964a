// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The region without the points that lie within the tolerance of the edge that replaces them; as it is where
/// its outlines would vanish or come apart so.
Region straightened(Region region, double tolerance_mm);

}  // namespace lamina
