// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// Number of the run that a cell of the layer belongs to; logarithmic in the runs.
inline std::size_t runOf(const LayerCells& cells, std::size_t cell) {
  const auto after = std::upper_bound(cells.runs.begin(), cells.runs.end(), cell,
                                      [](std::size_t at, const CellRun& run) { return at < run.first; });
  return static_cast<std::size_t>(after - cells.runs.begin()) - 1;
}

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

/// The stretch of `stretchesOf` that holds a cell of the run; linear in its cells. If all cells of a closed
/// run belong together, it may begin at any cell.
template <class Belongs>
CellStretch stretchAround(const CellRun& run, std::size_t cell, Belongs belongs) {
  const std::size_t end = run.first + run.count;
  const auto next = [&](std::size_t at) { return at + 1 < end ? at + 1 : run.first; };
  const auto before = [&](std::size_t at) { return at > run.first ? at - 1 : end - 1; };
  CellStretch stretch{cell, 1};
  for (std::size_t last = cell; stretch.count < run.count; ++stretch.count) {
    if ((!run.is_closed && last + 1 == end) || !belongs(last, next(last))) break;
    last = next(last);
  }
  for (; stretch.count < run.count; ++stretch.count) {
    const std::size_t previous = before(stretch.first);
    if ((!run.is_closed && stretch.first == run.first) || !belongs(previous, stretch.first)) break;
    stretch.first = previous;
  }
  return stretch;
}

}  // namespace lamina
