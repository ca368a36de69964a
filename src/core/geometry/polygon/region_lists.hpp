// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether they hold the same points in the same order.
inline bool areEqual(const Regions& a, const Regions& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Region& x, const Region& y) {
    return x.outer == y.outer && x.holes == y.holes;
  });
}

/// Puts regions behind others, which they do not overlap.
inline void appendTo(Regions& all, const Regions& more) { all.insert(all.end(), more.begin(), more.end()); }

}  // namespace lamina
