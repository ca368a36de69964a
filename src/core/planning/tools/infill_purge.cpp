// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/infill_purge.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lamina {
namespace {

bool isHiddenInfill(const Path& path) { return path.role == PathRole::Infill; }

bool isInfillAlone(const ToolRun& run) {
  return std::all_of(run.paths.begin(), run.paths.end(),
                     [](const Path& path) { return path.role == PathRole::Travel || isHiddenInfill(path); });
}

/// Paths that are taken out of runs until they hold a volume.
class TakenInfill {
 public:
  explicit TakenInfill(double volume_mm3) : missing_mm3_(volume_mm3) {}

  /// @return the run without them, and without the travels that led to or from them
  ToolRun takenFrom(ToolRun run) {
    std::vector<Path> rest;
    bool follows_taken = false;
    for (Path& path : run.paths) {
      const bool is_travel = path.role == PathRole::Travel;
      if (isHiddenInfill(path) && missing_mm3_ > 0.0) {
        missing_mm3_ -= depositedVolume(path);
        if (!rest.empty() && rest.back().role == PathRole::Travel) rest.pop_back();
        taken_.push_back(std::move(path));
        follows_taken = true;
        continue;
      }
      if (!is_travel || !follows_taken) rest.push_back(std::move(path));
      follows_taken = follows_taken && is_travel;
    }
    if (!rest.empty() && rest.back().role == PathRole::Travel) rest.pop_back();
    run.paths = std::move(rest);
    return run;
  }

  /// In front of what a run has left.
  ToolRun laidFirst(ToolRun run) && {
    for (Path& path : taken_) path.tool = run.tool;
    taken_.insert(taken_.end(), std::make_move_iterator(run.paths.begin()),
                  std::make_move_iterator(run.paths.end()));
    run.paths = std::move(taken_);
    return run;
  }

 private:
  double missing_mm3_;
  std::vector<Path> taken_;
};

}  // namespace

ToolRuns withInfillFirst(ToolRuns runs, std::size_t taken, double volume_mm3) {
  TakenInfill infill(volume_mm3);
  runs[taken] = infill.takenFrom(std::move(runs[taken]));
  for (std::size_t r = taken; r-- > 0;)
    if (!isInfillAlone(runs[r])) runs[r] = infill.takenFrom(std::move(runs[r]));
  runs[taken] = std::move(infill).laidFirst(std::move(runs[taken]));
  return runs;
}

double leadingInfill(const ToolRun& run) {
  double sum_mm3 = 0.0;
  for (const Path& path : run.paths) {
    if (path.role == PathRole::Travel) continue;
    if (!isHiddenInfill(path)) break;
    sum_mm3 += depositedVolume(path);
  }
  return sum_mm3;
}

}  // namespace lamina
