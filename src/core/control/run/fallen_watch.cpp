// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/fallen_watch.hpp"

#include <algorithm>

#include "control/run_stretches.hpp"

namespace lamina {
namespace {

constexpr double kLeastWidths = 3.0;    // bead widths
constexpr std::size_t kOneInCells = 3;  // of the cells of a stretch have points

}  // namespace

void FallenWatch::see(std::size_t cell, double depth_mm) {
  const auto [entry, is_first] = depths_mm_.insert({cell, depth_mm});
  if (!is_first) entry->second = std::min(entry->second, depth_mm);
}

FallenLength FallenWatch::fallen(const LayerCells& cells, const std::vector<CellEstimate>& estimates) const {
  if (depths_mm_.empty()) return {};
  std::vector<double> is_fallen(cells.size(), 0.0);
  double sum = 0.0;
  std::size_t count = 0;
  const auto isUnseen = [&](std::size_t a, std::size_t b) {
    return !estimates[a].isSeen() && !estimates[b].isSeen();
  };
  for (const CellRun& run : cells.runs)
    for (const CellStretch& stretch : stretchesOf(run, isUnseen)) {
      const double length = static_cast<double>(stretch.count) * run.cellLength();
      if (estimates[stretch.first].isSeen() || length < kLeastWidths * cells.width_mm[stretch.first])
        continue;
      double depths = 0.0;
      std::size_t shown = 0;
      for (std::size_t i = 0; i < stretch.count; ++i) {
        const auto depth = depths_mm_.find(cellOf(run, stretch, i));
        if (depth == depths_mm_.end()) continue;
        depths += depth->second;
        ++shown;
      }
      if (kOneInCells * shown < stretch.count) continue;
      for (std::size_t i = 0; i < stretch.count; ++i) is_fallen[cellOf(run, stretch, i)] = 1.0;
      sum += depths;
      count += shown;
    }
  if (count == 0) return {};
  return {meanOverCells(cells, is_fallen), sum / static_cast<double>(count)};
}

}  // namespace lamina
