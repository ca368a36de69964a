// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/skeleton_beads.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/variable_width/axis_steps.hpp"

namespace lamina {
namespace {

/// Along a run, widths change by steps of this at most, in pitches.
constexpr double kBeadWidthStep = 0.1;
/// A skeleton path that branches off another starts this far from the middle of that, in radii there, and a
/// lane that begins beside a bead this far from where that ends, in radii of its own: its round end then
/// overlaps the other bead about as much as its corners leave open.
constexpr double kBesideBranch = 0.75;
/// Of its first motion a lane keeps this part.
constexpr double kShortestStart = 0.05;
/// What is longer across than along gets a short bead of this half length and this width, in radii.
constexpr double kDotReach = 0.25;
constexpr double kDotWidth = 1.5;
constexpr double kSteepestMitre = 1.5;
/// A short section of a skeleton path may take the number of lanes beside it while the lanes stay within this
/// part of the widest bead; they are then no wider than that bead all the same.
constexpr double kTolerated = 1.25;
/// Corners of a round loop.
constexpr int kRoundCorners = 12;

double lengthOf(const std::vector<AxisPoint>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i].point - points[i - 1].point).norm();
  return sum;
}

/// The line from where it first leaves the disc round its start.
std::vector<AxisPoint> withoutStart(std::vector<AxisPoint> points, double radius) {
  const Point2 centre = points.front().point;
  std::size_t i = 1;
  while (i < points.size() && (points[i].point - centre).norm() <= radius) ++i;
  if (i == points.size()) return {};
  const Point2 from = points[i - 1].point - centre;
  const Point2 along = points[i].point - points[i - 1].point;
  const double b = from.dot(along) / along.squaredNorm();
  const double c = (from.squaredNorm() - radius * radius) / along.squaredNorm();
  const double t = -b + std::sqrt(std::max(0.0, b * b - c));
  points[i - 1] = between(points[i - 1], points[i], std::clamp(t, 0.0, 1.0));
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i - 1));
  return points;
}

std::vector<AxisPoint> withoutBranchEnds(const SkeletonPath& skeleton_path) {
  std::vector<AxisPoint> points = skeleton_path.points;
  if (skeleton_path.is_closed) return points;
  const bool cuts[2] = {skeleton_path.start == SkeletonPathEnd::Branch,
                        skeleton_path.end == SkeletonPathEnd::Branch};
  for (const bool is_cut : cuts) {
    if (is_cut && !points.empty()) {
      const double radius = kBesideBranch * points.front().radius_mm;
      points = withoutStart(std::move(points), radius);
    }
    std::reverse(points.begin(), points.end());
  }
  return points;
}

FillPath roundLoop(const Point2& centre, double radius, double width) {
  FillPath run;
  run.role = PathRole::GapFill;
  run.is_closed = true;
  for (int k = 0; k < kRoundCorners; ++k) {
    const double angle = 2.0 * M_PI * k / kRoundCorners;
    run.points.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  run.width_mm.assign(run.points.size(), width);
  return run;
}

/// What is about as long as wide and too wide for one bead: loops round its middle.
std::vector<FillPath> roundLoops(const AxisPoint& middle, double pitch) {
  const int count = std::max(1, static_cast<int>(std::round(middle.radius_mm / pitch)));
  const double width = middle.radius_mm / count;
  std::vector<FillPath> loops;
  for (int k = count; k-- > 0;) loops.push_back(roundLoop(middle.point, (k + 0.5) * width, width));
  return loops;
}

FillPath dot(const AxisPoint& at) {
  FillPath run;
  run.role = PathRole::GapFill;
  const Point2 half(kDotReach * at.radius_mm, 0.0);
  run.points = {at.point - half, at.point + half};
  run.width_mm.assign(2, kDotWidth * at.radius_mm);
  return run;
}

/// Lines side by side along an axis: segment i of the axis has count_[i] of them.
class Lanes {
 public:
  Lanes(std::vector<AxisPoint> points, const SkeletonPath& skeleton_path, const MedialBeadSettings& settings)
      : points_(std::move(points)),
        is_closed_(skeleton_path.is_closed),
        widest_(settings.widest_bead * settings.pitch_mm) {
    if (is_closed_) points_.push_back(points_.front());
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const double thickness = points_[i].radius_mm + points_[i + 1].radius_mm;
      const double count = std::ceil(thickness / settings.pitch_mm - settings.widest_bead + 1.0 - 1e-9);
      count_.push_back(std::max(1, static_cast<int>(count)));
    }
    dissolveShortSections();
    if (!is_closed_ && skeleton_path.start == SkeletonPathEnd::Tip) prolong(1, 0, count_.front());
    if (!is_closed_ && skeleton_path.end == SkeletonPathEnd::Tip)
      prolong(points_.size() - 2, points_.size() - 1, count_.back());
    findNormals();
  }

  std::vector<FillPath> runs() const {
    std::vector<FillPath> runs = {lane(0, 0, count_.size())};
    runs.front().is_closed = is_closed_;
    const int most = *std::max_element(count_.begin(), count_.end());
    for (int k = 1; k < most; ++k) addExtraLanes(k, runs);
    if (is_closed_)
      for (FillPath& run : runs) closeUp(run);
    return runs;
  }

 private:
  double segmentLength(std::size_t i) const { return (points_[i + 1].point - points_[i].point).norm(); }

  /// A change of count for less than the thickness costs more than it gives.
  void dissolveShortSections() {
    std::size_t begin = 0;
    while (begin < count_.size()) {
      std::size_t end = begin;
      double length = 0.0;
      while (end < count_.size() && count_[end] == count_[begin]) length += segmentLength(end++);
      const bool is_short = length < 2.0 * points_[begin].radius_mm && end - begin < count_.size();
      const int neighbour = begin > 0 ? count_[begin - 1] : end < count_.size() ? count_[end] : count_[begin];
      if (is_short && hasRoom(begin, end, neighbour)) {
        std::fill(count_.begin() + static_cast<std::ptrdiff_t>(begin),
                  count_.begin() + static_cast<std::ptrdiff_t>(end), neighbour);
      }
      begin = end;
    }
  }

  /// Whether so many lanes are not too wide for these segments.
  bool hasRoom(std::size_t begin, std::size_t end, int lanes) const {
    for (std::size_t i = begin; i < end; ++i)
      if (points_[i].radius_mm + points_[i + 1].radius_mm > kTolerated * widest_ * lanes) return false;
    return true;
  }

  /// Narrower beads end nearer to the border than the axis does.
  void prolong(std::size_t from, std::size_t tip, int count) {
    const Point2 along = (points_[tip].point - points_[from].point).normalized();
    points_[tip].point += points_[tip].radius_mm * (1.0 - 1.0 / count) * along;
  }

  void findNormals() {
    const std::size_t count = points_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = i > 0 ? i - 1 : is_closed_ ? count - 2 : 0;
      const std::size_t after = i + 1 < count ? i : is_closed_ ? 0 : count - 2;
      const Point2 sum = normalOf(before) + normalOf(after);
      const double squared = sum.squaredNorm();
      const double mitre = std::min(2.0 / squared, kSteepestMitre / std::sqrt(squared));
      normals_.push_back(squared > 1e-12 ? Point2(mitre * sum) : normalOf(after));
      turns_.push_back(cross(normalOf(before), normalOf(after)));
    }
  }

  Point2 normalOf(std::size_t segment) const {
    return leftOf((points_[segment + 1].point - points_[segment].point).normalized());
  }

  /// Within a bend the border may be as near as the radius, so that lanes have no mitre there.
  Point2 lanePoint(std::size_t vertex, std::size_t segment, int k) const {
    const double share = (k - 0.5 * (count_[segment] - 1)) / count_[segment];
    const bool is_within_bend = share * turns_[vertex] > 0.0;
    const Point2 normal = is_within_bend ? Point2(normals_[vertex].normalized()) : normals_[vertex];
    return points_[vertex].point + 2.0 * share * points_[vertex].radius_mm * normal;
  }

  FillPath lane(int k, std::size_t first, std::size_t end) const {
    FillPath run;
    run.role = PathRole::GapFill;
    for (std::size_t i = first; i < end; ++i) {
      const double width = std::min(widest_, (points_[i].radius_mm + points_[i + 1].radius_mm) / count_[i]);
      for (const std::size_t vertex : {i, i + 1}) {
        const Point2 point = lanePoint(vertex, i, k);
        if (!run.points.empty() && (run.points.back() - point).norm() < 1e-6) continue;
        // On the way across, where the number of lanes changes, the bead is no wider than on either side.
        const bool crosses = vertex == i && !run.points.empty();
        run.points.push_back(point);
        run.width_mm.push_back(crosses ? std::min(width, run.width_mm.back()) : width);
      }
    }
    return run;
  }

  void addExtraLanes(int k, std::vector<FillPath>& runs) const {
    std::size_t begin = 0;
    while (begin < count_.size()) {
      std::size_t end = begin;
      while (end < count_.size() && count_[end] > k) ++end;
      if (end > begin) addLane(k, begin, end, runs);
      begin = end + 1;
    }
  }

  /// The second lane goes back where the first one ended.
  void addLane(int k, std::size_t begin, std::size_t end, std::vector<FillPath>& runs) const {
    FillPath run = lane(k, begin, end);
    if (begin > 0 && !run.points.empty()) run = withoutRoundStart(std::move(run));
    if (end < count_.size() && !run.points.empty())
      run = reversed(withoutRoundStart(reversed(std::move(run))));
    const bool is_whole = begin == 0 && end == count_.size();
    run.is_closed = is_closed_ && is_whole;
    if (k == 1 && !is_closed_ && end == count_.size()) {
      append(runs.front(), reversed(std::move(run)));
      runs.front().is_closed = is_whole;
    } else if (k == 1 && !is_closed_ && begin == 0) {
      FillPath joined = reversed(std::move(run));
      append(joined, std::move(runs.front()));
      runs.front() = std::move(joined);
    } else {
      runs.push_back(std::move(run));
    }
  }

  static FillPath withoutRoundStart(FillPath run) {
    if (run.points.size() < 2) return run;
    const Point2 along = run.points[1] - run.points[0];
    const double cut = 0.5 * kBesideBranch * run.width_mm[1];
    run.points[0] += std::min(1.0 - kShortestStart, cut / along.norm()) * along;
    return run;
  }

  static void append(FillPath& run, FillPath&& more) {
    // What joins two lanes is no wider than either.
    if (more.width_mm.size() > 1) more.width_mm.front() = std::min(run.width_mm.back(), more.width_mm[1]);
    run.points.insert(run.points.end(), more.points.begin(), more.points.end());
    run.width_mm.insert(run.width_mm.end(), more.width_mm.begin(), more.width_mm.end());
  }

  static void closeUp(FillPath& run) {
    if (!run.is_closed || (run.points.back() - run.points.front()).norm() > 1e-6) return;
    run.points.pop_back();
    run.width_mm.front() = run.width_mm.back();
    run.width_mm.pop_back();
  }

  std::vector<AxisPoint> points_;
  bool is_closed_;
  double widest_;  ///< [mm]
  std::vector<int> count_;
  std::vector<Point2> normals_;  ///< point by point, as long as neighbouring lines need it
  std::vector<double> turns_;    ///< point by point, above 0 to the left
};

}  // namespace

std::vector<FillPath> skeletonBeads(const SkeletonPath& skeleton_path, const MedialBeadSettings& settings) {
  std::vector<AxisPoint> points = withoutBranchEnds(skeleton_path);
  if (points.empty()) return {};
  const bool branches_off =
      skeleton_path.start == SkeletonPathEnd::Branch || skeleton_path.end == SkeletonPathEnd::Branch;
  if (!skeleton_path.is_closed && branches_off &&
      lengthOf(points) < settings.least_length * settings.pitch_mm)
    return {};
  const AxisPoint widest =
      *std::max_element(points.begin(), points.end(),
                        [](const AxisPoint& a, const AxisPoint& b) { return a.radius_mm < b.radius_mm; });
  if (!skeleton_path.is_closed && lengthOf(points) < 2.0 * kDotReach * widest.radius_mm) {
    const bool is_dot = kDotWidth * widest.radius_mm <= settings.widest_bead * settings.pitch_mm;
    return is_dot ? std::vector<FillPath>{dot(widest)} : roundLoops(widest, settings.pitch_mm);
  }
  if (skeleton_path.is_closed) points.push_back(points.front());
  points = inRadiusSteps(points, 0.5 * kBeadWidthStep * settings.pitch_mm);
  if (skeleton_path.is_closed) points.pop_back();
  return Lanes(std::move(points), skeleton_path, settings).runs();
}

}  // namespace lamina
