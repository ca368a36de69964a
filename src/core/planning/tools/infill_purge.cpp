// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/infill_purge.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace lamina {
namespace {

bool isHiddenInfill(const Path& path) { return path.role == PathRole::Infill; }

bool isInfillAlone(const ToolRun& run) {
  return std::all_of(run.paths.begin(), run.paths.end(),
                     [](const Path& path) { return path.role == PathRole::Travel || isHiddenInfill(path); });
}

/// Behind the infill that a run begins with, as a number of its paths.
std::size_t endOfLeadingInfill(const ToolRun& run) {
  std::size_t end = 0;
  for (std::size_t p = 0; p < run.paths.size(); ++p) {
    if (run.paths[p].role == PathRole::Travel) continue;
    if (!isHiddenInfill(run.paths[p])) break;
    end = p + 1;
  }
  return end;
}

/// The ways that led to what comes no more: on plates a wipe and a travel.
void dropLastTravels(std::vector<Path>& paths) {
  while (!paths.empty() && paths.back().role == PathRole::Travel) paths.pop_back();
}

/// Infill that is gathered from runs until it holds a volume.
class GatheredInfill {
 public:
  explicit GatheredInfill(double volume_mm3) : missing_mm3_(volume_mm3) {}

  /// @return the run without what it gave, and without the travels that led to or from that
  ToolRun gatheredFrom(ToolRun run) {
    const auto purging_end = run.paths.begin() + static_cast<std::ptrdiff_t>(run.purging);
    std::vector<Path> rest(std::make_move_iterator(run.paths.begin()), std::make_move_iterator(purging_end));
    bool follows_gathered = false;
    for (auto path = purging_end; path != run.paths.end(); ++path) {
      const bool is_travel = path->role == PathRole::Travel;
      if (isHiddenInfill(*path) && missing_mm3_ > 0.0) {
        missing_mm3_ -= depositedVolume(*path);
        dropLastTravels(rest);
        paths_.push_back(std::move(*path));
        follows_gathered = true;
        continue;
      }
      if (!is_travel || !follows_gathered) rest.push_back(std::move(*path));
      follows_gathered = follows_gathered && is_travel;
    }
    dropLastTravels(rest);
    run.paths = std::move(rest);
    return run;
  }

  /// In front of what a run has left.
  ToolRun depositedFirst(ToolRun run) && {
    for (Path& path : paths_) path.tool = run.tool;
    paths_.insert(paths_.end(), std::make_move_iterator(run.paths.begin()),
                  std::make_move_iterator(run.paths.end()));
    run.paths = std::move(paths_);
    run.purging = endOfLeadingInfill(run);
    return run;
  }

 private:
  double missing_mm3_;
  std::vector<Path> paths_;
};

}  // namespace

ToolRuns withInfillFirst(ToolRuns runs, std::size_t purged, double volume_mm3) {
  GatheredInfill infill(volume_mm3);
  runs[purged] = infill.gatheredFrom(std::move(runs[purged]));
  for (std::size_t r = purged; r-- > 0;)
    if (!isInfillAlone(runs[r])) runs[r] = infill.gatheredFrom(std::move(runs[r]));
  runs[purged] = std::move(infill).depositedFirst(std::move(runs[purged]));
  return runs;
}

double leadingInfill(const ToolRun& run) {
  const std::size_t end = endOfLeadingInfill(run);
  double sum_mm3 = 0.0;
  for (std::size_t p = 0; p < end; ++p)
    if (run.paths[p].role != PathRole::Travel) sum_mm3 += depositedVolume(run.paths[p]);
  return sum_mm3;
}

}  // namespace lamina
