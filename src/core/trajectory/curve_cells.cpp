// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/curve_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

constexpr int kPartsOfHalf = 4;         // of a rounding, on either side of its station
constexpr double kShortestPart = 1e-9;  // of a span, that is worth a cell

double rise(double u) { return u * u * (3.0 - 2.0 * u); }
double riseRate(double u) { return 6.0 * u * (1.0 - u); }

/// The speed at which to run a rounding so that averaging takes tip or tool axis no further off than the
/// tolerance.
double averagedSpeed2(double tolerance, double turned, double averaging_s) {
  return turned > 0.0 ? 24.0 * tolerance / (averaging_s * averaging_s * turned)
                      : std::numeric_limits<double>::infinity();
}

void limitInRounding(CellLimits& limits, const JointCurve& curve, const CurveCell& cell, double averaging_s) {
  const bool is_at_start = cell.part < 0;
  const std::size_t corner = is_at_start ? cell.span : cell.span + 1;
  const double b = curve.blend(corner);
  // Parts are numbered from the station outwards.
  const double near = 0.5 * (std::abs(cell.part) - 1) / kPartsOfHalf;
  const double far = 0.5 * std::abs(cell.part) / kPartsOfHalf;
  const double u0 = is_at_start ? 0.5 + near : 0.5 - near;
  const double u1 = is_at_start ? 0.5 + far : 0.5 - far;
  const JointValues before = curve.tangent(corner - 1);
  const JointValues turned = curve.turn(corner);
  const double steepest = riseRate(u0) / (2.0 * b);  // the bend grows towards the station
  limits.tangent = (before + rise(u0) * turned).cwiseAbs().cwiseMax((before + rise(u1) * turned).cwiseAbs());
  limits.bend = steepest * turned.cwiseAbs();
  const double tip_bend = steepest * curve.tipTurn(corner);
  if (curve.spanEnd(cell.span).length_mm > 0.0 && tip_bend > 0.0)
    limits.speed2 = std::min(limits.speed2, limits.path_acceleration / tip_bend);
  if (averaging_s == 0.0) return;
  limits.speed2 = std::min(
      {limits.speed2, averagedSpeed2(curve.tipTolerance(corner), tip_bend, averaging_s),
       averagedSpeed2(curve.toolAxisTolerance(corner), steepest * curve.toolAxisTurn(corner), averaging_s)});
}

}  // namespace

std::vector<CurveCell> curveCells(const JointCurve& curve) {
  std::vector<CurveCell> cells;
  cells.reserve(curve.spanCount() * (2 * kPartsOfHalf + 1));
  for (std::uint32_t span = 0; span < curve.spanCount(); ++span) {
    const double length = curve.length(span);
    const double b_start = curve.blend(span);
    const double b_end = curve.blend(span + 1);
    const auto partOf = [](double b, int part) { return b * part / kPartsOfHalf; };
    for (int part = 1; part <= kPartsOfHalf && b_start > 0.0; ++part)
      cells.push_back(
          {partOf(b_start, part - 1), partOf(b_start, part), span, static_cast<std::int8_t>(-part)});
    if (length - b_start - b_end > kShortestPart * length)
      cells.push_back({b_start, length - b_end, span, 0});
    for (int part = kPartsOfHalf; part > 0 && b_end > 0.0; --part)
      cells.push_back({length - partOf(b_end, part), length - partOf(b_end, part - 1), span,
                       static_cast<std::int8_t>(part)});
  }
  return cells;
}

CellLimits cellLimits(const JointCurve& curve, const CurveCell& cell, double averaging_s) {
  const JointStation& end = curve.spanEnd(cell.span);
  CellLimits limits;
  limits.acceleration = curve.maxAcceleration();
  limits.path_acceleration = end.acceleration_mm_s2;
  limits.speed2 = end.feed_mm_s * end.feed_mm_s;
  if (cell.part == 0) {
    limits.tangent = curve.tangent(cell.span).cwiseAbs();
    limits.bend = JointValues::Zero(limits.tangent.size());
  } else {
    limitInRounding(limits, curve, cell, averaging_s);
  }
  for (Eigen::Index j = 0; j < limits.tangent.size(); ++j) {
    const double speed = curve.maxSpeed()[j];
    const double tangent = limits.tangent[j];
    if (tangent > 0.0) limits.speed2 = std::min(limits.speed2, speed * speed / (tangent * tangent));
    if (limits.bend[j] > 0.0)
      limits.speed2 = std::min(limits.speed2, limits.acceleration[j] / limits.bend[j]);
  }
  return limits;
}

double CellLimits::reachable(double x, double length) const {
  double most = x + 2.0 * length * path_acceleration;
  for (Eigen::Index j = 0; j < tangent.size(); ++j) {
    const double per = 2.0 * length * bend[j] + tangent[j];
    if (per > 0.0) most = std::min(most, (2.0 * length * acceleration[j] + tangent[j] * x) / per);
  }
  return most;
}

double CellLimits::braking(double x) const {
  double most = path_acceleration;
  for (Eigen::Index j = 0; j < tangent.size(); ++j)
    if (tangent[j] > 0.0) most = std::min(most, (acceleration[j] - bend[j] * x) / tangent[j]);
  return std::max(0.0, most);
}

}  // namespace lamina
