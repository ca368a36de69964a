// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/taught_part.hpp"

#include <limits>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr float kNotSeen = std::numeric_limits<float>::quiet_NaN();

LayerCells cellsAgain(const Toolpath& toolpath, std::size_t layer, double cell_mm) {
  return layerCells(toolpath.layers[layer], layer, cell_mm, normalOfLayers(toolpath));
}

void requireLayersOf(const PartMap& map, const Toolpath& toolpath, const LoopRunSettings& settings) {
  for (std::size_t layer = 0; layer < toolpath.layers.size(); ++layer) {
    const std::size_t cells = cellsAgain(toolpath, layer, settings.cell_mm).size();
    const std::size_t learnt = layer < map.amount.size() ? map.amount[layer].size() : 0;
    if (learnt != cells)
      throw InvalidInput(settings.learned + ": layer " + std::to_string(layer) + " has " +
                         std::to_string(learnt) + " amounts; expected one for each of its " +
                         std::to_string(cells) + " cells, as long as monitor.cell_mm has them");
  }
}

}  // namespace

TaughtPart::TaughtPart(const Toolpath& toolpath, PartIdentity identity, const LoopRunSettings& settings)
    : settings_(settings), identity_(std::move(identity)), layers_(toolpath.layers.size()) {
  if (settings.learned.empty()) return;
  if (settings.loop.process == LoopProcess::Pressed)
    throw InvalidInput("loop.learned is '" + settings.learned +
                       "' with loop.process pressed; expected none: its heights say nothing of amounts");
  before_ = readPartMap(readFile(settings.learned), settings.learned);
  const std::string difference = differenceOf(before_.identity, identity_);
  if (!difference.empty())
    throw InvalidInput(settings.learned + " was learnt from another part: " + difference);
  before_.amount.resize(layers_.size());
  requireLayersOf(before_, toolpath, settings);
}

std::vector<double> TaughtPart::amountsOf(std::size_t layer) const {
  return is_abandoned_ || layer >= before_.amount.size() ? std::vector<double>() : before_.amount[layer];
}

void TaughtPart::begin(const HeightLoop& loop) {
  error_mm_.clear();
  for (const CellEstimate& cell : loop.estimates())
    error_mm_.push_back(cell.isKnown() ? cell.error() : std::numeric_limits<double>::quiet_NaN());
}

void TaughtPart::end(const HeightLoop& loop, const std::vector<double>& amount) {
  if (!teaches()) return;
  Layer layer;
  for (std::size_t i = 0; i < loop.estimates().size(); ++i) {
    const CellEstimate& cell = loop.estimates()[i];
    layer.amount.push_back(static_cast<float>(amount[i]));
    layer.growth_error_mm.push_back(cell.isSeen() ? static_cast<float>(cell.error() - error_mm_[i])
                                                  : kNotSeen);
  }
  layers_.at(loop.cells().layer) = std::move(layer);
}

bool TaughtPart::teaches() const {
  const bool is_free = settings_.loop.process == LoopProcess::Free;
  return is_free && !is_abandoned_ && !identity_.machine.empty() && !identity_.material.empty();
}

void TaughtPart::abandon() { is_abandoned_ = true; }

std::optional<PartMap> TaughtPart::learnt(const Toolpath& toolpath, PartEnd end) const {
  if (!teaches()) return std::nullopt;
  std::vector<DepositedLayer> part;
  for (std::size_t k = 0; k < layers_.size(); ++k) {
    DepositedLayer layer{cellsAgain(toolpath, k, settings_.cell_mm), {}, {}};
    if (layers_[k].amount.size() != layer.cells.size()) return std::nullopt;
    layer.amount.assign(layers_[k].amount.begin(), layers_[k].amount.end());
    layer.growth_error_mm.assign(layers_[k].growth_error_mm.begin(), layers_[k].growth_error_mm.end());
    part.push_back(std::move(layer));
  }
  return learntFromPart(before_, identity_, part, end, settings_.loop);
}

}  // namespace lamina
