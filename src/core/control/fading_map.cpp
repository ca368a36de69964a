// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/fading_map.hpp"

#include <algorithm>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

double lastAmount(const CorrectionMap& map, const ToolpathLayer& layer) {
  const auto last = std::find_if(layer.paths.rbegin(), layer.paths.rend(),
                                 [](const Path& path) { return path.role != PathRole::Travel; });
  if (last == layer.paths.rend() || map.paths.empty()) return 0.0;
  const auto number = static_cast<std::size_t>(layer.paths.rend() - last) - 1;
  const PathCorrection& corrected = map.paths.back();
  return corrected.path == number && !corrected.stations.empty() ? corrected.stations.back().amount : 0.0;
}

CorrectionMap fadingMap(const ToolpathLayer& layer, std::size_t number, double from, double cell_mm,
                        const LoopSettings& settings) {
  const LayerCells cells = layerCells(layer, number, cell_mm);
  const std::vector<double> before(cells.size(), from);
  const std::vector<double> planned(cells.size(), 0.0);
  CorrectionMap map =
      correctionMap(cells, {fadedCorrection(cells, before, planned, 0, settings), {}, {}}, {}, 0);
  map.paths.erase(std::remove_if(map.paths.begin(), map.paths.end(), isNone), map.paths.end());
  return map;
}

}  // namespace lamina
