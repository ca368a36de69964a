// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/layer_cells.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/trailing_trim.hpp"

namespace lamina {

/// Trims the amounts of the layer being deposited by the measurements of a sensor behind the nozzle
/// (`TrailingTrim`), cell by cell in the order of deposition. Cells that are deposited, or already passed on
/// to the machine, keep their amounts.
class LayerTrim {
 public:
  static constexpr double kLeastChange = 0.002;  ///< least change of an amount that is reported

  /// @param laid    estimates of the cells as predicted if the layer is deposited with these amounts
  /// @param amount  relative, one for each cell
  LayerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid, std::vector<double> amount,
            const LoopSettings& settings, const TrimSettings& trim);

  /// States that the nozzle has deposited the first `laid` cells.
  /// @return whether the amounts of cells to come differ from those reported last
  bool advance(std::size_t laid, const std::vector<CellEstimate>& estimates);

  /// The trimmed amounts of all cells, within the limits of the loop: trims may use the part of the layer's
  /// volume change that the layer's map leaves.
  const std::vector<double>& amount() const { return amount_; }

 private:
  std::optional<double> relativeError(std::size_t cell, const std::vector<CellEstimate>& estimates) const;
  double withinVolume(double trim, std::size_t from);

  TrailingTrim trim_;
  std::vector<double> planned_;       ///< amounts without trims
  std::vector<double> amount_;        ///< amounts with trims
  std::vector<double> predicted_mm_;  ///< errors predicted for the amounts without trims
  std::vector<double> growth_mm_;     ///< growth predicted for the amounts without trims
  std::size_t behind_;                ///< distance of the sensor behind the nozzle, in cells
  std::size_t lead_;                  ///< length passed on to the machine ahead of the nozzle, in cells
  std::vector<double> volume_;        ///< share of each cell in the layer's planned volume
  double change_ = 0.0;  ///< of the layer's volume: as handed over up to `handed_`, untrimmed from there
  double volume_ahead_ = 1.0;  ///< share of the layer's volume from `handed_` on
  std::size_t handed_ = 0;     ///< cells that no trim reaches any more
  double layer_volume_;
  double least_;
  double greatest_;
  std::size_t laid_ = 0;
  double told_ = 0.0;  ///< trim reported last
};

/// The trim of a layer; nothing if the settings ask for none, or the layer is too short for it.
std::optional<LayerTrim> layerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid,
                                   const std::vector<double>& amount, const LoopSettings& settings);

}  // namespace lamina
