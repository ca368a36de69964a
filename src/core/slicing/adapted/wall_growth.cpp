// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/wall_growth.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space_vectors.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/curve_length.hpp"
#include "slicing/adapted/curve_places.hpp"
#include "slicing/adapted/mesh_region.hpp"
#include "slicing/adapted/point_order.hpp"
#include "slicing/adapted/wall_strand.hpp"

namespace lamina {
namespace {

/// A curve, where its places are and how far along it.
struct PlacedCurve {
  explicit PlacedCurve(AdaptedCurve placed);
  AdaptedCurve curve;
  CurvePlaces places;
  CurveLength length;
};

/// A point of a layer and what it stands on.
struct GrownPoint {
  Point3 point = Point3::Zero();
  Point3 axis = Point3::Zero();
  double height_mm = 0.0;   ///< from the curve below
  double foot_mm = 0.0;     ///< length along the curve below at which it stands
  bool is_reached = false;  ///< whether the flat contour was near enough, so that its point was taken
  bool is_corner =
      false;  ///< whether it belongs on the edge of the wall that the corner of the contour is on
};

/// Draws flat contours of one wall down to a layer's height from the curve below.
class Growth {
 public:
  /// @param strand  must outlive this
  Growth(const WallStrand& strand, CornerPath corners);

  /// The lowest flat contour above a height, or the number of contours if there is none.
  std::size_t firstAbove(double z) const;

  /// The point of the layer on `below` that grows towards point `i` of the flat contour `level`
  /// [Flores2018, figure 78]. If that is no farther than `height_mm`, it is taken itself.
  /// Otherwise the way there from the nearest place below is followed by that height, and the point put on
  /// the line between the two flat contours that enclose it, which lies along the wall, again at that height
  /// from the place below that is nearest then; of two such points the upper one. If the line is farther
  /// away than that, the point at that height nearest to it is taken.
  GrownPoint towards(std::size_t level, std::size_t i, const PlacedCurve& below, double height_mm) const;

 private:
  /// Where the wall is beside a point between two flat contours: the place on each.
  struct WallBeside {
    CurvePlace low;
    CurvePlace high;
  };

  WallBeside besideOn(std::size_t above, const GrownPoint& grown) const;
  void returnToWall(GrownPoint& grown, std::size_t level, double foot_z, const PlacedCurve& below) const;
  void putOnWall(GrownPoint& grown, std::size_t above, const PlacedCurve& below) const;

  const WallStrand& strand_;
  std::vector<double> heights_;
  std::vector<std::unique_ptr<CurvePlaces>> places_;
  std::vector<std::vector<std::size_t>> corners_;  ///< of each flat contour, the points at which it turns
};

constexpr double kGrowthRounding = 1e-9;  // of a height, so that vertical walls keep their own points
constexpr int kMostRounds = 12;           // in which the place stood on becomes the nearest one
constexpr double kSettled = 1e-5;         // of a height: the point moves no more

/// The upper of the points of the line from `low` to `high` at a distance from a point; if the line passes it
/// farther away, the point at that distance nearest to the line.
Point3 onLineAt(const Point3& low, const Point3& high, const Point3& from, double distance) {
  const Point3 along = (high - low).normalized();
  const Point3 foot = low + (from - low).dot(along) * along;
  const double across = (foot - from).norm();
  if (across >= distance) return from + distance / across * (foot - from);
  return foot + std::sqrt(distance * distance - across * across) * along;
}

PlacedCurve::PlacedCurve(AdaptedCurve placed)
    : curve(std::move(placed)), places(curve.points, curve.is_closed), length(curve) {}

/// The curve through grown points, without those that would make it fold (`pointsInOrder`).
AdaptedCurve curveThrough(const std::vector<GrownPoint>& grown, bool is_closed, const PlacedCurve& below) {
  std::vector<double> feet_mm;
  feet_mm.reserve(grown.size());
  for (const GrownPoint& point : grown) feet_mm.push_back(point.foot_mm);
  AdaptedCurve curve;
  curve.is_closed = is_closed;
  for (const std::size_t i : pointsInOrder(feet_mm, below.curve.is_closed ? below.length.total() : 0.0)) {
    curve.points.push_back(grown[i].point);
    curve.axis.push_back(grown[i].axis);
    curve.height_mm.push_back(grown[i].height_mm);
  }
  return curve;
}

constexpr double kCornerTurn = 20.0 * M_PI / 180.0;  // sides of facets of round walls turn by less
// Corners farther apart than this many times the distance of their contours are not of one edge.
constexpr double kFarthestCorner = 4.0;

std::vector<std::size_t> cornersOf(const std::vector<Point3>& points) {
  const std::size_t count = points.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 from = points[i] - points[(i + count - 1) % count];
    const Point3 to = points[(i + 1) % count] - points[i];
    if (std::atan2(from.cross(to).norm(), from.dot(to)) > kCornerTurn) corners.push_back(i);
  }
  return corners;
}

Growth::Growth(const WallStrand& strand, CornerPath corners) : strand_(strand) {
  for (const WallContour& contour : strand.levels) {
    heights_.push_back(contour.points.front().z());
    places_.push_back(std::make_unique<CurvePlaces>(contour.points, true));
    corners_.push_back(corners == CornerPath::along_edge ? cornersOf(contour.points)
                                                         : std::vector<std::size_t>());
  }
}

/// The corner of a contour nearest to a point, as a place on it.
CurvePlace nearestCorner(const std::vector<Point3>& points, const std::vector<std::size_t>& corners,
                         const Point3& point) {
  CurvePlace nearest;
  nearest.distance_mm = std::numeric_limits<double>::infinity();
  for (const std::size_t i : corners) {
    const double distance = (points[i] - point).norm();
    if (distance < nearest.distance_mm) nearest = {i, 0.0, points[i], distance};
  }
  return nearest;
}

Growth::WallBeside Growth::besideOn(std::size_t above, const GrownPoint& grown) const {
  if (grown.is_corner) {
    const CurvePlace high = nearestCorner(strand_.levels[above].points, corners_[above], grown.point);
    const CurvePlace low = nearestCorner(strand_.levels[above - 1].points, corners_[above - 1], high.point);
    const double apart_mm = heights_[above] - heights_[above - 1];
    if (low.distance_mm <= kFarthestCorner * apart_mm &&
        high.distance_mm <= kFarthestCorner * (apart_mm + grown.height_mm))
      return {low, high};
  }
  const CurvePlace high = places_[above]->nearest(grown.point);
  return {places_[above - 1]->nearest(high.point), high};
}

std::size_t Growth::firstAbove(double z) const {
  return static_cast<std::size_t>(std::upper_bound(heights_.begin(), heights_.end(), z) - heights_.begin());
}

void Growth::putOnWall(GrownPoint& grown, std::size_t above, const PlacedCurve& below) const {
  const CurvePlace foot = below.places.nearest(grown.point);
  grown.foot_mm = below.length.at(foot);
  const auto [low, high] = besideOn(above, grown);
  grown.point = onLineAt(low.point, high.point, foot.point, grown.height_mm);
  grown.axis =
      (directionAt(strand_.levels[above].axis, high) + directionAt(below.curve.axis, foot)).normalized();
}

void Growth::returnToWall(GrownPoint& grown, std::size_t level, double foot_z,
                          const PlacedCurve& below) const {
  // Levels higher than the point can be would all be gone through without effect on where it ends.
  std::size_t above = std::min(level, firstAbove(foot_z + grown.height_mm));
  for (; above > 1 && grown.point.z() < heights_[above - 1]; --above) putOnWall(grown, above, below);
  for (int round = 0; round < kMostRounds; ++round) {
    const Point3 before = grown.point;
    putOnWall(grown, above, below);
    if ((grown.point - before).norm() < kSettled * grown.height_mm) break;
  }
}

GrownPoint Growth::towards(std::size_t level, std::size_t i, const PlacedCurve& below,
                           double height_mm) const {
  const WallContour& contour = strand_.levels[level];
  const Point3& wanted = contour.points[i];
  const CurvePlace foot = below.places.nearest(wanted);
  if (foot.distance_mm <= height_mm * (1.0 + kGrowthRounding))
    return {wanted, contour.axis[i], foot.distance_mm, below.length.at(foot), true, false};
  const Point3 foot_axis = directionAt(below.curve.axis, foot);
  GrownPoint grown;
  grown.point = foot.point + height_mm / foot.distance_mm * (wanted - foot.point);
  grown.axis = (contour.axis[i] + foot_axis).normalized();
  grown.height_mm = height_mm;
  grown.is_corner = std::binary_search(corners_[level].begin(), corners_[level].end(), i);
  returnToWall(grown, level, foot.point.z(), below);
  return grown;
}

/// From one unit vector to another by a share of the angle between them.
Point3 turned(const Point3& from, const Point3& to, double share) {
  const double angle = angleBetween(from, to);
  const double sine = std::sin(angle);
  if (sine < 1e-9) return share < 0.5 ? from : to;
  return ((std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / sine).normalized();
}

/// The places of the lower curve that belong to the points of the upper one.
std::vector<CurvePlace> partners(const PlacedCurve& lower, const AdaptedCurve& upper) {
  const CurveLength& below = lower.length;
  const CurveLength above(upper);
  const double first = below.at(lower.places.nearest(upper.points.front()));
  double span = below.total();
  if (!upper.is_closed) {
    span = below.at(lower.places.nearest(upper.points.back())) - first;
    if (lower.curve.is_closed && span < 0.0) span += below.total();
  }
  std::vector<CurvePlace> places;
  places.reserve(upper.points.size());
  for (std::size_t i = 0; i < upper.points.size(); ++i)
    places.push_back(below.placeAt(first + span * above.atPoint(i) / above.total()));
  return places;
}

/// Curves that lead from a curve to the one that was computed above it in equal steps: points by linear
/// interpolation, axes along the shortest way. Points go together by their share of the length: of closed
/// curves from the first point of the upper one and the place nearest to it; of an open one from its first
/// to its last point and from the places nearest to these.
///
/// @return as many as `parts`, the last of which is the upper curve; heights are equal shares
std::vector<AdaptedCurve> curvesBetween(const PlacedCurve& lower, const AdaptedCurve& upper,
                                        std::size_t parts) {
  if (parts == 1) return {upper};
  const std::vector<CurvePlace> places = partners(lower, upper);
  std::vector<AdaptedCurve> curves;
  for (std::size_t part = 1; part <= parts; ++part) {
    const double share = static_cast<double>(part) / static_cast<double>(parts);
    AdaptedCurve curve = upper;
    for (double& height : curve.height_mm) height /= static_cast<double>(parts);
    for (std::size_t i = 0; i < places.size() && part < parts; ++i) {
      curve.points[i] = (1.0 - share) * places[i].point + share * upper.points[i];
      curve.axis[i] = turned(directionAt(lower.curve.axis, places[i]), upper.axis[i], share);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

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
    throw Unsliceable("the top of the part at z = " + numberText(top_.front().z()) +
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

/// Layers between the last adapted curve of a wall and the top of the part: grown towards the highest flat
/// contour where that is far enough, so that curves are open where the top is reached elsewhere. Open curves
/// end on the point next to them that is not grown. Where less than a layer is left, it is deposited as high
/// as it is if that is half of it at least.
///
/// @param mesh   the part, to show where it cannot be sliced
/// @param last   the last adapted curve
/// @param steps  coarse ones first; each is taken as long as there is room for it
/// @return layers of this wall; outlines where curves are open
/// @throws Unsliceable if the top is not reached by four times the layers its distance needs
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

/// What a layer may leave of the one below it.
struct GapLimit {
  double height_mm = 0.0;  ///< that the layer should have
  double step_mm = 0.0;    ///< between points: smaller details are not seen
};

constexpr double kMostHeights = 2.0;

/// Refuses a curve that leaves places of the closed curve below it farther away than twice the height and a
/// step.
/// @param layer  its number, for the message
/// @param mesh   the part, whose faces around the gap are the region
/// @throws Unsliceable naming the gap and where it is
void requireNoGap(const AdaptedCurve& curve, const PlacedCurve& below, const GapLimit& limit,
                  std::size_t layer, const Mesh& mesh) {
  const CurvePlaces places(curve.points, curve.is_closed);
  double greatest = 0.0;
  Point3 at = Point3::Zero();
  for (const Point3& point : below.curve.points) {
    const double distance = places.nearest(point).distance_mm;
    if (distance > greatest) at = point;
    greatest = std::max(greatest, distance);
  }
  if (greatest <= kMostHeights * limit.height_mm + limit.step_mm) return;
  char message[320];
  std::snprintf(
      message, sizeof message,
      "adapted layer %zu leaves a gap of %.2f mm over (%.2f, %.2f, %.2f) mm where layers are %.2f mm high; "
      "expected walls whose lean changes gently along a loop",
      layer, greatest, at.x(), at.y(), at.z(), limit.height_mm);
  throw Unsliceable(message, facesNear(mesh, at, greatest));
}

constexpr double kRounding = 1e-6;  // of a step

AdaptedCurve lowest(const WallStrand& strand) {
  const WallContour& contour = strand.levels.front();
  return {true, contour.points, contour.axis, std::vector<double>(contour.points.size(), 0.0)};
}

AdaptedCurve nextCurve(const Growth& growth, std::size_t level, std::size_t points, const PlacedCurve& below,
                       double height_mm) {
  constexpr std::size_t kBlock = 128;  // points that are worth a task of their own
  std::vector<GrownPoint> grown(points);
  NoProgress unwatched;
  parallelFor((points + kBlock - 1) / kBlock,
              [&](std::size_t block) {
                for (std::size_t i = block * kBlock; i < std::min(points, (block + 1) * kBlock); ++i)
                  grown[i] = growth.towards(level, i, below, height_mm);
              },
              unwatched, "adapt");
  return curveThrough(grown, true, below);
}

double highest(const AdaptedCurve& curve) {
  double z = curve.points.front().z();
  for (const Point3& point : curve.points) z = std::max(z, point.z());
  return z;
}

void addLayers(std::vector<AdaptedLayer>& layers, std::vector<AdaptedCurve> curves) {
  for (AdaptedCurve& curve : curves) layers.push_back({{std::move(curve)}, {}});
}

}  // namespace

std::vector<AdaptedLayer> growWall(const Mesh& mesh, const WallStrand& strand, const GrowthSteps& steps,
                                   CornerPath corners, Progress& progress) {
  const Growth growth(strand, corners);
  const std::size_t top = strand.levels.size() - 1;
  auto below = std::make_unique<PlacedCurve>(lowest(strand));
  std::vector<AdaptedLayer> layers;
  GrowthStep step = steps.first;
  for (;; step = steps.other) {
    throwIfCancelled(progress, "adapt");
    const std::size_t level = growth.firstAbove(highest(below->curve) + step.height_mm * (1.0 - kRounding));
    if (level > top || (level == top && !layers.empty())) break;
    AdaptedCurve curve = nextCurve(growth, level, strand.levels[level].points.size(), *below, step.height_mm);
    requireNoGap(curve, *below, {step.height_mm, steps.spacing_mm}, layers.size(), mesh);
    addLayers(layers, curvesBetween(*below, curve, step.parts));
    below = std::make_unique<PlacedCurve>(std::move(curve));
    progress.report("adapt", static_cast<double>(level) / static_cast<double>(top));
  }
  std::vector<GrowthStep> completing{steps.other};
  if (steps.other.parts > 1)
    completing.push_back({steps.other.height_mm / static_cast<double>(steps.other.parts), 1});
  std::vector<AdaptedLayer> rest = completedTop(mesh, strand, growth, std::move(below), completing);
  std::move(rest.begin(), rest.end(), std::back_inserter(layers));
  return layers;
}

}  // namespace lamina
