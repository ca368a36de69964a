// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// Range of values through which a string must pass at some position; either bound may be infinite.
struct Gate {
  double at = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The shortest line through a sequence of gates. Of all lines through them it also has the smallest greatest
/// slope and the least variation. Takes linear time.
/// @param gates  ascending by `at`, each no nearer than 1e-12 to the next; both ends are fixed: low = high
/// @return the value at each gate
std::vector<double> tautString(const std::vector<Gate>& gates);

}  // namespace lamina
