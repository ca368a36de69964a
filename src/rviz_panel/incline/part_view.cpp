// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline/part_view.hpp"

#include <algorithm>
#include <utility>

#include "names.hpp"

namespace lamina {
namespace {

constexpr double kGap = 0.25;  // between the parts, of the wider one

}  // namespace

PartView::PartView() : source_(names::kSourceLayers), inclined_(names::kInclinedLayers) {}

void PartView::showSource(DrawnPart part) {
  source_.show(std::move(part));
  source_.moveTo(sourceShift());
}

void PartView::showInclined(DrawnPart part) {
  inclined_.show(std::move(part));
  source_.moveTo(sourceShift());
}

void PartView::removeInclined() { showInclined({}); }

Point3 PartView::sourceShift() const {
  if (!source_.box() || !inclined_.box()) return Point3::Zero();
  const Box3& source = *source_.box();
  const Box3& inclined = *inclined_.box();
  const double gap = kGap * std::max(source.size().y(), inclined.size().y());
  return {0.5 * (inclined.low.x() + inclined.high.x() - source.low.x() - source.high.x()),
          inclined.low.y() - gap - source.high.y(), 0.0};
}

void PartView::showLayers(std::size_t layers) {
  source_.showLayers(layers);
  inclined_.showLayers(layers);
}

std::size_t PartView::layerCount() const { return std::max(source_.layerCount(), inclined_.layerCount()); }

std::optional<Box3> PartView::box() const {
  const std::optional<Box3>& both = inclined_.box();
  if (!source_.box()) return both;
  const Box3 moved{source_.box()->low + sourceShift(), source_.box()->high + sourceShift()};
  if (!both) return moved;
  return Box3{both->low.cwiseMin(moved.low), both->high.cwiseMax(moved.high)};
}

void PartView::poll() {
  source_.poll();
  inclined_.poll();
}

}  // namespace lamina
