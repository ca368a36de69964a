// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/planning/flow/flow.hpp"
#include "planning/flow/path_cut.hpp"
#include "toolpath/deposited_segment.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kLeastCoast = 1e-3;  // mm: what is shorter is not worth a waypoint

/// The place from which the rest of a path holds that volume, or is as long as it may be.
CutPlace coastStart(const Path& path, const FlowSettings& settings) {
  double left_mm3 = settings.coast_mm3;
  double left_mm = std::min(settings.coast_longest_mm, 0.5 * length(path));
  for (std::size_t m = path.motionCount(); m-- > 0;) {
    const double length_mm = motionLength(path, m);
    const double section = crossSection(path.bead.at(path.motionEnd(m)));
    const double by_volume = section > 0.0 ? left_mm3 / section : length_mm + left_mm;
    const double part = std::min(left_mm, by_volume);
    if (part < length_mm) return {m, 1.0 - part / length_mm};
    left_mm -= length_mm;
    left_mm3 -= section * length_mm;
  }
  return {0, 0.0};
}

struct CoastedLayer {
  std::vector<Path> paths;
  Coasting coasting;
};

void addCoasted(const Path& path, const FlowSettings& settings, CoastedLayer& layer) {
  const CutPlace start = coastStart(path, settings);
  const double length_mm = motionLength(path, start.motion);
  const bool is_whole = start.share * length_mm < kLeastCoast;
  if ((1.0 - start.share) * length_mm < kLeastCoast || (is_whole && start.motion == 0)) {
    layer.paths.push_back(path);
    return;
  }
  auto [run, end] =
      is_whole ? cutAt(path, start.motion) : cutAt(withWaypoints(path, {start}), start.motion + 1);
  ++layer.coasting.runs;
  layer.coasting.left_mm3 += depositedVolume(end);
  end.role = PathRole::Travel;
  end.bead = Bead{};
  layer.paths.push_back(std::move(run));
  layer.paths.push_back(std::move(end));
}

CoastedLayer coasted(const ToolpathLayer& layer, const Path* next_layer, const FlowSettings& settings) {
  CoastedLayer result;
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const Path& path = layer.paths[p];
    const Path* next = p + 1 < layer.paths.size() ? &layer.paths[p + 1] : next_layer;
    if (laysBeads(path) && (next == nullptr || !laysBeads(*next)))
      addCoasted(path, settings, result);
    else
      result.paths.push_back(path);
  }
  return result;
}

}  // namespace

Coasting coast(Toolpath& toolpath, const FlowSettings& settings, Progress& progress) {
  Coasting sum;
  if (settings.coast_mm3 == 0.0 || settings.coast_longest_mm == 0.0) return sum;
  std::vector<const Path*> next(toolpath.layers.size(), nullptr);
  for (std::size_t l = toolpath.layers.size(); l-- > 1;)
    next[l - 1] = toolpath.layers[l].paths.empty() ? next[l] : &toolpath.layers[l].paths.front();
  std::vector<CoastedLayer> layers(toolpath.layers.size());
  parallelFor(
      layers.size(), [&](std::size_t l) { layers[l] = coasted(toolpath.layers[l], next[l], settings); },
      progress, "flow");
  for (std::size_t l = 0; l < layers.size(); ++l) {
    toolpath.layers[l].paths = std::move(layers[l].paths);
    sum.runs += layers[l].coasting.runs;
    sum.left_mm3 += layers[l].coasting.left_mm3;
  }
  return sum;
}

}  // namespace lamina
