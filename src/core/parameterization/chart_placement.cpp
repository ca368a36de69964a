// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/chart_placement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

using Complex = std::complex<double>;

// Between charts that were moved [mm].
constexpr double kGap = 10.0;
// Charts are level to this, beyond rounding errors [mm].
constexpr double kLevel = 1e-6;
// A fit is reported by less than this share of what a perfect one would have: no direction.
constexpr double kLeastFit = 0.05;

std::vector<double> areaOfVertices(const Mesh& mesh) {
  std::vector<double> area(mesh.vertices.size(), 0.0);
  for (const Triangle& corner : mesh.triangles) {
    const Point3 ab = mesh.vertices[corner[1]] - mesh.vertices[corner[0]];
    const Point3 ac = mesh.vertices[corner[2]] - mesh.vertices[corner[0]];
    for (const std::uint32_t vertex : corner) area[vertex] += ab.cross(ac).norm();
  }
  return area;
}

struct Centres {
  Point2 plan = Point2::Zero();
  Point3 surface = Point3::Zero();
};

Centres centresOf(const LayerChart& chart, const std::vector<double>& weight) {
  Centres centres;
  double sum = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    centres.plan += weight[i] * chart.plan[i];
    centres.surface += weight[i] * chart.surface.middle.vertices[i];
    sum += weight[i];
  }
  if (sum > 0.0) {
    centres.plan /= sum;
    centres.surface /= sum;
  }
  return centres;
}

/// How the plan must be turned, a number of length 1.
Complex turnOf(const LayerChart& chart, const std::vector<double>& weight, const Centres& centres) {
  Complex fit = 0.0, towards_x = 0.0, towards_y = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const Point2 place = chart.plan[i] - centres.plan;
    const Point3 above = chart.surface.middle.vertices[i] - centres.surface;
    const Complex back = weight[i] * Complex(place.x(), -place.y());
    fit += back * Complex(above.x(), above.y());
    towards_x += back * above.x();
    towards_y += back * above.y();
    size += weight[i] * place.squaredNorm();
  }
  Complex turn = fit;
  if (!(std::abs(turn) > kLeastFit * size)) turn = towards_x;
  if (!(std::abs(turn) > kLeastFit * size)) turn = Complex(0.0, 1.0) * towards_y;
  if (!(std::abs(turn) > kLeastFit * size)) return 1.0;
  return turn / std::abs(turn);
}

Box2 boxOf(const LayerChart& chart) { return boundingBox(std::vector<Polygon>{chart.plan}); }

bool overlap(const Box2& a, const Box2& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// The height of a chart that is level and lies where its surface does [mm].
std::optional<double> levelOf(const LayerChart& chart) {
  const std::vector<Point3>& vertices = chart.surface.middle.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (std::abs(vertices[i].z() - vertices[0].z()) > kLevel ||
        (vertices[i].head<2>() - chart.plan[i]).norm() > kLevel)
      return std::nullopt;
  return vertices[0].z();
}

/// What a chart takes up of the plan.
struct Ground {
  Box2 box;
  std::optional<double> level;
};

/// Charts of one level do not lie on each other, whatever their boxes do.
bool collide(const Ground& a, const Ground& b) {
  if (a.level && b.level && std::abs(*a.level - *b.level) <= kLevel) return false;
  return overlap(a.box, b.box);
}

}  // namespace

void layOverProjection(LayerChart& chart) {
  const std::vector<double> weight = areaOfVertices(chart.surface.middle);
  const Centres centres = centresOf(chart, weight);
  const Complex turn = turnOf(chart, weight, centres);
  for (Point2& place : chart.plan) {
    const Complex turned = turn * Complex(place.x() - centres.plan.x(), place.y() - centres.plan.y());
    place = {turned.real() + centres.surface.x(), turned.imag() + centres.surface.y()};
  }
}

void moveApart(std::vector<LayerChart>& charts) {
  std::vector<Ground> taken;
  std::vector<LayerChart*> in_the_way;
  Box2 all;
  double moved_area = 0.0;
  for (LayerChart& chart : charts) {
    const Box2 box = boxOf(chart);
    const Ground ground{box, levelOf(chart)};
    if (std::any_of(taken.begin(), taken.end(),
                    [&](const Ground& other) { return collide(ground, other); })) {
      in_the_way.push_back(&chart);
      moved_area += (box.size().x() + kGap) * (box.size().y() + kGap);
      continue;
    }
    taken.push_back(ground);
    all.include(box.low);
    all.include(box.high);
  }
  const double end = all.low.x() + std::max(all.size().x(), std::sqrt(moved_area));
  Point2 free(all.low.x(), all.high.y() + kGap);
  double row_height = 0.0;
  for (LayerChart* chart : in_the_way) {
    const Box2 box = boxOf(*chart);
    if (free.x() > all.low.x() && free.x() + box.size().x() > end) {
      free = {all.low.x(), free.y() + row_height + kGap};
      row_height = 0.0;
    }
    const Point2 shift = free - box.low;
    for (Point2& place : chart->plan) place += shift;
    free.x() += box.size().x() + kGap;
    row_height = std::max(row_height, box.size().y());
  }
}

}  // namespace lamina
