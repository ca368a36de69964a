// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/voxel_input.hpp"

#include <utility>

#include "arguments/toolpath_input.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/geometry/voxel/voxelised_mesh.hpp"
#include "lamina/job/part/part_mesh.hpp"

namespace lamina::cli {
VoxelInput readVoxels(const std::string& input, const JobSettings& settings, Progress& progress) {
  if (isPart(input))
    return {voxelisedMesh(partMesh(input, settings.input), settings.deposition.voxel_mm, progress), {}};
  const Toolpath toolpath = onBed(readToolpath(input, settings));
  std::vector<LayerBand> layers;
  for (const ToolpathLayer& layer : toolpath.layers)
    layers.push_back({layer.z_mm - layer.height_mm, layer.z_mm});
  return {depositedVoxels(toolpath, settings.deposition, progress).grid, std::move(layers)};
}

std::optional<Box3> cropFrom(const std::vector<double>& corners_mm) {
  if (corners_mm.empty()) return std::nullopt;
  const Box3 box{Point3(corners_mm[0], corners_mm[1], corners_mm[2]),
                 Point3(corners_mm[3], corners_mm[4], corners_mm[5])};
  if ((box.high - box.low).minCoeff() > 0.0) return box;
  const auto toText = [](const Point3& point) {
    return "(" + numberText(point.x()) + ", " + numberText(point.y()) + ", " + numberText(point.z()) + ")";
  };
  throw InvalidInput("crop is from " + toText(box.low) + " to " + toText(box.high) +
                     " mm; the second corner must be above the first along all axes");
}

}  // namespace lamina::cli
