// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/cell_atlas.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "control/cell_sheet.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

CellAtlas::CellAtlas(double window_layers) : window_layers_(window_layers) {
  if (!(window_layers > 0.0) || !std::isfinite(window_layers))
    throw InvalidInput("cells reach " + numberText(window_layers) +
                       " layer heights; expected a positive reach");
}
CellAtlas::CellAtlas(CellAtlas&&) noexcept = default;
CellAtlas& CellAtlas::operator=(CellAtlas&&) noexcept = default;
CellAtlas::~CellAtlas() = default;

void CellAtlas::add(std::shared_ptr<const LayerCells> cells) {
  if (!cells) throw InvalidInput("a layer without cells is added to an atlas; expected cells");
  const auto at = std::lower_bound(
      sheets_.begin(), sheets_.end(), cells->layer,
      [](const CellSheet& sheet, std::size_t layer) { return sheet.cells()->layer < layer; });
  CellSheet sheet(std::move(cells), window_layers_);
  if (at != sheets_.end() && at->cells()->layer == sheet.cells()->layer)
    *at = std::move(sheet);
  else
    sheets_.insert(at, std::move(sheet));
}

const CellSheet* CellAtlas::sheetOf(std::size_t layer) const {
  for (const CellSheet& sheet : sheets_)
    if (sheet.cells()->layer == layer) return &sheet;
  return nullptr;
}

void CellAtlas::setDeposited(std::size_t layer, std::size_t cells) {
  for (CellSheet& sheet : sheets_)
    if (sheet.cells()->layer == layer) sheet.deposited = std::min(cells, sheet.cells()->size());
}

void CellAtlas::forgetBelow(std::size_t layer) {
  const auto kept = std::find_if(sheets_.begin(), sheets_.end(),
                                 [&](const CellSheet& sheet) { return sheet.cells()->layer >= layer; });
  sheets_.erase(sheets_.begin(), kept);
}

PointSights CellAtlas::look(const Point3& point) const {
  PointSights sights;
  sights.newest = newestAt(point);
  if (sights.newest) sights.below = belowAt(point, sights.newest->layer);
  return sights;
}

std::optional<CellSight> CellAtlas::newestAt(const Point3& point) const {
  std::optional<CellSight> sight;
  for (auto sheet = sheets_.rbegin(); sheet != sheets_.rend() && !sight; ++sheet) sight = sheet->look(point);
  return sight;
}

std::vector<std::optional<CellSight>> CellAtlas::newestAt(const std::vector<Point3>& points) const {
  if (sheets_.empty()) return std::vector<std::optional<CellSight>>(points.size());
  const CellSheet& newest = sheets_.back();
  std::vector<std::optional<CellSight>> sights = newest.look(points);
  for (std::size_t i = 0; i < points.size() && sheets_.size() > 1; ++i)
    if (!sights[i]) sights[i] = belowAt(points[i], newest.cells()->layer);
  return sights;
}

std::optional<CellSight> CellAtlas::belowAt(const Point3& point, std::size_t layer) const {
  std::optional<CellSight> sight;
  for (auto sheet = sheets_.rbegin(); sheet != sheets_.rend() && !sight; ++sheet)
    if (sheet->cells()->layer < layer) sight = sheet->look(point);
  return sight;
}

std::shared_ptr<const LayerCells> CellAtlas::cellsOf(std::size_t layer) const {
  const CellSheet* sheet = sheetOf(layer);
  return sheet ? sheet->cells() : nullptr;
}

bool CellAtlas::isPlane(std::size_t layer) const {
  const CellSheet* sheet = sheetOf(layer);
  return sheet && sheet->isPlane();
}

std::vector<std::size_t> CellAtlas::layers() const {
  std::vector<std::size_t> layers;
  layers.reserve(sheets_.size());
  for (const CellSheet& sheet : sheets_) layers.push_back(sheet.cells()->layer);
  return layers;
}

std::size_t CellAtlas::bytes() const {
  std::size_t bytes = 0;
  for (const CellSheet& sheet : sheets_) bytes += sheet.bytes();
  return bytes;
}

}  // namespace lamina
