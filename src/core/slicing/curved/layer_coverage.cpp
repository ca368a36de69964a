// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/layer_coverage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

// Of a layer's height: tips nearer to the middle than this do not show the way to the lower side.
constexpr double kTooNear = 0.05;

using Tetrahedron = std::array<Point3, 4>;

/// Sample and how often, of the samples in one layer.
using Hits = std::vector<std::pair<std::uint32_t, int>>;

/// Where a layer begins, per vertex: opposite to its tips, so that it is as high as it should be.
std::vector<Point3> lowerSide(const LayerSurface& layer) {
  const std::vector<Point3>& middle = layer.middle.vertices;
  std::vector<double> above(middle.size(), 0.0);
  std::vector<double> weight(middle.size(), 0.0);
  for (const Triangle& corner : layer.middle.triangles) {
    const Point3 doubled =
        (middle[corner[1]] - middle[corner[0]]).cross(middle[corner[2]] - middle[corner[0]]);
    for (const std::uint32_t vertex : corner) {
      above[vertex] += doubled.dot(layer.tip[vertex] - middle[vertex]);
      weight[vertex] += doubled.norm();
    }
  }
  std::vector<Point3> lower;
  lower.reserve(middle.size());
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const double height = layer.height_mm[i];
    const double tip = weight[i] > 0.0 ? above[i] / weight[i] : 0.0;
    const bool is_near = tip < kTooNear * height;
    const Point3 up = is_near ? layer.normal[i] : Point3((layer.tip[i] - middle[i]) / tip);
    lower.emplace_back(middle[i] - (height - std::max(0.0, tip)) * up);
  }
  return lower;
}

double volume6(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// 1 inside a tetrahedron, -1 inside one that is turned inside out, 0 outside.
int sideOf(const Tetrahedron& corner, const Point3& point) {
  const double whole = volume6(corner[0], corner[1], corner[2], corner[3]);
  const double sign = whole < 0.0 ? -1.0 : 1.0;
  if (whole == 0.0 || sign * volume6(point, corner[1], corner[2], corner[3]) < 0.0 ||
      sign * volume6(corner[0], point, corner[2], corner[3]) < 0.0 ||
      sign * volume6(corner[0], corner[1], point, corner[3]) < 0.0 ||
      sign * volume6(corner[0], corner[1], corner[2], point) < 0.0)
    return 0;
  return whole < 0.0 ? -1 : 1;
}

/// The prism over a triangle as three tetrahedra. Walls are parted from the vertex of the lower number below
/// to that of the higher one above, the same in both prisms at a wall.
std::array<Tetrahedron, 3> parted(const Triangle& corner, const std::vector<Point3>& low,
                                  const std::vector<Point3>& high) {
  std::size_t first = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (corner[k] < corner[first]) first = k;
  const std::uint32_t a = corner[first];
  const std::uint32_t b = corner[(first + 1) % 3];
  const std::uint32_t c = corner[(first + 2) % 3];
  if (b < c)
    return {{{low[a], low[b], low[c], high[c]},
             {low[a], low[b], high[c], high[b]},
             {low[a], high[b], high[c], high[a]}}};
  return {{{low[a], low[b], low[c], high[b]},
           {low[a], high[b], low[c], high[c]},
           {low[a], high[b], high[c], high[a]}}};
}

Hits hitsOf(const LayerSurface& layer, const PartSamples& samples) {
  const std::vector<Point3> low = lowerSide(layer);
  Hits hits;
  for (const Triangle& corner : layer.middle.triangles) {
    Box3 box{low[corner[0]], low[corner[0]]};
    for (const std::uint32_t vertex : corner) {
      box.low = box.low.cwiseMin(low[vertex]).cwiseMin(layer.tip[vertex]);
      box.high = box.high.cwiseMax(low[vertex]).cwiseMax(layer.tip[vertex]);
    }
    samples.visitIn(box, [&](std::uint32_t sample) {
      int times = 0;
      for (const Tetrahedron& tetrahedron : parted(corner, low, layer.tip))
        times += sideOf(tetrahedron, samples.points()[sample]);
      if (times != 0) hits.emplace_back(sample, times);
    });
  }
  return hits;
}

Hits hitsOf(const Layer& layer, const Box3& box, const PartSamples& samples) {
  Box3 bounds = box;
  bounds.low.z() = layer.bounds.bottom_mm;
  bounds.high.z() = layer.bounds.top_mm;
  Hits hits;
  samples.visitIn(bounds, [&](std::uint32_t sample) {
    if (contains(layer.section.contours, samples.points()[sample].head<2>())) hits.emplace_back(sample, 1);
  });
  return hits;
}

/// What a layer folds back cancels out before layers are added up.
void add(Hits hits, std::vector<std::uint32_t>& counts) {
  std::sort(hits.begin(), hits.end());
  for (std::size_t i = 0; i < hits.size();) {
    int times = 0;
    const std::uint32_t sample = hits[i].first;
    for (; i < hits.size() && hits[i].first == sample; ++i) times += hits[i].second;
    counts[sample] += static_cast<std::uint32_t>(std::max(0, times));
  }
}

}  // namespace

std::vector<std::uint32_t> layerCounts(const PartSamples& samples, const LayersToCount& layers,
                                       Progress& progress) {
  std::vector<std::uint32_t> counts(samples.points().size(), 0);
  if (counts.empty()) return counts;
  const std::size_t lower = layers.lower.size();
  const std::size_t middle = lower + layers.middle.size();
  Box3 box{samples.points().front(), samples.points().front()};
  for (const Point3& point : samples.points()) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  std::vector<Hits> hits(middle + layers.upper.size());
  const auto count = [&](std::size_t i) {
    if (i < lower)
      hits[i] = hitsOf(layers.lower[i], samples);
    else if (i < middle)
      hits[i] = hitsOf(layers.middle[i - lower], box, samples);
    else
      hits[i] = hitsOf(layers.upper[i - middle], samples);
  };
  parallelFor(hits.size(), count, progress, "check layers");
  for (Hits& of_layer : hits) add(std::move(of_layer), counts);
  return counts;
}

}  // namespace lamina
