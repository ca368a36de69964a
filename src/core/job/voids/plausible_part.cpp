// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/voids/plausible_part.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "job/voids/part_placing.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Of the deposit; narrow parts and rounding lay a little beside the contour, supports more.
constexpr double kMostOutside = 0.2;
/// Of the covered share of everything.
constexpr double kLeastBorder = 0.7;
/// Of the area of a layer's box.
constexpr double kLeastBox = 0.5;
/// The border is looked at on so many layers.
constexpr std::size_t kPlausibleLayers = 6;

[[noreturn]] void refuse(const VoidReport& report, const VoidJob& job, const std::string& figures) {
  char place[80];
  std::snprintf(place, sizeof place, "%.3f, %.3f mm", report.part.offset.x(), report.part.offset.y());
  throw InvalidInput("part '" + job.part + "' placed at " + place +
                     " does not belong to the program: " + figures + "; check part and offset");
}

std::string percentText(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
  return text;
}

double outsideShare(const VoidReport& report) {
  double outside = 0.0;
  double deposited = 0.0;
  for (const LayerVoids& layer : report.layers) {
    outside += layer.outside_mm2;
    deposited += layer.deposited_mm2;
  }
  return deposited > 0.0 ? outside / deposited : 0.0;
}

struct Coverage {
  double area_mm2 = 0.0;
  double uncovered_mm2 = 0.0;

  void add(const LayerVoids& layer) {
    area_mm2 += layer.area_mm2;
    uncovered_mm2 += layer.uncovered_mm2;
  }
  double share() const { return area_mm2 > 0.0 ? 1.0 - uncovered_mm2 / area_mm2 : 1.0; }
};

void requireCoveredBorder(const Toolpath& program, const VoidReport& report, const VoidJob& job) {
  Coverage whole;
  Coverage border;
  const std::size_t step = 1 + (report.layers.size() - 1) / kPlausibleLayers;
  for (std::size_t i = 0; i < report.layers.size(); i += step) {
    const LayerVoids& layer = report.layers[i];
    const Regions& contour = report.part.contours[i];
    if (!(layer.pitch_mm > 0.0) || contour.empty()) continue;
    whole.add(layer);
    border.add(findVoids(difference(contour, offset(contour, -layer.pitch_mm)), program.layers[i], job.map));
  }
  if (border.share() < kLeastBorder * whole.share())
    refuse(report, job,
           percentText(border.share()) + " of its border are covered and " + percentText(whole.share()) +
               " of all, expected 70 % as much there at least");
}

void requireSize(const Toolpath& program, const VoidReport& report, const VoidJob& job) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < report.layers.size(); ++i) {
    const Box2 cut = boundingBox(outlines(report.part.contours[i]));
    const Box2 deposited = depositedBox(program.layers[i]);
    if (cut.isEmpty() || deposited.isEmpty()) continue;
    shares.push_back(deposited.size().prod() / cut.size().prod());
  }
  if (shares.empty()) refuse(report, job, "no layer of it has any deposit");
  const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
  std::nth_element(shares.begin(), middle, shares.end());
  if (*middle < kLeastBox)
    refuse(report, job,
           "the deposit of a layer takes " + percentText(*middle) +
               " of the box of the part's layer, expected half at least");
}

}  // namespace

void requirePlausible(const Toolpath& program, const VoidReport& report, const VoidJob& job) {
  if (report.layers.empty() || job.part.empty()) return;
  const double outside = outsideShare(report);
  if (outside > kMostOutside)
    refuse(report, job,
           percentText(outside) + " of the deposit lies outside of it, expected " +
               percentText(kMostOutside) + " at most");
  requireSize(program, report, job);
  requireCoveredBorder(program, report, job);
}

}  // namespace lamina
