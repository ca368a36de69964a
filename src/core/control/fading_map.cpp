// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/fading_map.hpp"

#include <algorithm>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {
namespace {

/// Planned speeds at the stations of a path.
void addSpeeds(std::vector<double>& speeds, const Path& path, const PathCorrection& corrected) {
  std::size_t motion = 0;
  const auto lengthOf = [&](std::size_t m) {
    return (path.points[path.motionEnd(m)] - path.points[m]).norm();
  };
  double end_mm = lengthOf(0);
  for (std::size_t i = 0; i < corrected.stations.size(); ++i) {
    const double along_mm = (static_cast<double>(i) + 0.5) * corrected.spacing_mm;
    while (motion + 1 < path.motionCount() && end_mm < along_mm) end_mm += lengthOf(++motion);
    speeds.push_back(path.feed_mm_s.at(path.motionEnd(motion)));
  }
}

/// The stations of a map as cells, as far as they matter to how amounts go over.
LayerCells stationCells(const CorrectionMap& map, const ToolpathLayer& layer) {
  LayerCells cells;
  auto corrected = map.paths.begin();
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const Path& path = layer.paths[p];
    if (path.role == PathRole::Travel) continue;
    const bool is_run = corrected != map.paths.end() && corrected->path == p;
    if (is_run) {
      const std::size_t count = corrected->stations.size();
      const double length_mm = corrected->spacing_mm * static_cast<double>(count);
      cells.runs.push_back(
          {p, cells.speed_mm_s.size(), count, length_mm, path.is_closed, cells.ends_with_other});
      addSpeeds(cells.speed_mm_s, path, *corrected);
      ++corrected;
    }
    cells.ends_with_other = !is_run;
  }
  cells.middle.resize(cells.speed_mm_s.size());
  return cells;
}

}  // namespace

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

CorrectionMap fadedMap(CorrectionMap map, const ToolpathLayer& layer, double from,
                       const LoopSettings& settings) {
  const LayerCells cells = stationCells(map, layer);
  std::vector<double> amounts;
  amounts.reserve(cells.size());
  for (const PathCorrection& path : map.paths)
    for (const PointCorrection& place : path.stations) amounts.push_back(place.amount);
  if (amounts.size() != cells.size()) return map;  // of paths that the layer does not deposit
  const std::vector<double> before(cells.size(), from);
  const std::vector<double> faded = fadedCorrection(cells, before, amounts, 0, settings);
  auto amount = faded.begin();
  for (PathCorrection& path : map.paths)
    for (PointCorrection& place : path.stations) place.amount = *amount++;
  return map;
}

}  // namespace lamina
