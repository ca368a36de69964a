// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "slicing/curved/curved_division.hpp"
#include "slicing/curved/part_samples.hpp"

namespace lamina {

/// What a scheme gets wrong, as samples of the part.
struct CurvedFlaws {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::vector<Point3> beside;  ///< beyond the edges of what its layers grow from, found before they grow
  std::vector<Point3> open;    ///< in no layer
  std::vector<Point3> twice;   ///< in more than one layer

  /// As many samples as are wrong at least.
  std::size_t count() const { return std::max(beside.size(), open.size() + twice.size()); }
};

/// Refuses a part for what the scheme that comes nearest gets wrong: what, where, and what to do instead. The
/// region is the surface nearest to it.
/// @throws Unsliceable always
[[noreturn]] void refuseCurved(const CurvedPart& part, const PartSamples& samples, const CurvedFlaws& flaws);

}  // namespace lamina
