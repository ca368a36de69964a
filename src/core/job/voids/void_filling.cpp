// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/void_filling.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "job/voids/part_placing.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/voids/void_job.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "lamina/program/gcode/run_insertion.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/voids/beads/open_infill.hpp"
#include "planning/order/ordering.hpp"
#include "planning/run_path.hpp"

namespace lamina {
namespace {

/// Of the deposit; narrow parts and rounding lay a little beside the contour, supports more.
constexpr double kMostOutside = 0.2;
/// Of the covered share of everything.
constexpr double kLeastBorder = 0.7;
/// Of the area of a layer's box.
constexpr double kLeastBox = 0.5;
/// The border is looked at on so many layers.
constexpr std::size_t kPlausibleLayers = 6;

[[noreturn]] void refuse(const VoidReport& report, const VoidJob& job, const std::string& figures) {
  char place[80];
  std::snprintf(place, sizeof place, "%.3f, %.3f mm", report.part.offset.x(), report.part.offset.y());
  throw InvalidInput("part '" + job.part + "' placed at " + place +
                     " does not belong to the program: " + figures + "; check part and offset");
}

std::string percentText(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
  return text;
}

double outsideShare(const VoidReport& report) {
  double outside = 0.0;
  double deposited = 0.0;
  for (const LayerVoids& layer : report.layers) {
    outside += layer.outside_mm2;
    deposited += layer.deposited_mm2;
  }
  return deposited > 0.0 ? outside / deposited : 0.0;
}

struct Coverage {
  double area_mm2 = 0.0;
  double uncovered_mm2 = 0.0;

  void add(const LayerVoids& layer) {
    area_mm2 += layer.area_mm2;
    uncovered_mm2 += layer.uncovered_mm2;
  }
  double share() const { return area_mm2 > 0.0 ? 1.0 - uncovered_mm2 / area_mm2 : 1.0; }
};

void requireCoveredBorder(const Toolpath& program, const VoidReport& report, const VoidJob& job) {
  Coverage whole;
  Coverage border;
  const std::size_t step = 1 + (report.layers.size() - 1) / kPlausibleLayers;
  for (std::size_t i = 0; i < report.layers.size(); i += step) {
    const LayerVoids& layer = report.layers[i];
    const Regions& contour = report.part.contours[i];
    if (!(layer.pitch_mm > 0.0) || contour.empty()) continue;
    whole.add(layer);
    border.add(findVoids(difference(contour, offset(contour, -layer.pitch_mm)), program.layers[i], job.map));
  }
  if (border.share() < kLeastBorder * whole.share())
    refuse(report, job,
           percentText(border.share()) + " of its border are covered and " + percentText(whole.share()) +
               " of all, expected 70 % as much there at least");
}

void requireSize(const Toolpath& program, const VoidReport& report, const VoidJob& job) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < report.layers.size(); ++i) {
    const Box2 cut = boundingBox(outlines(report.part.contours[i]));
    const Box2 deposited = depositedBox(program.layers[i]);
    if (cut.isEmpty() || deposited.isEmpty()) continue;
    shares.push_back(deposited.size().prod() / cut.size().prod());
  }
  if (shares.empty()) refuse(report, job, "no layer of it has any deposit");
  const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
  std::nth_element(shares.begin(), middle, shares.end());
  if (*middle < kLeastBox)
    refuse(report, job,
           "the deposit of a layer takes " + percentText(*middle) +
               " of the box of the part's layer, expected half at least");
}

/// Refuses what looks like the part of another program, or one at the wrong place: filled, its voids would be
/// runs in the air. At most a fifth of the deposit may lie outside of the part, along the border of the part
/// at least 70 % as much must be covered as everywhere, and the boxes of the deposit must on the median take
/// half the area of those of the part's layers.
/// @throws InvalidInput naming the figures
void requirePlausible(const Toolpath& program, const VoidReport& report, const VoidJob& job) {
  if (report.layers.empty() || job.part.empty()) return;
  const double outside = outsideShare(report);
  if (outside > kMostOutside)
    refuse(report, job,
           percentText(outside) + " of the deposit lies outside of it, expected " +
               percentText(kMostOutside) + " at most");
  requireSize(program, report, job);
  requireCoveredBorder(program, report, job);
}

/// In the order of the shortest travel from where the layer ends.
std::vector<Path> ordered(std::vector<FillPath> runs, const ToolpathLayer& layer, double feed_mm_s) {
  std::vector<RunEnds> ends;
  ends.reserve(runs.size());
  for (const FillPath& run : runs) ends.push_back({run.points.front(), lastPoint(run)});
  const Point2 start =
      layer.paths.empty() ? Point2(Point2::Zero()) : Point2(layer.paths.back().lastPoint().head<2>());
  std::vector<Path> paths;
  for (const OrderedRun& next : orderRuns(ends, start)) {
    FillPath run = std::move(runs[next.run]);
    if (next.is_reversed) run = reversed(std::move(run));
    paths.push_back(
        pathAlong(run, beadsOf(run.width_mm, layer.height_mm, layer.height_mm), layer.z_mm, feed_mm_s));
  }
  return paths;
}

/// As the planner lays infill.
double feedOf(std::size_t layer, const FeedSettings& feed) {
  return layer == 0 ? std::min(feed.infill_mm_s, feed.first_layer_mm_s) : feed.infill_mm_s;
}

InsertionSettings insertionSettings(const JobSettings& settings) {
  InsertionSettings insertion;
  insertion.program = settings.program;
  insertion.travel_feed_mm_s = settings.planning.travel.feed_mm_s;
  insertion.hop_mm = settings.planning.travel.hop_mm;
  insertion.retraction_threshold_mm = settings.planning.travel.retraction_threshold_mm;
  return insertion;
}

void requireWhole(const VoidReport& found, const VoidFillingJob& job) {
  if (found.part.missing.empty()) return;
  throw InvalidInput("'" + job.program + "' lacks " + std::to_string(found.part.missing.size()) +
                     " layers of part '" + job.map.part + "', the lowest with its top at " +
                     numberText(found.part.missing.front().z_mm) + " mm; it has " +
                     std::to_string(found.layers.size()) + ", expected all");
}

double voidArea(const LayerVoids& layer) {
  double sum_mm2 = 0.0;
  for (const Void& each : layer.voids) sum_mm2 += each.area_mm2;
  return sum_mm2;
}

/// What the program reaches, its machine does.
void requireReachable(const std::vector<std::vector<Path>>& runs, const Toolpath& program,
                      const BuildSpace& space) {
  const Box3 reached = depositionBox(program);
  const auto isReached = [&](const Point3& point) {
    return (point.array() >= reached.low.array()).all() && (point.array() <= reached.high.array()).all();
  };
  Toolpath beyond;
  beyond.part_name = program.part_name;
  for (const std::vector<Path>& layer : runs) {
    beyond.layers.emplace_back();
    for (const Path& path : layer)
      if (!std::all_of(path.points.begin(), path.points.end(), isReached))
        beyond.layers.back().paths.push_back(path);
  }
  requireReachable(beyond, Eigen::Isometry3d::Identity(), space);
}

}  // namespace

VoidFillingReport runVoidFillingJob(const VoidFillingJob& job, Progress& progress) {
  requireSuffix(job.output, {".gcode"});
  requireApart({job.output}, {job.program, job.map.part});
  const JobSettings& settings = job.map.settings;
  const std::string text = readTextFile(job.program);
  const Toolpath program = toolpathFromGcode(text, settings.program, job.program);
  const BuildSpace space = buildSpaceOf(settings.machine);
  VoidReport found = runVoidJob(program, job.map, progress);
  requirePlausible(program, found, job.map);
  requireWhole(found, job);
  std::vector<std::vector<Path>> runs(program.layers.size());
  std::vector<double> open_mm2(program.layers.size());
  parallelFor(
      runs.size(),
      [&](std::size_t i) {
        const LayerVoids& all = found.layers[i];
        const LayerVoids voids =
            withoutOpenInfill(all, found.part.contours[i], program.layers[i], job.map.map);
        open_mm2[i] = voidArea(all) - voidArea(voids);
        runs[i] = ordered(refill(voids, job.refill), program.layers[i], feedOf(i, settings.planning.feed));
      },
      progress, "fill");
  requireReachable(runs, program, space);
  const std::string filled = insertRuns(text, program, runs, insertionSettings(settings));
  VoidFillingReport report;
  for (std::size_t i = 0; i < runs.size(); ++i) report.open_mm3 += open_mm2[i] * program.layers[i].height_mm;
  for (const std::vector<Path>& layer : runs) {
    report.runs += layer.size();
    report.layers += layer.empty() ? 0 : 1;
    for (const Path& path : layer) report.deposited_mm3 += depositedVolume(path);
  }
  report.before = totals(found.layers);
  const Toolpath result = toolpathFromGcode(filled, settings.program, job.program);
  report.after = totals(findVoids(found.part.contours, result, job.map.map, progress));
  report.found = std::move(found.layers);
  if (!job.output.empty()) writeFile(job.output, filled);
  return report;
}

}  // namespace lamina
