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

/// Trims the amounts of a layer under way by the measurements of a sensor behind the nozzle (`TrailingTrim`),
/// cell by cell in the order of laying. Cells that are deposited, or already handed over to the machine, keep
/// their amounts.
class LayerTrim {
 public:
  static constexpr double kLeastChange = 0.002;  ///< of an amount, below which none is reported

  /// @param laid    predicted estimates of the cells, for a layer deposited with these amounts
  /// @param amount  relative, one per cell
  LayerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid, std::vector<double> amount,
            const LoopSettings& settings, const TrimSettings& trim);

  /// States that the nozzle has deposited that many cells.
  /// @return whether the amounts of cells to come differ from those reported last
  bool advance(std::size_t laid, const std::vector<CellEstimate>& estimates);

  /// The amounts of all cells with trims, within the limits of the loop.
  const std::vector<double>& amount() const { return amount_; }

 private:
  std::optional<double> relativeError(std::size_t cell, const std::vector<CellEstimate>& estimates) const;

  TrailingTrim trim_;
  std::vector<double> planned_;       ///< amounts without trims
  std::vector<double> amount_;        ///< with them
  std::vector<double> predicted_mm_;  ///< errors by the amounts without trims
  std::vector<double> growth_mm_;     ///< likewise
  std::size_t behind_;                ///< distance of the sensor behind the nozzle, in cells
  std::size_t lead_;                  ///< length handed over ahead of the nozzle, in cells
  double least_;
  double greatest_;
  std::size_t laid_ = 0;
  double told_ = 0.0;  ///< trim reported last
};

/// The trim of a layer; none if the settings ask for none, or the layer is too short for it.
std::optional<LayerTrim> layerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid,
                                   const std::vector<double>& amount, const LoopSettings& settings);

}  // namespace lamina
