// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/chart_lookup.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/spatial/cells_near_segment.hpp"

namespace lamina {
namespace {

/// Around triangles in the grid, so that those near a border are found from outside [mm].
constexpr double kMargin = 2.0 * ChartLookup::kSnap;
/// What rounding leaves between neighbouring triangles [mm].
constexpr double kRounding = 1e-9;

void requireWhole(const LayerChart& chart, std::size_t number) {
  const LayerSurface& surface = chart.surface;
  const std::size_t count = surface.middle.vertices.size();
  if (chart.parameterization.size() != count || surface.tip.size() != count ||
      surface.normal.size() != count || surface.height_mm.size() != count)
    throw InvalidInput("chart " + std::to_string(number) + " has " + std::to_string(count) + " vertices, " +
                       std::to_string(chart.parameterization.size()) + " places in the parameter plane, " +
                       std::to_string(surface.tip.size()) + " tips, " +
                       std::to_string(surface.normal.size()) + " normals and " +
                       std::to_string(surface.height_mm.size()) + " heights; must be as many of each");
  for (std::size_t i = 0; i < count; ++i)
    if (!chart.parameterization[i].allFinite() || !surface.middle.vertices[i].allFinite() ||
        !surface.tip[i].allFinite() || !surface.normal[i].allFinite() || !std::isfinite(surface.height_mm[i]))
      throw InvalidInput("chart " + std::to_string(number) + ", vertex " + std::to_string(i) +
                         " is not finite");
}

/// Weights of a triangle's corners at a point of its plane; negative outside.
Point3 weightsAt(const std::array<Point2, 3>& corners, const Point2& point) {
  const Point2 a = corners[0] - corners[2];
  const Point2 b = corners[1] - corners[2];
  const Point2 p = point - corners[2];
  const double area = cross(a, b);
  if (area == 0.0) return Point3::Constant(-std::numeric_limits<double>::infinity());
  const double first = cross(p, b) / area;
  const double second = cross(a, p) / area;
  return {first, second, 1.0 - first - second};
}

struct NearestWeights {
  Point3 weights = Point3::Zero();
  double distance_mm = std::numeric_limits<double>::infinity();
};

/// Of the point on the triangle's border that is nearest.
NearestWeights nearestOnBorder(const std::array<Point2, 3>& corners, const Point2& point) {
  NearestWeights best;
  for (int side = 0; side < 3; ++side) {
    const auto from = static_cast<std::size_t>(side);
    const auto to = static_cast<std::size_t>((side + 1) % 3);
    const Point2 along = corners[to] - corners[from];
    const double squared = along.squaredNorm();
    const double part =
        squared > 0.0 ? std::clamp((point - corners[from]).dot(along) / squared, 0.0, 1.0) : 0.0;
    const double distance = (corners[from] + part * along - point).norm();
    if (distance >= best.distance_mm) continue;
    best.distance_mm = distance;
    best.weights.setZero();
    best.weights[side] = 1.0 - part;
    best.weights[(side + 1) % 3] = part;
  }
  return best;
}

struct Interval {
  double from = 0.0;
  double to = 1.0;
};

/// The part of a line that lies in a triangle widened by the margin [mm].
std::optional<Interval> clipped(const std::array<Point2, 3>& corners, const Point2& from, const Point2& to,
                                double margin) {
  if (!(cross(corners[1] - corners[0], corners[2] - corners[0]) > 0.0)) return std::nullopt;
  Interval inside;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 side = corners[(i + 1) % 3] - corners[i];
    const double length = side.norm();
    const double start = cross(side, from - corners[i]) / length + margin;
    const double end = cross(side, to - corners[i]) / length + margin;
    if (start < 0.0 && end < 0.0) return std::nullopt;
    if (start < 0.0) inside.from = std::max(inside.from, start / (start - end));
    if (end < 0.0) inside.to = std::min(inside.to, start / (start - end));
  }
  if (inside.to < inside.from) return std::nullopt;
  return inside;
}

/// The stretches that cover the whole line, of some in the order of their starts.
std::optional<std::vector<ChartStretch>> cover(const ChartStretch* first, const ChartStretch* last,
                                               double gap) {
  std::vector<ChartStretch> covering;
  double reached = 0.0;
  while (covering.empty() || reached < 1.0) {
    const ChartStretch* best = nullptr;
    for (; first != last && first->from <= reached + gap; ++first)
      if (best == nullptr || first->to > best->to) best = first;
    // Of those passed earlier none reaches farther than the one that was taken.
    if (best == nullptr) return std::nullopt;
    if (best->to <= reached && !covering.empty()) continue;
    covering.push_back({best->in, reached, std::min(best->to, 1.0)});
    reached = best->to;
    if (reached >= 1.0 - gap) break;
  }
  covering.back().to = 1.0;
  return covering;
}

}  // namespace

ChartLookup::ChartLookup(const std::vector<LayerChart>& charts) : charts_(charts) {
  Box2 box;
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    requireWhole(charts[c], c);
    const auto count = static_cast<std::uint32_t>(charts[c].surface.middle.triangles.size());
    for (std::uint32_t t = 0; t < count; ++t) {
      triangles_.push_back({c, t});
      for (const Point2& corner : parametersOf(triangles_.back())) box.include(corner);
    }
  }
  if (triangles_.empty())
    throw InvalidInput("the charts of a layer hold no triangle; at least one is needed");
  sort(box);
}

void ChartLookup::sort(const Box2& box) {
  const auto count = static_cast<double>(triangles_.size());
  const Point2 size = box.size() + Point2::Constant(4.0 * kMargin);
  const double cell = std::max(std::sqrt(size.x() * size.y() / count), size.maxCoeff() / (count + 1.0));
  grid_ = heightGrid({box.low - Point2::Constant(2.0 * kMargin), box.high + Point2::Constant(2.0 * kMargin)},
                     cell);
  first_.assign(grid_.cellCount() + 1, 0);
  for (const ChartTriangle& in : triangles_)
    forCellsOf(parametersOf(in), [&](std::size_t cell_number) { ++first_[cell_number + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  items_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i)
    forCellsOf(parametersOf(triangles_[i]),
               [&](std::size_t cell_number) { items_[next[cell_number]++] = i; });
}

ChartLookup::Corners ChartLookup::parametersOf(const ChartTriangle& in) const {
  const LayerChart& chart = charts_[in.chart];
  const Triangle& triangle = chart.surface.middle.triangles[in.triangle];
  return {chart.parameterization[triangle[0]], chart.parameterization[triangle[1]],
          chart.parameterization[triangle[2]]};
}

template <class Visit>
void ChartLookup::forCellsOf(const Corners& corners, const Visit& visit) const {
  Box2 box;
  for (const Point2& corner : corners) box.include(corner);
  const auto index = [this](double position, double origin, int count) {
    return static_cast<int>(std::clamp(std::floor((position - origin) / grid_.cell_mm), 0.0, count - 1.0));
  };
  const int last_column = index(box.high.x() + kMargin, grid_.origin.x(), grid_.columns);
  const int last_row = index(box.high.y() + kMargin, grid_.origin.y(), grid_.rows);
  for (int row = index(box.low.y() - kMargin, grid_.origin.y(), grid_.rows); row <= last_row; ++row)
    for (int column = index(box.low.x() - kMargin, grid_.origin.x(), grid_.columns); column <= last_column;
         ++column)
      visit(grid_.cell(column, row));
}

std::optional<ChartPlace> ChartLookup::find(const Point2& parameters) const {
  const std::size_t cell = grid_.cellAt(parameters);
  if (cell == HeightGrid::kNoCell) return std::nullopt;
  ChartPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
    const ChartTriangle& in = triangles_[items_[i]];
    const Corners corners = parametersOf(in);
    const Point3 weights = weightsAt(corners, parameters);
    if (weights.minCoeff() >= 0.0) return ChartPlace{in, weights};
    const NearestWeights nearest = nearestOnBorder(corners, parameters);
    if (nearest.distance_mm >= least) continue;
    least = nearest.distance_mm;
    best = {in, nearest.weights};
  }
  if (least > kSnap) return std::nullopt;
  return best;
}

ChartPlace ChartLookup::at(const Point2& parameters) const {
  std::optional<ChartPlace> place = find(parameters);
  if (!place)
    throw InvalidInput(
        "place (" + numberText(parameters.x()) + ", " + numberText(parameters.y()) +
        ") mm in the parameter plane lies outside the charts of its layer; must be inside, within " +
        numberText(kSnap) + " mm");
  return *place;
}

ChartPlace ChartLookup::within(const ChartTriangle& in, const Point2& parameters) const {
  const Corners corners = parametersOf(in);
  const Point3 weights = weightsAt(corners, parameters);
  if (weights.minCoeff() >= 0.0) return {in, weights};
  return {in, nearestOnBorder(corners, parameters).weights};
}

SurfacePoint ChartLookup::lifted(const ChartPlace& place) const {
  const LayerSurface& surface = charts_[place.in.chart].surface;
  const Triangle& triangle = surface.middle.triangles[place.in.triangle];
  const auto between = [&](const std::vector<Point3>& values) {
    return Point3(place.weights[0] * values[triangle[0]] + place.weights[1] * values[triangle[1]] +
                  place.weights[2] * values[triangle[2]]);
  };
  SurfacePoint point;
  point.middle = between(surface.middle.vertices);
  point.tip = between(surface.tip);
  const Point3 normal = between(surface.normal);
  const double norm = normal.norm();
  point.normal = norm > 0.0 ? Point3(normal / norm) : surface.normal[triangle[0]];
  for (int i = 0; i < 3; ++i)
    point.height_mm += place.weights[i] * surface.height_mm[triangle[static_cast<std::size_t>(i)]];
  return point;
}

double ChartLookup::areaRatio(const ChartTriangle& in) const {
  const Mesh& mesh = charts_[in.chart].surface.middle;
  const Triangle& triangle = mesh.triangles[in.triangle];
  const Point3& corner = mesh.vertices[triangle[0]];
  const Corners parameters = parametersOf(in);
  return (mesh.vertices[triangle[1]] - corner).cross(mesh.vertices[triangle[2]] - corner).norm() /
         cross(parameters[1] - parameters[0], parameters[2] - parameters[0]);
}

std::optional<std::vector<ChartStretch>> ChartLookup::stretches(const Point2& from, const Point2& to) const {
  if ((to - from).norm() <= kRounding) {
    const std::optional<ChartPlace> place = find(from);
    if (!place) return std::nullopt;
    return std::vector<ChartStretch>{{place->in, 0.0, 1.0}};
  }
  if (const std::optional<ChartPlace> place = find(from))
    if (weightsAt(parametersOf(place->in), to).minCoeff() >= 0.0)
      return std::vector<ChartStretch>{{place->in, 0.0, 1.0}};
  std::vector<std::uint32_t> candidates;
  // The middles of all cells that a line crosses are nearer to it than half their diagonal.
  forCellsNearSegment(grid_, from, to, 0.71 * grid_.cell_mm, [&](std::size_t cell, double, double) {
    candidates.insert(candidates.end(), items_.begin() + first_[cell], items_.begin() + first_[cell + 1]);
  });
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::optional<std::vector<ChartStretch>> found =
      covering(from, to, candidates, {1e-3 * kRounding, Over::OneChart});
  if (!found) found = covering(from, to, candidates, {kSnap, Over::OneChart});
  if (!found) found = covering(from, to, candidates, {kSnap, Over::AnyChart});
  return found;
}

std::optional<std::vector<ChartStretch>> ChartLookup::covering(const Point2& from, const Point2& to,
                                                               const std::vector<std::uint32_t>& candidates,
                                                               Crossing crossing) const {
  std::vector<ChartStretch> found;
  for (const std::uint32_t candidate : candidates) {
    const ChartTriangle& in = triangles_[candidate];
    if (const std::optional<Interval> part = clipped(parametersOf(in), from, to, crossing.margin_mm))
      found.push_back({in, part->from, part->to});
  }
  const bool is_any = crossing.over == Over::AnyChart;
  std::sort(found.begin(), found.end(), [is_any](const ChartStretch& a, const ChartStretch& b) {
    const std::uint32_t one = is_any ? 0 : a.in.chart;
    const std::uint32_t other = is_any ? 0 : b.in.chart;
    return std::tie(one, a.from, a.in.chart, a.in.triangle) <
           std::tie(other, b.from, b.in.chart, b.in.triangle);
  });
  const double gap = kRounding / (to - from).norm();
  for (std::size_t first = 0, last = 0; first < found.size(); first = last) {
    while (last < found.size() && (is_any || found[last].in.chart == found[first].in.chart)) ++last;
    std::optional<std::vector<ChartStretch>> all = cover(found.data() + first, found.data() + last, gap);
    if (all) return all;
  }
  return std::nullopt;
}

}  // namespace lamina
