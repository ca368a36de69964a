// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/part_slicing.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "job/modes/automatic_planning.hpp"
#include "job/modes/inclined_layers.hpp"
#include "job/modes/oriented_planning.hpp"
#include "job/part/shrinkage.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/part/copies.hpp"
#include "lamina/job/part/placement.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kFarthest = 1e4;  // mm, as polygons take them
constexpr double kSmall = 2.5;     // mm

/// Its own material, or what it stands on.
bool carriesPart(const Path& path) {
  return isPartOfPart(path) || path.role == PathRole::Support || path.role == PathRole::SupportInterface ||
         path.role == PathRole::Raft;
}

template <class IsCounted>
bool lays(const ToolpathLayer& layer, const IsCounted& is_counted) {
  return std::any_of(layer.paths.begin(), layer.paths.end(), is_counted);
}

/// Layers in which nothing is deposited, but in one above.
std::size_t countEmptyLayers(const std::vector<ToolpathLayer>& layers) {
  const auto last = std::find_if(layers.rbegin(), layers.rend(),
                                 [](const ToolpathLayer& layer) { return lays(layer, isPartOfPart); });
  return static_cast<std::size_t>(std::count_if(
      last, layers.rend(), [](const ToolpathLayer& layer) { return !lays(layer, carriesPart); }));
}

/// A part that is thinner than any bead, or drop, everywhere would leave nothing but its skirt.
void requireDeposition(const Toolpath& toolpath, const PlanSettings& settings) {
  for (const ToolpathLayer& layer : toolpath.layers)
    if (lays(layer, isPartOfPart)) return;
  const std::string part =
      "of part '" + toolpath.part_name + "' is deposited in any of " + std::to_string(toolpath.layers.size());
  if (depositsDrops(settings.infill.strategy))
    throw InvalidInput("no drop " + part + " layers: it is narrower than drops.diameter_mm, " +
                       numberText(settings.fill.drops.diameter_mm) + " mm, everywhere");
  throw InvalidInput("no bead " + part + " layers: it is narrower than walls.narrowest, " +
                     numberText(settings.walls.narrowest) +
                     " pitches, everywhere, or walls.count and infill.density are both 0");
}

std::string sizeText(const Point3& size) {
  char text[96];
  std::snprintf(text, sizeof text, "%.4g x %.4g x %.4g mm", size.x(), size.y(), size.z());
  return text;
}

/// Sections are cut in whole nanometres. A belt's part may be as long as it likes.
void requireNearOrigin(const Box3& part) {
  const double nearest = part.low.cwiseMax(-part.high).maxCoeff();
  if (nearest <= kFarthest) return;
  char text[128];
  std::snprintf(text, sizeof text,
                "the part begins %.6g mm from the origin of its file; must lie within %.6g mm of it", nearest,
                kFarthest);
  throw InvalidMesh(text);
}

/// A part so small is more often one in another unit.
std::string smallNote(const Point3& size) {
  return "the part is only " + sizeText(size) +
         ": if that is too small, its file is in another unit, which input.unit states";
}

/// Refuses early what cannot fit anywhere; the exact check is made on the toolpath.
void requireFits(const Box3& part, const Box3& bed, const std::string& machine) {
  if ((part.size().array() <= bed.size().array()).all()) return;
  throw Unreachable("the part is " + sizeText(part.size()) + "; the machine " + machine + " reaches over " +
                    sizeText(bed.size()));
}

/// Of the part and what it is deposited on.
Box3 boxOnBed(const SourcePart& source) {
  Box3 box = boundingBox(source.mesh);
  for (const Point3& vertex : source.base.vertices) box.include(vertex);
  return box;
}

void addSource(SliceSummary& summary, const SourcePart& source) {
  summary.triangles = source.mesh.triangles.size();
  summary.mesh_volume_mm3 = volume(source.mesh);
  summary.repairs = source.repairs;
}

std::string volumesNote(std::size_t left_out) {
  return std::to_string(left_out) +
         " volumes of the file that change how the part is deposited are left out: only level layers mind "
         "them";
}

/// How far the brim of a part in inclined layers may reach before it along a belt [mm].
double brimBefore(const JobSettings& settings) {
  const BrimSettings& brim = settings.planning.adhesion.brim;
  if (brim.width_mm == 0.0 || brim.where == BrimWhere::Inside) return 0.0;
  // In whole pitches.
  return brim.gap_mm + brim.width_mm + 0.5 * settings.planning.bead.width_mm;
}

/// As far on along the belt as its brim reaches before it, so that this begins where the belt begins.
Eigen::Isometry3d movedOnBelt(Eigen::Isometry3d bed_from_part, const JobSettings& settings,
                              const BuildSpace& space) {
  if (settings.slicing.plane.angle_deg == 0.0 || settings.placement == Placement::AsIs) return bed_from_part;
  for (int i = 0; i < 3; ++i)
    if (space.is_endless[static_cast<std::size_t>(i)])
      bed_from_part.pretranslate(brimBefore(settings) * space.bed_from_axes.linear().col(i));
  return bed_from_part;
}

}  // namespace

void addToolpath(SliceSummary& summary, const Toolpath& toolpath) {
  const ToolpathTotals sums = totals(toolpath);
  summary.deposition_runs = sums.deposition_runs;
  summary.deposition_mm = sums.deposition_mm;
  summary.travel_mm = sums.travel_mm;
  summary.deposited_mm3 = sums.deposited_mm3;
  summary.repositions = countRepositions(toolpath);
  summary.empty_layers = countEmptyLayers(toolpath.layers);
}

void requireToolAxisFor(const SliceJob& job, const BuildSpace& space) {
  const SlicingSettings& slicing = job.settings.slicing;
  if (hasPlaneLayers(slicing.mode) || slicing.plane.angle_deg != 0.0) requireToolAxis(slicing.plane, space);
}

SourcePart readSource(const SliceJob& job, Progress& progress) {
  SourcePart source = readPart(job.part, job.settings.input, progress);
  const std::string& mode = job.settings.slicing.mode;
  const std::string& base = job.settings.conformal.base;
  if (base.empty()) return source;
  if (mode == kAutoMode || slicingModes().find(mode).deposited_on == DepositedOn::Base)
    source.base = readPart(base, job.settings.input, progress).mesh;
  return source;
}

PartOnBed partOnBed(SourcePart read, const SliceJob& job, const BuildSpace& space) {
  PartOnBed on_bed{grownForShrinkage(std::move(read), job.settings)};
  const Box3 box = boxOnBed(on_bed.source);
  requireNearOrigin(box);
  requireFits(box, boundingBox(space), space.name);
  on_bed.bed_from_part = movedOnBelt(placePart(box, space, job.settings.placement), job.settings, space);
  return on_bed;
}

SlicedPart sliceSource(SourcePart source, const SliceJob& job, const BuildSpace& space, Progress& progress,
                       const std::vector<ModeCandidate>& refused) {
  SlicedPart sliced;
  const Point3 drawn = boundingBox(source.mesh).size();
  PartOnBed on_bed = partOnBed(std::move(source), job, space);
  const Point3 size = boundingBox(on_bed.source.mesh).size();
  const std::size_t volumes = on_bed.source.volumes.size();
  addSource(sliced.summary, on_bed.source);
  sliced.bed_from_part = on_bed.bed_from_part;
  sliced.toolpath = planOriented(std::move(on_bed.source), {job, space, sliced.bed_from_part, refused},
                                 sliced.summary, progress);
  sliced.bed_from_part.pretranslate(Point3(0.0, 0.0, sliced.summary.raft_mm));
  const bool are_level = sliced.summary.mode == "planar" && job.settings.slicing.plane.angle_deg == 0.0;
  if (volumes > 0 && !are_level) sliced.summary.notes.push_back(volumesNote(volumes));
  for (const std::string& note : job.settings.giving_way.notes) sliced.summary.notes.push_back(note);
  if (drawn.maxCoeff() < kSmall) sliced.summary.notes.push_back(smallNote(drawn));
  if (changesSize(job.settings.compensation)) sliced.summary.notes.push_back(sizeNote(drawn, size));
  requireDeposition(sliced.toolpath, job.settings.planning);
  sliced.toolpath = withCopies(std::move(sliced.toolpath), job.settings.copies, space, sliced.bed_from_part,
                               job.settings.planning.travel.feed_mm_s);
  addToolpath(sliced.summary, sliced.toolpath);
  try {
    requireWithin(space, job, sliced);
  } catch (const Unreachable& refusal) {
    rethrowForChoice(refusal, sliced.summary);
  }
  return sliced;
}

}  // namespace lamina
