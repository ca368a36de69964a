// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/modes/head_stages.hpp"
#include "job/modes/part_planning.hpp"
#include "job/modes/travels_over_part.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/slicing/multi_direction/directed_pieces.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "planning/lift/held_along.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

std::string noteOnPieces(const DirectedPieces& found, double max_overhang_deg) {
  char text[320];
  std::snprintf(
      text, sizeof text,
      "%zu pieces; %.2f %% of the surface (%.4g mm²) overhangs its own layers by more than %.4g deg; "
      "as one piece: %.2f %% (%.4g mm²)",
      found.pieces.size(), 100.0 * found.unsupported() / found.surface_mm2, found.unsupported(),
      max_overhang_deg, 100.0 * found.unsupported_level_mm2 / found.surface_mm2, found.unsupported_level_mm2);
  return text;
}

std::string noteOnPiece(const DirectedPieces& found, std::size_t piece) {
  const DirectedPiece& directed = found.pieces[piece];
  char text[240];
  std::snprintf(
      text, sizeof text, "piece %zu follows (%.3f, %.3f, %.3f), %.1f deg from up, from %.3f to %.3f mm",
      piece, directed.up.x(), directed.up.y(), directed.up.z(),
      toDegrees(std::atan2(directed.up.head<2>().norm(), directed.up.z())), directed.from_mm, directed.to_mm);
  return text;
}

std::string noteOnWays(const TravelsOverPart& travels) {
  char text[200];
  std::snprintf(text, sizeof text,
                "%zu of %zu travels are led round the part, for %zu no clear way was found",
                travels.led_round, travels.travels, travels.shut);
  return text;
}

/// Pieces after the first lie on what is printed: what makes a first layer stick to the bed is not for them.
PlanSettings settingsFor(std::size_t piece, PlanSettings settings) {
  if (piece > 0) settings.first_layer = {};
  return settings;
}

Path wayTo(const Path& to, const Path& from, const TravelSettings& settings) {
  Path way;
  way.role = PathRole::Travel;
  way.points = {from.lastPoint(), to.firstPoint()};
  const std::size_t last = from.is_closed ? 0 : from.points.size() - 1;
  way.orientation = heldAlong({from.orientation.at(last), to.orientation.at(0)});
  way.feed_mm_s = AlongPath<double>(settings.feed_mm_s);
  way.process.is_retracted = true;
  way.tool = to.tool;
  return way;
}

void addCounts(LayerCounts& counts, const LayerCounts& further) {
  counts.layers += further.layers;
  counts.contours += further.contours;
  counts.open_contours += further.open_contours;
  counts.sliced_volume_mm3 += further.sliced_volume_mm3;
}

/// Pieces one after another, in the part frame.
class PieceByPiece {
 public:
  PieceByPiece(const PlanningRequest& request, const DirectedPieces& found)
      : request_(request), found_(found) {
    planned_.plan.toolpath.part_name = request.partName();
  }

  void add(std::size_t piece, const std::vector<Layer>& layers, Progress& progress) {
    const DirectedPiece& directed = found_.pieces[piece];
    leaveOutEmptyTop();
    addCounts(planned_.counts, countsOf(layers));
    const LayerIncline incline{{Point3::UnitZ(), directed.from_mm}, Eigen::Quaterniond::Identity()};
    Plan plan = planPart(request_.partName(), layers, settingsFor(piece, request_.job.settings.planning),
                         incline, progress);
    planned_.plan.unprinted_mm3 += plan.unprinted_mm3;
    planned_.plan.left_open += plan.left_open;
    planned_.plan.anchored.moved += plan.anchored.moved;
    planned_.plan.anchored.in_air += plan.anchored.in_air;
    for (const Layer& layer : layers)
      growth_mm_.push_back(found_.growthBefore(piece) + layer.bounds.top_mm - directed.from_mm);
    append(turned(std::move(plan.toolpath), directed.partFromPiece()));
  }

  /// Growth once each layer is printed.
  const std::vector<double>& growth() const { return growth_mm_; }
  PlannedPart& planned() { return planned_; }

 private:
  /// Layers in which a piece is too thin for a bead, as at a corner in which it ends: the next piece does not
  /// lie on them.
  void leaveOutEmptyTop() {
    std::vector<ToolpathLayer>& layers = planned_.plan.toolpath.layers;
    const auto deposits = [](const Path& path) { return path.role != PathRole::Travel; };
    while (!layers.empty() &&
           std::none_of(layers.back().paths.begin(), layers.back().paths.end(), deposits)) {
      layers.pop_back();
      growth_mm_.pop_back();
      --planned_.counts.layers;
    }
  }

  void append(Toolpath further) {
    Toolpath& toolpath = planned_.plan.toolpath;
    for (ToolpathLayer& layer : further.layers) {
      for (const Path& path : layer.paths)
        if (path.role != PathRole::Travel)
          for (const Point3& tip : path.points) highest_mm_ = std::max(highest_mm_, tip.z());
      layer.z_mm = std::max(highest_mm_, toolpath.layers.empty() ? layer.z_mm : toolpath.layers.back().z_mm);
      const Path* last = lastPath(toolpath);
      const bool is_apart = last != nullptr && !layer.paths.empty() &&
                            (last->lastPoint() - layer.paths.front().firstPoint()).norm() > 1e-6;
      if (is_apart)
        layer.paths.insert(layer.paths.begin(),
                           wayTo(layer.paths.front(), *last, request_.job.settings.planning.travel));
      toolpath.layers.push_back(std::move(layer));
    }
  }

  const PlanningRequest& request_;
  const DirectedPieces& found_;
  PlannedPart planned_;
  std::vector<double> growth_mm_;
  double highest_mm_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

PlannedPart planMultiDirection(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  DirectionRequest asked{settings.directions, settings.slicing, settings.planning.bead.width_mm, {}};
  if (canTurnToolAxis(request.space)) asked.head = headStages(settings.machine);
  const DirectedPieces found = directedPieces(source.mesh, source.topology, asked, progress);
  PieceByPiece pieces(request, found);
  const double slice_s = laps.lap();
  for (std::size_t i = 0; i < found.pieces.size(); ++i)
    pieces.add(i, layersOf(found, i, source.mesh, settings.slicing, progress), progress);
  source = {};
  PlannedPart planned = std::move(pieces.planned());
  const TravelsOverPart travels = leadTravels(planned.plan.toolpath, pieces.growth(), *found.room,
                                              settings.planning.travel.hop_mm, progress);
  planned.counts.slice_s = slice_s;
  planned.support = SupportMeasures{found.unsupported(), found.pieces.size(), found.hanging};
  planned.notes.push_back(noteOnPieces(found, settings.directions.max_overhang_deg));
  for (std::size_t i = 1; i < found.pieces.size(); ++i) planned.notes.push_back(noteOnPiece(found, i));
  planned.notes.push_back(noteOnWays(travels));
  return planned;
}

}  // namespace lamina
