// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/sweep.hpp"

#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/sweep/path_cuts.hpp"
#include "toolpath/bead_space.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kNoLength = 1e-9;  // mm

/// One sweep along the whole path, its points without repeats.
Sweep whole(const Path& path) {
  Sweep sweep;
  double length_mm = 0.0, volume_mm3 = 0.0, height_mm2 = 0.0;
  sweep.points.push_back(path.firstPoint());
  sweep.up.push_back(upAt(path, path.motionEnd(0)));
  forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
    const double motion_mm = (segment.end - sweep.points.back()).norm();
    if (motion_mm < kNoLength) return;
    sweep.points.push_back(segment.end);
    sweep.up.push_back(upAt(path, segment.waypoint));
    length_mm += motion_mm;
    volume_mm3 += motion_mm * crossSection(segment.bead);
    height_mm2 += motion_mm * segment.bead.height_mm;
  });
  if (volume_mm3 > 0.0) sweep.bead = beadOfArea(volume_mm3 / length_mm, height_mm2 / length_mm);
  return sweep;
}

bool isLoop(const Sweep& sweep) {
  return sweep.points.size() > 3 && (sweep.points.front() - sweep.points.back()).norm() < 1e-6;
}

/// From point to point, both included.
Sweep section(const Sweep& sweep, std::size_t first, std::size_t last) {
  Sweep part;
  part.bead = sweep.bead;
  part.layer = sweep.layer;
  part.trajectory = sweep.trajectory;
  const auto from = static_cast<std::ptrdiff_t>(first), to = static_cast<std::ptrdiff_t>(last) + 1;
  part.points.assign(sweep.points.begin() + from, sweep.points.begin() + to);
  part.up.assign(sweep.up.begin() + from, sweep.up.begin() + to);
  part.up.front() = part.up[1];
  return part;
}

/// The program of [Vega2023, section 3.2.3] takes the height of the layer above the bed, and has no upright
/// stadium.
double cuttingWidth(const Sweep& sweep, CutHeight height) {
  const double z_mm = sweep.points.front().z();
  if (height == CutHeight::Bead || !(z_mm > 0.0)) return sweep.bead.width_mm;
  return z_mm * (1.0 - 0.25 * M_PI) + crossSection(sweep.bead) / z_mm;
}

std::vector<std::size_t> cutsOf(const Sweep& sweep, const SweepSettings& settings) {
  std::vector<std::size_t> cuts;
  if (settings.corners == CornerStrategy::Lines || settings.corners == CornerStrategy::Revolved) {
    for (std::size_t i = 1; i < sweep.lineCount(); ++i) cuts.push_back(i);
  } else if (settings.corners == CornerStrategy::Sections) {
    std::vector<Point2> plan;
    plan.reserve(sweep.points.size());
    for (const Point3& point : sweep.points) plan.push_back(point.head<2>());
    cuts = pathCuts(plan, cuttingWidth(sweep, settings.cut_height));
  }
  return cuts;
}

void append(Sweep sweep, const SweepSettings& settings, std::vector<Sweep>& sweeps) {
  std::size_t first = 0;
  for (const std::size_t cut : cutsOf(sweep, settings)) {
    sweeps.push_back(section(sweep, first, cut));
    first = cut;
  }
  if (first != 0) {
    sweeps.push_back(section(sweep, first, sweep.points.size() - 1));
  } else {
    sweep.is_loop = settings.corners == CornerStrategy::Whole && isLoop(sweep);
    sweeps.push_back(std::move(sweep));
  }
}

}  // namespace

std::vector<Sweep> sweepsOf(const Toolpath& toolpath, const SweepSettings& settings) {
  std::vector<Sweep> sweeps;
  std::size_t trajectory = 0;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (const Path& path : toolpath.layers[l].paths) {
      if (!isPartOfPart(path)) continue;
      if (path.deposit == Deposit::Drops)
        throw InvalidInput("layer " + std::to_string(l) +
                           " has a path of drops; expected beads, which can be swept");
      Sweep sweep = whole(path);
      if (sweep.points.size() < 2 || sweep.bead.width_mm == 0.0) continue;
      sweep.layer = l;
      sweep.trajectory = trajectory++;
      append(std::move(sweep), settings, sweeps);
    }
  return sweeps;
}

double sweptVolume(const std::vector<Sweep>& sweeps) {
  double sum = 0.0;
  for (const Sweep& sweep : sweeps)
    for (std::size_t i = 0; i < sweep.lineCount(); ++i)
      sum += (sweep.points[i + 1] - sweep.points[i]).norm() * crossSection(sweep.bead);
  return sum;
}

}  // namespace lamina
