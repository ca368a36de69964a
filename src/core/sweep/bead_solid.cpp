// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/bead_solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpath/bead_space.hpp"

namespace lamina {
namespace {

constexpr double kParallel = 1e-12;
constexpr double kEverywhere = std::numeric_limits<double>::infinity();

/// Where |offset + slope x| <= half.
std::optional<Stretch> bounds(double offset, double slope, double half) {
  if (std::abs(slope) < kParallel)
    return std::abs(offset) <= half ? std::optional(Stretch{-kEverywhere, kEverywhere}) : std::nullopt;
  const double one = (-half - offset) / slope, other = (half - offset) / slope;
  return Stretch{std::min(one, other), std::max(one, other)};
}

std::optional<Stretch> both(std::optional<Stretch> a, std::optional<Stretch> b) {
  if (!a || !b) return std::nullopt;
  const Stretch common = {std::max(a->from, b->from), std::min(a->to, b->to)};
  return common.from < common.to ? std::optional(common) : std::nullopt;
}

/// The smallest that holds both.
std::optional<Stretch> hull(std::optional<Stretch> a, std::optional<Stretch> b) {
  if (!a) return b;
  if (!b) return a;
  return Stretch{std::min(a->from, b->from), std::max(a->to, b->to)};
}

/// Where the point offset + slope x of the plane is in the disc about the origin.
std::optional<Stretch> disc(const Point2& offset, const Point2& slope, double radius) {
  const double a = slope.squaredNorm();
  if (a < kParallel)
    return offset.norm() <= radius ? std::optional(Stretch{-kEverywhere, kEverywhere}) : std::nullopt;
  const double half_b = offset.dot(slope);
  const double root2 = half_b * half_b - a * (offset.squaredNorm() - radius * radius);
  if (root2 < 0.0) return std::nullopt;
  const double root = std::sqrt(root2);
  return Stretch{(-half_b - root) / a, (-half_b + root) / a};
}

/// Where normal . (offset + slope x) <= 0.
std::optional<Stretch> halfSpace(double offset, double slope) {
  if (std::abs(slope) < kParallel)
    return offset <= 0.0 ? std::optional(Stretch{-kEverywhere, kEverywhere}) : std::nullopt;
  const double at = -offset / slope;
  return slope > 0.0 ? Stretch{-kEverywhere, at} : Stretch{at, kEverywhere};
}

}  // namespace

BeadSolid BeadSolid::prism(const End& start, const End& end, const Point3& up, const Bead& bead) {
  BeadSolid solid = joint(start.point, up, bead);
  solid.is_joint_ = false;
  solid.start_ = start;
  solid.end_ = end;
  solid.along_ = (end.point - start.point).normalized();
  solid.side_ = up.cross(solid.along_);
  // Along the tool axis itself there is no side; any will do.
  if (solid.side_.norm() < 1e-9) solid.side_ = solid.along_.unitOrthogonal();
  solid.side_.normalize();
  solid.up_ = solid.along_.cross(solid.side_);
  return solid;
}

BeadSolid BeadSolid::joint(const Point3& middle, const Point3& up, const Bead& bead) {
  BeadSolid solid;
  solid.is_joint_ = true;
  solid.start_.point = middle;
  solid.up_ = up;
  solid.side_ = up.unitOrthogonal();
  solid.along_ = solid.side_.cross(up);
  const SectionOutline outline = sectionOutline(bead);
  solid.radius_ = outline.radius_mm;
  solid.flat_across_ = outline.flat_across_mm;
  solid.flat_up_ = outline.flat_up_mm;
  return solid;
}

double BeadSolid::sectionDistance(double across, double height) const {
  const double a = std::abs(across) - flat_across_, b = std::abs(height) - flat_up_;
  return std::hypot(std::max(a, 0.0), std::max(b, 0.0)) + std::min(0.0, std::max(a, b)) - radius_;
}

double BeadSolid::depth(const Point3& point) const {
  const Point3 from = point - start_.point;
  const double height = from.dot(up_);
  if (is_joint_) return -sectionDistance((from - height * up_).norm(), height);
  const double section = sectionDistance(from.dot(side_), height);
  const double ends = std::max(from.dot(start_.normal), (point - end_.point).dot(end_.normal));
  return -std::max(section, ends);
}

std::optional<Stretch> BeadSolid::alongX(double y, double z) const {
  const Point3 on_line(0.0, y, z);
  if (!is_joint_) return prismAlongX(on_line);
  return up_.head<2>().norm() < kParallel ? jointAlongX(on_line) : searchAlongX(on_line);
}

std::optional<Stretch> BeadSolid::prismAlongX(const Point3& on_line) const {
  const Point3 from = on_line - start_.point;
  const Point2 offset(from.dot(side_), from.dot(up_));
  const Point2 slope(side_.x(), up_.x());
  const Point2 flat(flat_across_, flat_up_);
  // The profile is the hull of two discs and the rectangle between them.
  std::optional<Stretch> inside =
      hull(disc(offset - flat, slope, radius_), disc(offset + flat, slope, radius_));
  const Point2 half = flat_across_ > 0.0 ? Point2(flat_across_, radius_) : Point2(radius_, flat_up_);
  inside =
      hull(inside, both(bounds(offset.x(), slope.x(), half.x()), bounds(offset.y(), slope.y(), half.y())));
  inside = both(inside, halfSpace(from.dot(start_.normal), start_.normal.x()));
  return both(inside, halfSpace((on_line - end_.point).dot(end_.normal), end_.normal.x()));
}

std::optional<Stretch> BeadSolid::jointAlongX(const Point3& on_line) const {
  const Point3 from = on_line - start_.point;
  const double beyond_flat = std::max(0.0, std::abs(from.z()) - flat_up_);
  if (beyond_flat >= radius_) return std::nullopt;
  const double reach = flat_across_ + std::sqrt(radius_ * radius_ - beyond_flat * beyond_flat);
  return disc(from.head<2>(), Point2::UnitX(), reach);
}

/// Of what is convex the depth along a line rises to one top and falls again.
std::optional<Stretch> BeadSolid::searchAlongX(const Point3& on_line) const {
  const double reach = flat_across_ + flat_up_ + radius_;
  const auto depthAt = [&](double x) { return depth(on_line + x * Point3::UnitX()); };
  double low = start_.point.x() - 2.0 * reach, high = start_.point.x() + 2.0 * reach;
  const Stretch whole = {low, high};
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps; ++step) {
    const double left = low + (high - low) / 3.0, right = high - (high - low) / 3.0;
    (depthAt(left) < depthAt(right) ? low : high) = depthAt(left) < depthAt(right) ? left : right;
  }
  const double top = 0.5 * (low + high);
  if (depthAt(top) <= 0.0) return std::nullopt;
  const auto border = [&](double outside) {
    double inside = top;
    for (int step = 0; step < kSteps; ++step) {
      const double middle = 0.5 * (inside + outside);
      (depthAt(middle) > 0.0 ? inside : outside) = middle;
    }
    return inside;
  };
  return Stretch{border(whole.from), border(whole.to)};
}

void BeadSolid::includeEnd(const End& end, Box3& box) const {
  const double facing = end.normal.dot(along_);
  // The profile as the plane cuts it: sheared along the line.
  const Point3 side = side_ - end.normal.dot(side_) / facing * along_;
  const Point3 up = up_ - end.normal.dot(up_) / facing * along_;
  Point3 reach;
  for (int axis = 0; axis < 3; ++axis)
    reach[axis] = flat_across_ * std::abs(side[axis]) + flat_up_ * std::abs(up[axis]) +
                  radius_ * std::hypot(side[axis], up[axis]);
  box.include(end.point - reach);
  box.include(end.point + reach);
}

Box3 BeadSolid::box() const {
  Box3 box;
  if (!is_joint_) {
    includeEnd(start_, box);
    includeEnd(end_, box);
    return box;
  }
  Point3 reach;
  for (int axis = 0; axis < 3; ++axis) {
    const double level = std::sqrt(std::max(0.0, 1.0 - up_[axis] * up_[axis]));
    reach[axis] = flat_across_ * level + flat_up_ * std::abs(up_[axis]) + radius_;
  }
  box.include(start_.point - reach);
  box.include(start_.point + reach);
  return box;
}

std::vector<Box3> BeadSolid::stretchBoxes(double longest_mm) const {
  const double length_mm = is_joint_ ? 0.0 : (end_.point - start_.point).norm();
  const auto count = static_cast<std::size_t>(std::ceil(length_mm / longest_mm));
  if (count < 2) return {box()};
  std::vector<Box3> boxes(count);
  for (std::size_t i = 0; i <= count; ++i) {
    End cut = {start_.point + length_mm * double(i) / double(count) * along_, along_};
    if (i == 0) cut = start_;
    if (i == count) cut = end_;
    if (i > 0) includeEnd(cut, boxes[i - 1]);
    if (i < count) includeEnd(cut, boxes[i]);
  }
  return boxes;
}

BeadSolid BeadSolid::turned(double angle_rad) const {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle_rad, Point3::UnitZ()).toRotationMatrix();
  BeadSolid solid = *this;
  for (Point3* vector : {&solid.start_.point, &solid.start_.normal, &solid.end_.point, &solid.end_.normal,
                         &solid.along_, &solid.side_, &solid.up_})
    *vector = turn * *vector;
  return solid;
}

}  // namespace lamina
