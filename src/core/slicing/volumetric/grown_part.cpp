// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/grown_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"

namespace lamina {
namespace {

constexpr double kMarginDeg = 20.0;      // between the overhang taken and that used up
constexpr double kLeastMarginDeg = 5.0;  // the same where the head needs room
constexpr double kLeastUsedDeg = 5.0;    // where much is left unsupported
constexpr double kOverhangStepDeg = 2.5;
constexpr double kLittleShut = 0.006;        // of the volume: a third of it is left out then
constexpr double kMuchShut = 0.01;           // of the volume
constexpr double kMuchUnsupported = 2.0;     // % of the surface
constexpr double kNodesAimedAt = 500'000.0;  // in cells chosen by the part's volume
constexpr double kMostNodes = 4'000'000.0;
constexpr double kLargestCellMm = 1.0;
constexpr double kLeastBeads = 2.0 / 3.0;  // of a cell so chosen, in bead widths

double cellFor(double volume_mm3, const VolumetricRequest& request) {
  if (request.settings.cell_mm > 0.0) return request.settings.cell_mm;
  const double aimed_at = std::min(std::cbrt(volume_mm3 / kNodesAimedAt), kLargestCellMm);
  return std::max({aimed_at, kLeastBeads * request.bead_mm, std::cbrt(volume_mm3 / kMostNodes)});
}

void requireStanding(const GrownPart& part) {
  const double bead = part.request.bead_mm;
  if (part.field().contact_mm2 >= bead * bead) return;
  char text[240];
  std::snprintf(
      text, sizeof text,
      "the part touches the bed by %.3g mm² at half of the first layer; expected at least a bead's square, "
      "%.3g mm²: sink it by volumetric.sink_mm, or turn it",
      part.field().contact_mm2, bead * bead);
  TriangleNumbers lowest;
  for (std::uint32_t i = 0; i < part.mesh.triangles.size(); ++i)
    for (const std::uint32_t corner : part.mesh.triangles[i])
      if (part.mesh.vertices[corner].z() < part.bed_mm + part.cells().frame().voxel_mm) {
        lowest.push_back(i);
        break;
      }
  throw Unsliceable(text, patchOf(part.mesh, lowest));
}

HangingSurface hangingFrom(const GrownPart& part, Progress& progress) {
  const VolumetricRequest& request = part.request;
  return hangingSurface(
      part.mesh, part.cells(), *part.lattice,
      {toRadians(request.settings.max_overhang_deg), part.bed_mm + request.slicing.first_layer_height_mm},
      progress);
}

GrownPart grownBy(double overhang_rad, const Mesh& mesh, const VolumetricRequest& request,
                  Progress& progress) {
  const VolumetricSettings& settings = request.settings;
  const double bed = boundingBox(mesh).low.z() + settings.sink_mm;
  CellGraph cells(mesh, cellFor(volume(mesh), request), bed, progress);
  const GrowthGauge gauge({overhang_rad, settings.max_thickness, toRadians(settings.max_tilt_deg)});
  ArrivalField field =
      arrivalField(cells, gauge, {bed, 0.5 * request.slicing.first_layer_height_mm}, progress);
  GrownPart part{mesh,    request,
                 bed,     overhang_rad,
                 gauge,   std::make_shared<const GrownCells>(std::move(cells), std::move(field)),
                 nullptr, {},
                 nullptr, nullptr};
  requireStanding(part);
  part.lattice = std::make_shared<const GrowthLattice>(part.cells(), part.field(), gauge, progress);
  part.hanging = hangingFrom(part, progress);
  part.room = std::make_shared<const HeadRoom>(part.grown, request.head, bed);
  if (request.head.empty()) return part;
  const LeanQuestion question{toRadians(settings.deviation_deg), request.slicing.layer_height_mm};
  part.lean = std::make_shared<const HeadLean>(part.cells(), *part.lattice, *part.room, question, progress);
  return part;
}

GrowthLoss lossOf(const GrownPart& part) { return {part.hanging.grown_mm2, pendantOf(part).volume_mm3}; }

}  // namespace

bool supportsMore(const GrowthLoss& next, const GrowthLoss& best, double layer_height_mm) {
  const double gained_mm2 = best.unsupported_mm2 - next.unsupported_mm2;
  const double lost_mm3 = next.pendant_mm3 - best.pendant_mm3;
  return gained_mm2 > 0.0 && lost_mm3 <= layer_height_mm * gained_mm2;
}

Pendant pendantOf(const GrownPart& part) {
  Pendant pendant;
  for (std::uint32_t node = 0; node < part.cells().nodeCount(); ++node) {
    const double volume = part.cells().volume(node);
    pendant.whole_mm3 += volume;
    if (std::isfinite(part.field().growth_mm[node])) continue;
    pendant.volume_mm3 += volume;
    if (part.cells().middle(node).z() < pendant.lowest.z()) pendant.lowest = part.cells().middle(node);
  }
  return pendant;
}

GrownPart grownPart(const Mesh& mesh, const VolumetricRequest& request, Progress& progress) {
  const VolumetricSettings& settings = request.settings;
  const auto usable = [&](double asked_deg) {
    return overhangWithin(toRadians(std::max(0.0, asked_deg)), settings.max_thickness);
  };
  if (settings.overhang_used_deg >= 0.0)
    return grownBy(usable(settings.overhang_used_deg), mesh, request, progress);
  const double first_deg = settings.max_overhang_deg - kMarginDeg;
  std::optional<GrownPart> best = grownBy(usable(first_deg), mesh, request, progress);
  const bool is_shut = best->shut() > kMuchShut;
  const double step_deg = is_shut ? kOverhangStepDeg : -kOverhangStepDeg;
  const auto isLeftOff = [&] {
    return is_shut ? best->shut() <= kLittleShut : best->unsupportedPercent() <= kMuchUnsupported;
  };
  const auto isPossible = [&](const GrownPart& next) {
    return is_shut
               ? next.unsupportedPercent() <= settings.largest_unsupported_percent
               : next.shut() <= kMuchShut && pendantOf(next).percent() <= settings.largest_pendant_percent &&
                     supportsMore(lossOf(next), lossOf(*best), request.slicing.layer_height_mm);
  };
  double used_rad = best->overhang_rad;
  for (double asked_deg = first_deg + step_deg; !isLeftOff(); asked_deg += step_deg) {
    if (asked_deg < kLeastUsedDeg || asked_deg > settings.max_overhang_deg - kLeastMarginDeg) break;
    if (usable(asked_deg) == used_rad) break;
    used_rad = usable(asked_deg);
    GrownPart next = grownBy(used_rad, mesh, request, progress);
    if (!isPossible(next)) break;
    // Some room is made only by several steps.
    if (!is_shut || next.shut() < best->shut()) best.emplace(std::move(next));
  }
  return std::move(*best);
}

}  // namespace lamina
