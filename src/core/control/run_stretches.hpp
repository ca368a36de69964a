// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// Consecutive cells of a run that belong together.
struct CellStretch {
  std::size_t first = 0;  ///< number of the first cell in the layer
  std::size_t count = 0;
};

/// The i-th cell of a stretch. On a closed run a stretch continues after the last cell with the first.
inline std::size_t cellOf(const CellRun& run, const CellStretch& stretch, std::size_t i) {
  return run.first + (stretch.first - run.first + i) % run.count;
}

/// Divides a run between cells for which belongs(cell, next) is false. On a closed run the last and the first
/// cell are tested too.
template <class Belongs>
std::vector<CellStretch> stretchesOf(const CellRun& run, Belongs belongs) {
  std::vector<CellStretch> stretches;
  for (std::size_t i = run.first; i < run.first + run.count; ++i) {
    if (i == run.first || !belongs(i - 1, i)) stretches.push_back({i, 0});
    ++stretches.back().count;
  }
  if (run.is_closed && stretches.size() > 1 && belongs(run.first + run.count - 1, run.first)) {
    stretches.back().count += stretches.front().count;
    stretches.erase(stretches.begin());
  }
  return stretches;
}

}  // namespace lamina
