// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/void_filling.hpp"

#include <algorithm>
#include <utility>

#include "job/voids/plausible_part.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/program/gcode/run_insertion.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "planning/order/ordering.hpp"
#include "planning/run_path.hpp"

namespace lamina {
namespace {

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
                     std::to_string(found.part.missing.front().z_mm) + " mm; it has " +
                     std::to_string(found.layers.size()) + ", expected all");
}

/// What the program reaches, its machine does.
void requireReachable(const std::vector<std::vector<Path>>& runs, const Toolpath& program,
                      const CartesianMachine& machine) {
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
  requireReachable(beyond, Eigen::Isometry3d::Identity(), machine);
}

}  // namespace

VoidFillingReport runVoidFillingJob(const VoidFillingJob& job, Progress& progress) {
  requireSuffix(job.output, {".gcode"});
  requireApart({job.output}, {job.program, job.map.part});
  const JobSettings& settings = job.map.settings;
  const std::string text = readFile(job.program);
  const Toolpath program = toolpathFromGcode(text, settings.program, job.program);
  const CartesianMachine machine = machineOf(settings.machine);
  VoidReport found = runVoidJob(program, job.map, progress);
  requirePlausible(program, found, job.map);
  requireWhole(found, job);
  std::vector<std::vector<Path>> runs(program.layers.size());
  parallelFor(
      runs.size(),
      [&](std::size_t i) {
        runs[i] = ordered(refill(found.layers[i], job.refill), program.layers[i],
                          feedOf(i, settings.planning.feed));
      },
      progress, "fill");
  requireReachable(runs, program, machine);
  const std::string filled = insertRuns(text, program, runs, insertionSettings(settings));
  VoidFillingReport report;
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
