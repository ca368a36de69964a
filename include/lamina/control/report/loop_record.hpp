// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// The record of a layer. Apart from the alarms, its size does not depend on the number of cells.
struct LayerRecord {
  /// Number of equal shares of the cells, in the order of deposition.
  static constexpr std::size_t kPieces = 200;

  LayerFigures figures;
  LoopState state = LoopState::Off;
  std::string map_digest;  ///< digest of the map with which the layer was deposited
  std::vector<RaisedAlarm> alarms;
  std::array<float, kPieces> error_mm{};  ///< mean height error of each piece
};

/// The record of a print with the loop: all layers, and the cells of the last layer.
class LoopRecord {
 public:
  LoopRecord() = default;
  LoopRecord(std::string part_name, std::string toolpath_id)
      : part_name_(std::move(part_name)), toolpath_id_(std::move(toolpath_id)) {}

  void add(const LayerOutcome& layer, const std::string& map_digest);

  const std::string& partName() const { return part_name_; }
  const std::string& toolpathId() const { return toolpath_id_; }
  const std::vector<LayerRecord>& layers() const { return layers_; }
  /// The cells of the last layer.
  const std::vector<CellOutcome>& cells() const { return cells_; }

 private:
  std::string part_name_;
  std::string toolpath_id_;
  std::vector<LayerRecord> layers_;
  std::vector<CellOutcome> cells_;
};

}  // namespace lamina
