// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/top_completion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/curves_between.hpp"
#include "slicing/adapted/mesh_region.hpp"

namespace lamina {
namespace {

constexpr double kTopRounding = 1e-6;  // of a height

/// Points of the highest contour, taken round it: the first and how many.
struct PointRun {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Maximal runs of points that are set; all of them are a run from point 0.
std::vector<PointRun> runsOf(const std::vector<bool>& is_set) {
  const std::size_t count = is_set.size();
  if (std::find(is_set.begin(), is_set.end(), false) == is_set.end()) return {{0, count}};
  std::vector<PointRun> runs;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_set[i] || is_set[(i + count - 1) % count]) continue;
    PointRun run{i, 1};
    while (is_set[(i + run.count) % count]) ++run.count;
    runs.push_back(run);
  }
  return runs;
}

void appendPiece(AdaptedCurve& curve, const GrownPoint& grown) {
  curve.points.push_back(grown.point);
  curve.axis.push_back(grown.axis);
  curve.height_mm.push_back(grown.height_mm);
}

class TopCompletion {
 public:
  TopCompletion(const Mesh& mesh, const WallStrand& strand, const Growth& growth,
                std::unique_ptr<PlacedCurve> last)
      : mesh_(mesh),
        growth_(growth),
        level_(strand.levels.size() - 1),
        top_(strand.levels.back().points),
        front_of_(top_.size(), 0),
        grown_(top_.size()) {
    fronts_.push_back(std::move(last));
  }

  /// Layers of one step, as long as there is room for it anywhere.
  std::vector<AdaptedLayer> layersOf(const GrowthStep& step) {
    std::vector<AdaptedLayer> layers;
    std::vector<bool> is_active(top_.size(), true);
    const std::size_t most = mostSteps(step.height_mm);
    // Layers that are divided must have room for all parts; of others half a height must be left.
    const double least_mm = step.parts > 1 ? step.height_mm * (1.0 - kTopRounding) : 0.5 * step.height_mm;
    for (std::size_t taken = 0; grow(is_active, step.height_mm, least_mm); ++taken) {
      if (taken == most) refuse(taken);
      const std::vector<PointRun> runs = runsOf(is_active);
      std::vector<AdaptedLayer> divided(step.parts);
      const std::vector<GrownPoint> standing = standingPoints();
      for (const PointRun& run : runs) addCurve(run, step, divided);
      if (!divided.back().curves.front().is_closed)
        for (AdaptedLayer& layer : divided) layer.outlines = {outlineOf(layer.curves, runs, standing)};
      std::move(divided.begin(), divided.end(), std::back_inserter(layers));
    }
    return layers;
  }

 private:
  /// Whether any point is still active: as far from the curve below it as the least height.
  bool grow(std::vector<bool>& is_active, double height_mm, double least_mm) {
    bool is_any = false;
    for (std::size_t i = 0; i < top_.size(); ++i) {
      if (!is_active[i]) continue;
      grown_[i] = growth_.towards(level_, i, *fronts_[front_of_[i]], height_mm);
      is_active[i] = !grown_[i].is_reached || grown_[i].height_mm >= least_mm;
      is_any = is_any || is_active[i];
    }
    return is_any;
  }

  void addCurve(const PointRun& run, const GrowthStep& step, std::vector<AdaptedLayer>& divided) {
    const std::size_t count = top_.size();
    const std::size_t below = front_of_[run.first];
    const bool is_closed = run.count == count;
    std::vector<GrownPoint> points;
    const auto appendReached = [&](std::size_t i) {
      points.push_back(growth_.towards(level_, i, *fronts_[below], step.height_mm));
    };
    if (!is_closed) appendReached((run.first + count - 1) % count);
    for (std::size_t k = 0; k < run.count; ++k) points.push_back(grown_[(run.first + k) % count]);
    if (!is_closed) appendReached((run.first + run.count) % count);
    AdaptedCurve curve = curveThrough(points, is_closed, *fronts_[below]);
    std::vector<AdaptedCurve> parts = curvesBetween(*fronts_[below], curve, step.parts);
    for (std::size_t part = 0; part < parts.size(); ++part)
      divided[part].curves.push_back(std::move(parts[part]));
    for (std::size_t k = 0; k < run.count; ++k) front_of_[(run.first + k) % count] = fronts_.size();
    fronts_.push_back(std::make_unique<PlacedCurve>(std::move(curve)));
  }

  /// For each point of the top where the wall stands that is to reach it.
  std::vector<GrownPoint> standingPoints() const {
    std::vector<GrownPoint> standing(top_.size());
    for (std::size_t i = 0; i < top_.size(); ++i) {
      const PlacedCurve& front = *fronts_[front_of_[i]];
      const CurvePlace foot = front.places.nearest(top_[i]);
      standing[i].point = foot.point;
      standing[i].axis = directionAt(front.curve.axis, foot);
    }
    return standing;
  }

  /// Open curves of a layer, one per run, joined by the points between that stay where they stand.
  AdaptedCurve outlineOf(const std::vector<AdaptedCurve>& curves, const std::vector<PointRun>& runs,
                         const std::vector<GrownPoint>& standing) const {
    const std::size_t count = top_.size();
    AdaptedCurve outline;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      for (std::size_t i = 0; i < curves[r].points.size(); ++i)
        appendPiece(outline, {curves[r].points[i], curves[r].axis[i], curves[r].height_mm[i]});
      // Curves end on the point next to the run, on either side.
      const std::size_t next = runs[(r + 1) % runs.size()].first + (r + 1 == runs.size() ? count : 0);
      for (std::size_t i = runs[r].first + runs[r].count + 1; i + 1 < next; ++i)
        appendPiece(outline, standing[i % count]);
    }
    return outline;
  }

  std::size_t mostSteps(double height_mm) const {
    double farthest = 0.0;
    for (std::size_t i = 0; i < top_.size(); ++i)
      farthest = std::max(farthest, fronts_[front_of_[i]]->places.nearest(top_[i]).distance_mm);
    return 4 * static_cast<std::size_t>(std::ceil(farthest / height_mm)) + 4;
  }

  [[noreturn]] void refuse(std::size_t taken) const {
    throw Unsliceable("the top of the part at z = " + std::to_string(top_.front().z()) +
                          " mm is not reached by " + std::to_string(taken) +
                          " completing layers; expected walls that lead there without folds",
                      facesBetween(mesh_, fronts_.front()->curve.points.front().z(), top_.front().z()));
  }

  const Mesh& mesh_;
  const Growth& growth_;
  std::size_t level_;
  const std::vector<Point3>& top_;
  std::vector<std::unique_ptr<PlacedCurve>> fronts_;
  std::vector<std::size_t> front_of_;  // for each point the curve that grows towards it
  std::vector<GrownPoint> grown_;
};

}  // namespace

std::vector<AdaptedLayer> completedTop(const Mesh& mesh, const WallStrand& strand, const Growth& growth,
                                       std::unique_ptr<PlacedCurve> last,
                                       const std::vector<GrowthStep>& steps) {
  TopCompletion completion(mesh, strand, growth, std::move(last));
  std::vector<AdaptedLayer> layers;
  for (const GrowthStep& step : steps) {
    std::vector<AdaptedLayer> more = completion.layersOf(step);
    std::move(more.begin(), more.end(), std::back_inserter(layers));
  }
  return layers;
}

}  // namespace lamina
