// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/head_clearance.hpp"

#include <algorithm>
#include <cstdio>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kSameHeight = 1e-6;  // mm

/// Room that a body takes for all tips in a box.
Box3 sweptBox(const MachineBody& body, const Box3& tips, const Eigen::Affine3d& axes_from_bed) {
  Box3 swept;
  for (int corner = 0; corner < 8; ++corner) {
    Point3 tip = tips.low;
    for (int i = 0; i < 3; ++i)
      if ((corner >> i & 1) != 0) tip[i] = tips.high[i];
    const Point3 middle = body.bed_from_body_at_zero.translation() + body.motion * (axes_from_bed * tip);
    for (int i = 0; i < 3; ++i) {
      const Point3 along = body.bed_from_body_at_zero.linear().transpose().col(i);
      swept.low[i] = std::min(swept.low[i], middle[i] - extent(body.shape, -along));
      swept.high[i] = std::max(swept.high[i], middle[i] + extent(body.shape, along));
    }
  }
  return swept;
}

Box3 grown(const Box3& box, double margin_mm) {
  const Point3 margin(margin_mm, margin_mm, 0.0);
  return {box.low - margin, box.high + margin};
}

/// Where the nozzle of the first tool is while these lay a box: beside it, by their offsets.
Box3 carriageBox(const Box3& tips, const std::vector<Point3>& nozzles_mm) {
  if (nozzles_mm.empty()) return tips;
  Box3 all;
  for (const Point3& offset : nozzles_mm) {
    all.include(tips.low - offset);
    all.include(tips.high - offset);
  }
  return all;
}

bool collide(const Box3& a, const Box3& b, double tolerance_mm) {
  return (a.low.array() < b.high.array() - tolerance_mm).all() &&
         (b.low.array() < a.high.array() - tolerance_mm).all();
}

[[noreturn]] void refuse(const StandingPart& printed, const StandingPart& finished, const MachineBody& body,
                         double bottom_mm) {
  char text[256];
  std::snprintf(
      text, sizeof text,
      "' of the machine comes down to z %.4g mm over the finished part '%s', which is %.4g mm high; "
      "expected parts farther apart, or plate.order by_layer",
      bottom_mm, finished.name.c_str(), finished.box.high.z());
  throw Unreachable("while part '" + printed.name + "' is printed, link '" + body.link + text);
}

}  // namespace

std::vector<std::size_t> partOrder(const std::vector<StandingPart>& parts) {
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < parts.size(); ++i) rest.push_back(i);
  std::vector<std::size_t> order;
  Point2 from = Point2::Zero();
  while (!rest.empty()) {
    double lowest = parts[rest.front()].box.high.z();
    for (const std::size_t i : rest) lowest = std::min(lowest, parts[i].box.high.z());
    const auto cost = [&](std::size_t i) {
      const bool is_lowest = parts[i].box.high.z() <= lowest + kSameHeight;
      return std::make_pair(!is_lowest, (parts[i].at - from).norm());
    };
    const auto next = std::min_element(rest.begin(), rest.end(),
                                       [&](std::size_t a, std::size_t b) { return cost(a) < cost(b); });
    from = parts[*next].at;
    order.push_back(*next);
    rest.erase(next);
  }
  return order;
}

void requireHeadClear(const std::vector<StandingPart>& parts, const std::vector<std::size_t>& order,
                      const MovingHead& head, double margin_mm) {
  constexpr double kTolerance = 1e-6;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const StandingPart& printed = parts[order[k]];
    const Box3 tips = carriageBox(grown(printed.boxBesides(), margin_mm), printed.nozzles_mm);
    for (const MachineBody& body : head.bodies) {
      const Box3 swept = sweptBox(body, tips, head.axes_from_bed);
      for (std::size_t before = 0; before < k; ++before) {
        const StandingPart& finished = parts[order[before]];
        if (collide(swept, grown(finished.boxOnBed(), margin_mm), kTolerance))
          refuse(printed, finished, body, swept.low.z());
      }
    }
  }
}

}  // namespace lamina
