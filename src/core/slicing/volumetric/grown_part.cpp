// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/grown_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "slicing/volumetric/given_directions.hpp"
#include "slicing/volumetric/growth_fit.hpp"

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
constexpr std::array<double, 3> kShares = {1.0, 0.5, 0.25};  // of a fit
constexpr double kMoreUnsupported = 0.1;                     // % of the surface, by a fit
constexpr double kBeyondThickness = 0.005;                   // of the volume
constexpr double kBlockMm = 4.0;           // side of blocks of cells, of which the least growth is known
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

GrowthLimits limitsOf(double overhang_rad, const VolumetricSettings& settings) {
  return {overhang_rad, settings.max_thickness, toRadians(settings.max_tilt_deg)};
}

/// With what the growth of a part does to surface and head.
GrownPart measured(GrownPart part, Progress& progress) {
  const VolumetricRequest& request = part.request;
  part.lattice = std::make_shared<const GrowthLattice>(part.cells(), part.field(), part.gauge, progress);
  part.hanging = hangingFrom(part, progress);
  part.room = std::make_shared<const HeadRoom>(part.grown, request.head, part.bed_mm);
  if (request.head.empty()) return part;
  const LeanQuestion question{toRadians(request.settings.deviation_deg), request.slicing.layer_height_mm};
  part.lean = std::make_shared<const HeadLean>(part.cells(), *part.lattice, *part.room, question, progress);
  return part;
}

double bedUnder(const Mesh& mesh, const VolumetricRequest& request) {
  return boundingBox(mesh).low.z() + request.settings.sink_mm;
}

std::shared_ptr<const CellGraph> cellsOf(const Mesh& mesh, const VolumetricRequest& request,
                                         Progress& progress) {
  return std::make_shared<const CellGraph>(mesh, cellFor(volume(mesh), request), bedUnder(mesh, request),
                                           progress);
}

GrownPart grownBy(double overhang_rad, std::shared_ptr<const CellGraph> cells, const Mesh& mesh,
                  const VolumetricRequest& request, Progress& progress) {
  const VolumetricSettings& settings = request.settings;
  const double bed = bedUnder(mesh, request);
  const GrowthGauge gauge(limitsOf(overhang_rad, settings));
  ArrivalField field =
      arrivalField(*cells, gauge, {bed, 0.5 * request.slicing.first_layer_height_mm}, progress);
  GrownPart part{
      mesh,         request, bed,
      overhang_rad, gauge,   std::make_shared<const GrownCells>(std::move(cells), std::move(field)),
      nullptr,      {},      nullptr,
      nullptr,      0.0,     {}};
  requireStanding(part);
  return measured(std::move(part), progress);
}

std::string excessText(const char* what, double percent, double most_percent) {
  char text[120];
  std::snprintf(text, sizeof text, "%.2f %% of the %s, expected at most %.2f %%", percent, what,
                most_percent);
  return text;
}

/// In what a fitted growth prints worse than that it was fitted from; empty if in nothing.
std::string lossBy(const GrownPart& fitted, const GrownPart& arrived) {
  const double most_unsupported = arrived.unsupportedPercent() + kMoreUnsupported;
  if (fitted.unsupportedPercent() > most_unsupported)
    return excessText("surface unsupported", fitted.unsupportedPercent(), most_unsupported);
  const double max_thickness = arrived.request.settings.max_thickness;
  const auto beyond = [&](const GrownPart& part) {
    return grownThickness(part.cells(), *part.lattice, max_thickness).beyond;
  };
  const double most_beyond = std::max(kBeyondThickness, beyond(arrived));
  if (const double share = beyond(fitted); share > most_beyond)
    return excessText("volume beyond the bounds of thickness", 100.0 * share, 100.0 * most_beyond);
  const auto minima = [](const GrownPart& part) {
    return growthMinima(part.cells(), *part.lattice, part.bed_mm);
  };
  if (const std::size_t count = minima(fitted); count > minima(arrived))
    return std::to_string(count) + " cells that grow before their neighbours, expected at most " +
           std::to_string(minima(arrived));
  const double most_shut = std::max(kMuchShut, arrived.shut());
  if (fitted.shut() > most_shut)
    return excessText("volume without room for the head", 100.0 * fitted.shut(), 100.0 * most_shut);
  return {};
}

GrownPart fitted(GrownPart arrived, Progress& progress) {
  const VolumetricRequest& request = arrived.request;
  const VolumetricSettings& settings = request.settings;
  if (settings.target == GrowthTarget::Arrival) return arrived;
  const ArrivedGrowth growth{arrived.cells(), arrived.field(), arrived.gauge};
  GrowthFitRequest asked{settings.target,
                         limitsOf(arrived.overhang_rad, settings),
                         toRadians(settings.skin_slope_deg),
                         request.slicing.first_layer_height_mm,
                         settings.rounds,
                         {},
                         settings.foot};
  if (settings.target == GrowthTarget::Given)
    asked.given = directionsAtNodes(arrived.cells(), request.directions, progress);
  const ArrivalField fit = fittedGrowth(arrived.mesh, growth, asked, progress);
  const auto fittedBy = [&](double share) {
    GrownPart part = arrived;
    part.grown = std::make_shared<const GrownCells>(arrived.grown->cells, blendedGrowth(growth, fit, share));
    part.fitted = share;
    return measured(std::move(part), progress);
  };
  for (const double share : kShares) {
    GrownPart part = fittedBy(share);
    std::string loss = lossBy(part, arrived);
    if (loss.empty()) {
      part.fit_loss = std::move(arrived.fit_loss);
      return part;
    }
    arrived.fit_loss = std::move(loss);
  }
  return arrived;
}

GrowthLoss lossOf(const GrownPart& part) { return {part.hanging.grown_mm2, pendantOf(part).volume_mm3}; }

/// Grown by the overhang that is stated, or that suits surface and head.
GrownPart arrivedPart(const Mesh& mesh, const VolumetricRequest& request, Progress& progress) {
  const VolumetricSettings& settings = request.settings;
  const auto usable = [&](double asked_deg) {
    return overhangWithin(toRadians(std::max(0.0, asked_deg)), settings.max_thickness);
  };
  // However much overhang is used: the cells are the same.
  const std::shared_ptr<const CellGraph> cells = cellsOf(mesh, request, progress);
  if (settings.overhang_used_deg >= 0.0)
    return grownBy(usable(settings.overhang_used_deg), cells, mesh, request, progress);
  const double first_deg = settings.max_overhang_deg - kMarginDeg;
  std::optional<GrownPart> best = grownBy(usable(first_deg), cells, mesh, request, progress);
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
    GrownPart next = grownBy(used_rad, cells, mesh, request, progress);
    if (!isPossible(next)) break;
    // Some room is made only by several steps.
    if (!is_shut || next.shut() < best->shut()) best.emplace(std::move(next));
  }
  return std::move(*best);
}

/// Blocks as far as which a block's neighbours may lie within `HeadRoom::kAroundMm` of a place in it.
int blocksAround(double block_mm) { return static_cast<int>(std::ceil(HeadRoom::kAroundMm / block_mm)); }

}  // namespace

GrownCells::GrownCells(std::shared_ptr<const CellGraph> graph, ArrivalField arrival)
    : cells(std::move(graph)), field(std::move(arrival)) {
  const VoxelFrame& fine = cells->frame();
  const int ratio = std::max(1, static_cast<int>(std::ceil(kBlockMm / fine.voxel_mm)));
  blocks_.voxel_mm = ratio * fine.voxel_mm;
  const int margin = blocksAround(blocks_.voxel_mm);
  blocks_.corner = fine.corner - Point3::Constant(margin * blocks_.voxel_mm);
  for (std::size_t axis = 0; axis < 3; ++axis)
    blocks_.count[axis] = (fine.count[axis] + ratio - 1) / ratio + 2 * margin;
  least_.assign(static_cast<std::size_t>(blocks_.voxelCount()), std::numeric_limits<double>::infinity());
  for (std::uint32_t node = 0; node < cells->nodeCount(); ++node) {
    const std::array<int, 3> cell = cells->cell(node);
    double& least =
        least_[blockOf({cell[0] / ratio + margin, cell[1] / ratio + margin, cell[2] / ratio + margin})];
    least = std::min(least, field.growth_mm[node]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) spreadAlong(axis);
}

std::size_t GrownCells::blockOf(const std::array<int, 3>& block) const {
  return (static_cast<std::size_t>(block[2]) * static_cast<std::size_t>(blocks_.count[1]) +
          static_cast<std::size_t>(block[1])) *
             static_cast<std::size_t>(blocks_.count[0]) +
         static_cast<std::size_t>(block[0]);
}

/// Takes for each block the least of those around it along an axis.
void GrownCells::spreadAlong(std::size_t axis) {
  const std::vector<double> own = least_;
  const int reach = blocksAround(blocks_.voxel_mm);
  for (int k = 0; k < blocks_.count[2]; ++k)
    for (int j = 0; j < blocks_.count[1]; ++j)
      for (int i = 0; i < blocks_.count[0]; ++i) {
        std::array<int, 3> at = {i, j, k};
        double& least = least_[blockOf(at)];
        const int last = std::min(blocks_.count[axis] - 1, at[axis] + reach);
        for (at[axis] = std::max(0, at[axis] - reach); at[axis] <= last; ++at[axis])
          least = std::min(least, own[blockOf(at)]);
      }
}

double GrownCells::leastAround(const Point3& place) const {
  const Point3 at = (place - blocks_.corner) / blocks_.voxel_mm;
  const Point3 count(blocks_.count[0], blocks_.count[1], blocks_.count[2]);
  if ((at.array() < 0.0).any() || (at.array() >= count.array()).any())
    return std::numeric_limits<double>::infinity();
  return least_[blockOf({static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z())})];
}

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
  return fitted(arrivedPart(mesh, request, progress), progress);
}

}  // namespace lamina
