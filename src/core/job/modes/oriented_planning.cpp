// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/oriented_planning.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space_vectors.hpp"
#include "job/joint_program.hpp"
#include "job/modes/automatic_planning.hpp"
#include "job/modes/fit/stack_fit.hpp"
#include "job/modes/mode_trial.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "lamina/orientation/orient_toolpath.hpp"
#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

/// One sentence for all runs that a limit changed, with the one that was changed most.
void addLimit(const OrientationReport& report, OrientationLimit limit, std::vector<std::string>& notes) {
  const LimitHit* worst = nullptr;
  std::size_t runs = 0;
  for (const LimitHit& hit : report.limits_hit) {
    if (hit.limit != limit) continue;
    ++runs;
    const bool is_worse = worst == nullptr || std::abs(hit.wanted_deg - hit.given_deg) >
                                                  std::abs(worst->wanted_deg - worst->given_deg);
    if (is_worse) worst = &hit;
  }
  if (worst == nullptr) return;
  char text[256];
  std::snprintf(text, sizeof text,
                "orientation.%s changed %zu runs, most at %s: %.2f deg wanted, %.2f deg given",
                limit == OrientationLimit::Lean ? "max_lean_deg" : "max_turn_deg_per_mm", runs,
                toText(worst->worst).c_str(), worst->wanted_deg, worst->given_deg);
  notes.emplace_back(text);
}

/// Whether the settings hold the nozzle otherwise than the slicer does.
bool changesOrientation(const OrientationSettings& settings) {
  const OrientationSettings as_sliced;
  return settings.mode != OrientationMode::LayerNormal || settings.lead_deg != 0.0 ||
         settings.tilt_deg != 0.0 || settings.smoothing_window != 1 || settings.heading_deg != 0.0 ||
         settings.limits.max_lean_deg != as_sliced.limits.max_lean_deg ||
         settings.limits.max_turn_deg_per_mm != as_sliced.limits.max_turn_deg_per_mm;
}

/// @param as_sliced  empty if nothing was changed
/// @throws InvalidInput if a tool axis was turned by more than `orientation.max_off_normal_deg` from the
/// layer's normal: it names the place; the nozzle would run into what is deposited
void requireNearNormal(const Toolpath& as_sliced, const Toolpath& oriented,
                       const OrientationSettings& settings) {
  const auto tool_axis = [](const Path& path, std::size_t w) {
    return Point3(path.orientation.at(w) * Point3::UnitZ());
  };
  double greatest = 0.0;
  WaypointIndex place;
  for (std::size_t l = 0; l < as_sliced.layers.size(); ++l)
    for (std::size_t p = 0; p < as_sliced.layers[l].paths.size(); ++p) {
      const Path& before = as_sliced.layers[l].paths[p];
      if (before.role == PathRole::Travel) continue;
      for (std::size_t w = 0; w < before.points.size(); ++w) {
        const Point3 normal = tool_axis(before, w);
        const Point3 held = tool_axis(oriented.layers[l].paths[p], w);
        const double angle = toDegrees(angleBetween(normal, held));
        if (angle <= greatest) continue;
        greatest = angle;
        place = {l, p, w};
      }
    }
  if (greatest <= settings.limits.max_off_normal_deg + 1e-6) return;
  char text[256];
  std::snprintf(text, sizeof text,
                "the nozzle would be held %.1f deg off the layer's normal at %s; expected at most %.4g deg "
                "(orientation.max_off_normal_deg): it would run into what is deposited",
                greatest, toText(place).c_str(), settings.limits.max_off_normal_deg);
  throw InvalidInput(text);
}

/// What a user should know of how the nozzle turns, a sentence each: limits that were hit, walls that were
/// not found.
std::vector<std::string> notesOn(const OrientationReport& report) {
  std::vector<std::string> notes;
  addLimit(report, OrientationLimit::Lean, notes);
  addLimit(report, OrientationLimit::Turn, notes);
  if (report.waypoints_without_wall > 0)
    notes.push_back("orientation.mode wall found no wall across the path at " +
                    std::to_string(report.waypoints_without_wall) +
                    " waypoints of walls; their neighbours' tool axes stand there");
  return notes;
}

void addPlanned(SliceSummary& summary, const PlannedPart& planned) {
  summary.notes = planned.notes;
  summary.lean = planned.lean;
  summary.layers = planned.counts.layers;
  summary.contours = planned.counts.contours;
  summary.open_contours = planned.counts.open_contours;
  summary.sliced_volume_mm3 = planned.counts.sliced_volume_mm3;
  summary.slice_s = planned.counts.slice_s;
  summary.unprinted_mm3 = planned.plan.unprinted_mm3;
  summary.refilling = planned.plan.refilling;
  summary.starts = planned.plan.starts;
  summary.anchored = planned.plan.anchored;
  summary.bridging = planned.plan.bridging;
  summary.supports = planned.plan.supports;
  summary.raft_mm = planned.plan.raft_mm;
}

/// Of the sparse infill, if its lines cross.
void addNoteOnCrossings(SliceSummary& summary, const JobSettings& settings) {
  const InfillSettings& infill = settings.planning.infill;
  const double crossing = infillStrategy(infill.strategy).crossing;
  const BeadSettings& bead = settings.planning.bead;
  const double pitch =
      bead.pitch_mm > 0.0 ? bead.pitch_mm : planWidth({bead.width_mm, settings.slicing.layer_height_mm});
  const double density = infill.pitch_mm > 0.0 ? pitch / infill.pitch_mm : infill.density;
  if (crossing * density == 0.0 || density > 1.0 - 1e-6) return;
  char text[128];
  std::snprintf(text, sizeof text, "lines of infill '%s' cross: %.1f %% of its volume is deposited twice",
                infill.strategy.c_str(), 100.0 * crossing * density);
  summary.notes.emplace_back(text);
}

/// Bridges, overhanging walls and what is seen are found from the neighbouring layers, by beads that stay in
/// their layer.
void addNoteOnBridges(SliceSummary& summary, const JobSettings& settings) {
  const PlanSettings& planning = settings.planning;
  if (!planning.bridges.is_used && !planning.overhangs.is_used && !planning.ironing.is_used) return;
  const std::string asked = planning.bridges.is_used     ? "bridges.use"
                            : planning.overhangs.is_used ? "overhangs.use"
                                                         : "ironing.use";
  const InfillStrategy strategy = infillStrategy(planning.infill.strategy);
  if (!hasPlaneLayers(summary.mode))
    summary.notes.push_back(asked + " has no effect: layers of mode '" + summary.mode + "' are not plane");
  else if (strategy.deposit != Deposit::Bead || strategy.link != LayerLink::Travel)
    summary.notes.push_back(asked + " has no effect with infill.strategy '" + planning.infill.strategy + "'");
  else if (planning.bridges.is_used && planning.walls.count == 0 && strategy.contact == WallContact::Beside)
    summary.notes.push_back("bridges.use has no effect with infill.strategy '" + planning.infill.strategy +
                            "' and walls.count 0: threads would cut the rim");
}

/// Of a solid infill in cells, where it leaves more open than others do. Where that of the plan is none,
/// those of regions with settings of their own are meant.
void addNoteOnOpen(SliceSummary& summary, const LeftOpen& open, const std::string& strategy) {
  if (open.open_layers == 0) return;
  const std::string whose =
      infillStrategy(strategy).solid == SolidFit::InCells ? "'" + strategy + "'" : "of regions";
  char text[256];
  std::snprintf(text, sizeof text,
                "cells of solid infill %s do not fit everywhere: %.2f %% of its layers stays open, at most "
                "%.2f %%, in layer %zu; more than %.4g %% in %zu; voids.refill beads fills what beads can, "
                "and infill.strategy contour or zigzag leaves less",
                whose.c_str(), 100.0 * open.open_mm2 / open.area_mm2, open.worst_percent, open.worst_layer,
                kMostOpenPercent, open.open_layers);
  summary.notes.emplace_back(text);
}

void addNoteOnUnchecked(SliceSummary& summary, const Toolpath& oriented, const PlanningRequest& request) {
  constexpr double kTurned = toRadians(0.01);
  if (!canTurnToolAxis(request.space) ||
      greatestToolAxisTurn(oriented, request.bed_from_part, request.space) <= kTurned)
    return;
  std::string note = noteOnUnchecked(request.job, summary.mode);
  if (!note.empty()) summary.notes.push_back(std::move(note));
}

/// @throws Unreachable as `fitStack`, with what to try
Toolpath fitted(Toolpath planned, double standing_mm, const PlanningRequest& request, SliceSummary& summary,
                Progress& progress) {
  try {
    StackFit fit = fitStack(std::move(planned), standing_mm, request, progress);
    for (std::string& note : fit.notes) summary.notes.push_back(std::move(note));
    return std::move(fit.toolpath);
  } catch (const Unreachable& refusal) {
    rethrowForChoice(Unreachable(refusal.what() + remediesFor(request.job, summary.mode)), summary);
  }
}

bool needsPart(const JobSettings& settings) {
  return !hasPlaneLayers(settings.slicing.mode) || settings.orientation.mode == OrientationMode::Wall;
}

}  // namespace

Toolpath planOriented(SourcePart source, const PlanningRequest& request, SliceSummary& summary,
                      Progress& progress) {
  const JobSettings& settings = request.job.settings;
  const Mesh part = needsPart(settings) ? source.mesh : Mesh();
  summary.mode = settings.slicing.mode;
  PlannedPart planned = settings.slicing.mode == kAutoMode
                            ? planAutomatically(source, request, summary, progress)
                            : planShown(std::move(source), settings.slicing.mode, request, progress);
  addPlanned(summary, planned);
  addNoteOnCrossings(summary, settings);
  addNoteOnBridges(summary, settings);
  addNoteOnOpen(summary, planned.plan.left_open, settings.planning.infill.strategy);
  if (hasPlaneLayers(summary.mode) && !changesOrientation(settings.orientation))
    return std::move(planned.plan.toolpath);
  const Toolpath as_sliced = changesOrientation(settings.orientation) ? planned.plan.toolpath : Toolpath();
  OrientedToolpath oriented =
      orientToolpath(std::move(planned.plan.toolpath), settings.orientation, part, progress);
  requireNearNormal(as_sliced, oriented.toolpath, settings.orientation);
  summary.orientation = oriented.report;
  for (std::string& note : notesOn(oriented.report)) summary.notes.push_back(std::move(note));
  const bool is_checked = planned.is_fitted && !changesOrientation(settings.orientation);
  if (!is_checked) addNoteOnUnchecked(summary, oriented.toolpath, request);
  if (!hasPlaneLayers(summary.mode) && !is_checked) {
    oriented.toolpath = fitted(std::move(oriented.toolpath), planned.standing_mm, request, summary, progress);
  }
  if (!part.triangles.empty())
    summary.lean = overhangAngle(part, oriented.toolpath, settings.planning.bead.width_mm);
  return std::move(oriented.toolpath);
}

void requireWithin(const BuildSpace& space, const SliceJob& job, SlicedPart& sliced) {
  const bool is_five_axis = writesFiveAxis(job, space, sliced);
  const bool is_program = isGcodeFile(job.output) && !is_five_axis;
  const bool is_as_planned =
      hasPlaneLayers(sliced.summary.mode) && !changesOrientation(job.settings.orientation);
  if (is_program || (is_as_planned && !is_five_axis))
    return requireReachable(sliced.toolpath, sliced.bed_from_part, space,
                            toolOffsets(job.settings.planning.tools));
  if (!is_five_axis) requireTipsReachable(sliced.toolpath, sliced.bed_from_part, space);
  const double turn_deg = toDegrees(greatestToolAxisTurn(sliced.toolpath, sliced.bed_from_part, space));
  if (turn_deg < 0.01) return;
  const char* format = canTurnToolAxis(space)
                           ? "the nozzle turns by up to %.1f deg, which takes the rotary joints of %s"
                           : "the nozzle turns by up to %.1f deg from how %s holds it: poses for a head that "
                             "can; a program for this one is refused";
  char text[256];
  std::snprintf(text, sizeof text, format, turn_deg, space.name.c_str());
  sliced.summary.notes.emplace_back(text);
}

}  // namespace lamina
