// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// Between which values a string passes a place; either bound may be infinite.
struct Gate {
  double at = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The shortest way through gates: of all ways it also has the least greatest slope and the least variation.
/// Linear time.
/// @param gates  ascending by `at`, each no nearer than 1e-12 to the next; both ends are fixed: low = high
/// @return the value at each gate
std::vector<double> tautString(const std::vector<Gate>& gates);

}  // namespace lamina
