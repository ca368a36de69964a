// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orient_toolpath.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "orientation/run_orientation.hpp"
#include "orientation/travel_orientation.hpp"
#include "orientation/turn_measure.hpp"

namespace lamina {
namespace {

/// What orienting one layer found.
struct LayerFindings {
  std::vector<LimitHit> limits_hit;
  std::size_t waypoints_without_wall = 0;
};

RunOrientation oriented(const Path& run, const OrientationSettings& settings, const WallNormals* walls,
                        const WaypointIndex& at) {
  try {
    return runOrientation(run, settings, walls);
  } catch (const InvalidInput& error) {
    throw InvalidInput("layer " + std::to_string(at.layer) + ", path " + std::to_string(at.path) + ": " +
                       error.what());
  }
}

LayerFindings orientLayer(ToolpathLayer& layer, std::size_t number, const OrientationSettings& settings,
                          const WallNormals* walls) {
  LayerFindings findings;
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    Path& path = layer.paths[p];
    if (path.role == PathRole::Travel) continue;
    RunOrientation run = oriented(path, settings, walls, {number, p, 0});
    path.orientation = std::move(run.orientation);
    findings.waypoints_without_wall += run.waypoints_without_wall;
    for (LimitHit& hit : run.limits_hit) {
      hit.worst.layer = number;
      hit.worst.path = p;
      findings.limits_hit.push_back(hit);
    }
  }
  return findings;
}

}  // namespace

OrientedToolpath orientToolpath(Toolpath toolpath, const OrientationSettings& settings, const Mesh& part,
                                Progress& progress) {
  validate(settings);
  std::optional<WallNormals> walls;
  if (settings.mode == OrientationMode::Wall)
    walls.emplace(part, layerNormal(toolpath), settings.wall.max_lean_deg);
  std::vector<LayerFindings> findings(toolpath.layers.size());
  parallelFor(
      findings.size(),
      [&](std::size_t l) {
        findings[l] = orientLayer(toolpath.layers[l], l, settings, walls ? &*walls : nullptr);
      },
      progress, "orient");
  OrientedToolpath result;
  result.toolpath = withTravelsOriented(std::move(toolpath));
  result.report = measuredTurns(result.toolpath);
  for (const LayerFindings& layer : findings) {
    result.report.limits_hit.insert(result.report.limits_hit.end(), layer.limits_hit.begin(),
                                    layer.limits_hit.end());
    result.report.waypoints_without_wall += layer.waypoints_without_wall;
  }
  return result;
}

}  // namespace lamina
