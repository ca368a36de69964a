// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether the straight line from one point to the other stays in the regions. Its ends may lie on an
/// outline, within 1e-4 mm; a line along an outline may go either way.
bool staysInside(const Regions& regions, const Point2& from, const Point2& to);

}  // namespace lamina
