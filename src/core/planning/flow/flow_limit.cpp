// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/planning/flow/flow.hpp"
#include "planning/flow/path_cut.hpp"
#include "toolpath/deposited_segment.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kSameFlow = 1e-6;  // relative
constexpr double kStep = 0.1;       // of the greatest flow of a ramp
constexpr int kMostSteps = 10;

bool limitFeeds(Path& path, double greatest_mm3_s, double flow_factor) {
  const std::size_t count = std::max(path.feed_mm_s.values().size(), path.bead.values().size());
  std::vector<double> feeds;
  bool is_slowed = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double section = flow_factor * crossSection(path.bead.at(i));
    const double feed = path.feed_mm_s.at(i);
    feeds.push_back(section * feed > greatest_mm3_s ? greatest_mm3_s / section : feed);
    is_slowed = is_slowed || feeds.back() < feed;
  }
  if (is_slowed) path.feed_mm_s = AlongPath<double>(std::move(feeds));
  return is_slowed;
}

/// A motion that deposits: its bead, and how fast.
struct FlowMotion {
  std::size_t path = 0;
  std::size_t motion = 0;
  double section_mm2 = 0.0;
  double volume_mm3 = 0.0;
  double flow_mm3_s = 0.0;
};

/// What happens to a motion: parts of it, each at a feed.
struct FlowPart {
  double until = 1.0;  ///< share of its length
  double feed_mm_s = 0.0;
};

/// A flow that changes evenly in time by a slope s has squares that change evenly with volume, by 2 s. So the
/// squares at the ends of motions are bounded forwards and backwards like squared speeds by an acceleration.
class Ramps {
 public:
  Ramps(std::vector<FlowMotion> motions, double slope) : motions_(std::move(motions)), rise_(2.0 * slope) {
    const std::size_t count = motions_.size();
    ends_.resize(count + 1);
    ends_.front() = square(0);
    ends_.back() = square(count - 1);
    for (std::size_t i = 1; i < count; ++i) ends_[i] = std::min(square(i - 1), square(i));
    for (std::size_t i = 0; i < count; ++i)
      ends_[i + 1] = std::min(ends_[i + 1], ends_[i] + rise_ * motions_[i].volume_mm3);
    for (std::size_t i = count; i-- > 0;)
      ends_[i] = std::min(ends_[i], ends_[i + 1] + rise_ * motions_[i].volume_mm3);
  }

  const std::vector<FlowMotion>& motions() const { return motions_; }

  std::vector<FlowPart> partsOf(std::size_t i) const {
    const FlowMotion& motion = motions_[i];
    const double low = ends_[i];
    const double high = ends_[i + 1];
    const double top = std::min(square(i), 0.5 * (low + high + rise_ * motion.volume_mm3));
    std::vector<FlowPart> parts;
    addRamp(parts, motion, {std::sqrt(low), std::sqrt(top)}, 0.0);
    const double down = 1.0 - std::max(0.0, top - high) / (rise_ * motion.volume_mm3);
    const double up = parts.empty() ? 0.0 : parts.back().until;
    if (down - up > kSameFlow) parts.push_back({down, std::sqrt(top) / motion.section_mm2});
    addRamp(parts, motion, {std::sqrt(top), std::sqrt(high)}, down);
    parts.back().until = 1.0;
    return parts;
  }

 private:
  struct Change {
    double from;
    double to;
  };

  double square(std::size_t i) const { return motions_[i].flow_mm3_s * motions_[i].flow_mm3_s; }

  void addRamp(std::vector<FlowPart>& parts, const FlowMotion& motion, const Change& flow,
               double from) const {
    const double greatest = std::max(flow.from, flow.to);
    const double change = std::abs(flow.to - flow.from);
    if (change <= kSameFlow * greatest) return;
    const int steps = std::clamp(static_cast<int>(std::ceil(change / (kStep * greatest))), 1, kMostSteps);
    double before = flow.from;
    for (int step = 1; step <= steps; ++step) {
      const double now = flow.from + (flow.to - flow.from) * step / steps;
      from += std::abs(now * now - before * before) / (rise_ * motion.volume_mm3);
      parts.push_back({std::min(from, 1.0), 0.5 * (before + now) / motion.section_mm2});
      before = now;
    }
  }

  std::vector<FlowMotion> motions_;
  std::vector<double> ends_;  ///< squared flow where motions meet
  double rise_;
};

/// The motions of a layer's runs; paths that join are one run.
std::vector<std::vector<FlowMotion>> runsOf(const std::vector<Path>& paths, double flow_factor) {
  std::vector<std::vector<FlowMotion>> runs;
  bool goes_on = false;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const Path& path = paths[p];
    goes_on = goes_on && laysBeads(path);
    if (!laysBeads(path)) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const double section = flow_factor * crossSection(path.bead.at(end));
      const double volume = section * motionLength(path, m);
      if (volume <= 0.0) {
        goes_on = goes_on && section > 0.0;
        continue;
      }
      if (!std::exchange(goes_on, true)) runs.emplace_back();
      runs.back().push_back({p, m, section, volume, section * path.feed_mm_s.at(end)});
    }
  }
  return runs;
}

bool isSteady(const std::vector<FlowMotion>& run) {
  return std::all_of(run.begin(), run.end(), [&run](const FlowMotion& motion) {
    return std::abs(motion.flow_mm3_s - run.front().flow_mm3_s) <= kSameFlow * run.front().flow_mm3_s;
  });
}

bool isSlowed(const Path& path, const std::vector<std::vector<FlowPart>>& parts) {
  for (std::size_t m = 0; m < parts.size(); ++m) {
    const double feed = path.feed_mm_s.at(path.motionEnd(m));
    for (const FlowPart& part : parts[m])
      if (part.feed_mm_s < (1.0 - kSameFlow) * feed) return true;
  }
  return false;
}

/// A path with its motions parted.
Path parted(const Path& path, const std::vector<std::vector<FlowPart>>& parts) {
  std::vector<CutPlace> places;
  for (std::size_t m = 0; m < parts.size(); ++m)
    for (std::size_t k = 0; k + 1 < parts[m].size(); ++k) places.push_back({m, parts[m][k].until});
  Path made = withWaypoints(path, places);
  std::vector<double> feeds(made.points.size(), path.feed_mm_s.at(0));
  std::size_t motion = 0;
  for (std::size_t m = 0; m < parts.size(); ++m) {
    if (parts[m].empty()) feeds[made.motionEnd(motion++)] = path.feed_mm_s.at(path.motionEnd(m));
    for (const FlowPart& part : parts[m]) feeds[made.motionEnd(motion++)] = part.feed_mm_s;
  }
  made.feed_mm_s = AlongPath<double>(std::move(feeds));
  return made;
}

/// @return number of paths that are slowed down
std::size_t smoothLayer(std::vector<Path>& paths, double slope, double flow_factor) {
  std::vector<std::vector<std::vector<FlowPart>>> parts(paths.size());
  for (std::vector<FlowMotion>& run : runsOf(paths, flow_factor)) {
    if (isSteady(run)) continue;
    const Ramps ramps(std::move(run), slope);
    for (std::size_t i = 0; i < ramps.motions().size(); ++i) {
      const FlowMotion& motion = ramps.motions()[i];
      std::vector<std::vector<FlowPart>>& of_path = parts[motion.path];
      if (of_path.empty()) of_path.resize(paths[motion.path].motionCount());
      of_path[motion.motion] = ramps.partsOf(i);
    }
  }
  std::size_t slowed = 0;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (!isSlowed(paths[p], parts[p])) continue;
    paths[p] = parted(paths[p], parts[p]);
    ++slowed;
  }
  return slowed;
}

}  // namespace

std::size_t limitFlow(Toolpath& toolpath, const FlowSettings& settings, double flow_factor,
                      Progress& progress) {
  const double greatest = settings.greatest_mm3_s;
  const double slope = settings.greatest_slope_mm3_s2;
  if (greatest == 0.0 && slope == 0.0) return 0;
  std::vector<std::size_t> slowed(toolpath.layers.size(), 0);
  const auto limit = [&](std::size_t l) {
    std::vector<Path>& paths = toolpath.layers[l].paths;
    if (greatest > 0.0)
      for (Path& path : paths)
        if (laysBeads(path) && limitFeeds(path, greatest, flow_factor)) ++slowed[l];
    if (slope > 0.0) slowed[l] += smoothLayer(paths, slope, flow_factor);
  };
  parallelFor(slowed.size(), limit, progress, "flow");
  return std::accumulate(slowed.begin(), slowed.end(), std::size_t{0});
}

}  // namespace lamina
