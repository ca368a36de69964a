// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/layer_trim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

/// Of the layer, in the mean: a distance is taken for as many cells wherever it is.
double meanCell(const LayerCells& cells) {
  double length = 0.0;
  for (const CellRun& run : cells.runs) length += run.length_mm;
  return length / static_cast<double>(cells.size());
}

/// Of each cell in the planned volume of the layer.
std::vector<double> volumeShares(const LayerCells& cells) {
  std::vector<double> shares(cells.size());
  double whole = 0.0;
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      shares[i] = run.cellLength() * cells.height_mm[i] * cells.width_mm[i];
      whole += shares[i];
    }
  }
  for (double& share : shares) share /= whole;
  return shares;
}

std::size_t inCells(double length_mm, double cell_mm) {
  return static_cast<std::size_t>(std::lround(length_mm / cell_mm));
}

}  // namespace

LayerTrim::LayerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid,
                     std::vector<double> amount, const LoopSettings& settings, const TrimSettings& trim)
    : trim_(trim),
      planned_(std::move(amount)),
      amount_(planned_),
      behind_(inCells(settings.sensor_behind_mm, trim.step_mm)),
      lead_(inCells(settings.trim_lead_mm, trim.step_mm)),
      volume_(volumeShares(cells)),
      layer_volume_(settings.layer_volume),
      least_(settings.least_amount),
      greatest_(settings.greatest_amount) {
  for (std::size_t i = 0; i < planned_.size(); ++i) change_ += volume_[i] * planned_[i];
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // Over ground that is not known, how low a cell is says nothing of its growth.
    predicted_mm_.push_back(laid[i].isKnown() ? laid[i].error() : std::numeric_limits<double>::quiet_NaN());
    growth_mm_.push_back(laid[i].gain() * cells.height_mm[i] * (1.0 + planned_[i]));
  }
}

/// Of growth: positive where it grew more than was expected without trims.
std::optional<double> LayerTrim::relativeError(std::size_t cell,
                                               const std::vector<CellEstimate>& estimates) const {
  if (!estimates[cell].isSeen() || !(growth_mm_[cell] > 0.0)) return std::nullopt;
  return (predicted_mm_[cell] - estimates[cell].error()) / growth_mm_[cell];
}

double LayerTrim::withinVolume(double trim, std::size_t from) {
  for (; handed_ < std::min(from, planned_.size()); ++handed_) {
    change_ += volume_[handed_] * (amount_[handed_] - planned_[handed_]);
    volume_ahead_ -= volume_[handed_];
  }
  if (handed_ == planned_.size() || !(volume_ahead_ > 0.0)) return trim;
  return std::clamp(trim, std::min(0.0, -(layer_volume_ + change_) / volume_ahead_),
                    std::max(0.0, (layer_volume_ - change_) / volume_ahead_));
}

bool LayerTrim::advance(std::size_t laid, const std::vector<CellEstimate>& estimates) {
  bool changes = false;
  for (; laid_ < std::min(laid, planned_.size()); ++laid_) {
    const auto error = laid_ >= behind_ ? relativeError(laid_ - behind_, estimates) : std::nullopt;
    const std::size_t from = laid_ + 1 + lead_;
    const double asked = trim_.advance(error);
    const double trim = withinVolume(asked, from);
    if (trim != asked) trim_.replace(trim);
    if (std::abs(trim - told_) < kLeastChange || from >= planned_.size()) continue;
    told_ = trim;
    changes = true;
    for (std::size_t i = from; i < planned_.size(); ++i)
      amount_[i] = std::clamp(planned_[i] + trim, least_, greatest_);
  }
  return changes;
}

std::optional<LayerTrim> layerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid,
                                   const std::vector<double>& amount, const LoopSettings& settings) {
  const bool is_free = settings.process == LoopProcess::Free;
  if (!is_free || cells.size() == 0) return std::nullopt;
  const auto trim = trimOf(settings, meanCell(cells), 1.0);
  if (!trim) return std::nullopt;
  return LayerTrim(cells, laid, amount, settings, *trim);
}

}  // namespace lamina
