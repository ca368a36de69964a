// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether two lists of regions have the same points in the same order.
inline bool areEqual(const Regions& a, const Regions& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Region& x, const Region& y) {
    return x.outer == y.outer && x.holes == y.holes;
  });
}

/// Appends regions that do not overlap the ones before.
inline void appendTo(Regions& all, const Regions& more) { all.insert(all.end(), more.begin(), more.end()); }

}  // namespace lamina
