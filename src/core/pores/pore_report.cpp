// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/pore_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "lamina/base/parallel.hpp"
#include "lamina/pores/pore_groups.hpp"

namespace lamina {
namespace {

Spread spreadOf(double sum, double squares, double count) {
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

PoreSizes sizesOf(const PoreGroups& pores, const std::function<bool(const PoreGroup&)>& is_counted) {
  PoreSizes sizes;
  double diameters = 0.0;
  std::array<double, 3> sums{};
  std::array<double, 3> squares{};
  for (const PoreGroup& group : pores.groups) {
    if (!is_counted(group)) continue;
    ++sizes.groups;
    sizes.voxels += group.voxels;
    diameters += group.equivalentDiameter();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sums[axis] += group.axes[axis];
      squares[axis] += group.axes[axis] * group.axes[axis];
    }
  }
  const double whole = static_cast<double>(pores.frame.voxelCount());
  sizes.volume_percent = 100.0 * static_cast<double>(sizes.voxels) / whole;
  if (sizes.groups == 0) return sizes;
  const auto count = static_cast<double>(sizes.groups);
  const double voxel = pores.frame.voxel_mm;
  sizes.mean_diameter_mm = voxel * diameters / count;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sizes.ellipsoid_mm[axis] = spreadOf(voxel * sums[axis], voxel * voxel * squares[axis], count);
  return sizes;
}

Passages joiningPassages(const PoreGroups& pores) {
  Passages found;
  NoProgress nobody;
  const auto along = [&](std::size_t axis) {
    const int a = static_cast<int>(axis);
    const bool joins = std::any_of(pores.groups.begin(), pores.groups.end(),
                                   [a](const PoreGroup& group) { return group.joinsAlong(a); });
    if (!joins) return;
    found.along[axis] =
        passageAlong(voxelsOf(pores, [a](const PoreGroup& group) { return group.joinsAlong(a); }), a);
  };
  parallelFor(3, along, nobody, "passages");
  return found;
}

}  // namespace

PoreReport reportPores(const VoxelGrid& solid, Progress& progress) {
  const VoxelGrid pores = inverted(solid);
  const PoreGroups labelled = labelPores(pores, progress);
  PoreReport report;
  report.all = sizesOf(labelled, [](const PoreGroup&) { return true; });
  report.joining_opposite = sizesOf(labelled, [](const PoreGroup& group) { return group.joinsOpposite(); });
  report.joining_two = sizesOf(labelled, [](const PoreGroup& group) { return group.joinsTwoFaces(); });
  report.porosity_percent = report.all.volume_percent;
  throwIfCancelled(progress, "passages");
  report.passages = passages(pores);
  throwIfCancelled(progress, "passages");
  report.joining_passages = joiningPassages(labelled);
  return report;
}

}  // namespace lamina
