// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/volume_error.hpp"

#include <algorithm>
#include <cmath>

#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// In diameters of a disc of the section.
double shortening(StrandEnds ends) {
  if (ends == StrandEnds::Whole) return 0.0;
  return ends == StrandEnds::Generated ? 1.0 : 0.5;
}

double volumeOf(const Path& path, const VolumeErrorSettings& settings) {
  double sum = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const Bead& bead = path.bead.at(end);
    if (bead.width_mm <= 0.0) continue;
    const double area =
        settings.section == VolumeSection::Strand ? settings.strand_area_mm2 : crossSection(bead);
    const double diameter = std::sqrt(4.0 * area / M_PI);
    const double length = (path.points[end] - path.points[m]).norm();
    sum += area * std::max(0.0, length - shortening(settings.ends) * diameter);
  }
  return sum;
}

}  // namespace

double estimatedVolume(const Toolpath& toolpath, const VolumeErrorSettings& settings) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (isPartOfPart(path))
        sum += path.deposit == Deposit::Drops ? depositedVolume(path) : volumeOf(path, settings);
  return sum;
}

double volumeError(const Toolpath& toolpath, double part_mm3, const VolumeErrorSettings& settings) {
  return std::abs(estimatedVolume(toolpath, settings) - part_mm3 * settings.fill_share);
}

}  // namespace lamina
