// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// What is kept of a layer: its size does not depend on that of the layer.
struct LayerRecord {
  static constexpr std::size_t kPieces = 200;  ///< equal parts of the layer's cells, as the nozzle comes by

  LayerFigures figures;
  LoopState state = LoopState::Off;
  std::string map_digest;  ///< of the correction that the layer was laid with
  std::vector<RaisedAlarm> alarms;
  std::array<float, kPieces> error_mm{};  ///< mean of each piece
};

/// What is kept of a print under the loop, layer by layer, and cell by cell of the last layer.
class LoopRecord {
 public:
  LoopRecord() = default;
  LoopRecord(std::string part_name, std::string toolpath_id)
      : part_name_(std::move(part_name)), toolpath_id_(std::move(toolpath_id)) {}

  void add(const LayerOutcome& layer, const std::string& map_digest);

  const std::string& partName() const { return part_name_; }
  const std::string& toolpathId() const { return toolpath_id_; }
  const std::vector<LayerRecord>& layers() const { return layers_; }
  /// Of the last layer.
  const std::vector<CellOutcome>& cells() const { return cells_; }

 private:
  std::string part_name_;
  std::string toolpath_id_;
  std::vector<LayerRecord> layers_;
  std::vector<CellOutcome> cells_;
};

}  // namespace lamina
