// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/report/loop_record.hpp"

namespace lamina {

void LoopRecord::add(const LayerOutcome& layer, const std::string& map_digest) {
  LayerRecord record;
  record.figures = layer.figures;
  record.state = layer.state;
  record.map_digest = map_digest;
  record.alarms = layer.alarms;
  const std::size_t cells = layer.cells.size();
  for (std::size_t piece = 0; piece < LayerRecord::kPieces && cells > 0; ++piece) {
    const std::size_t first = piece * cells / LayerRecord::kPieces;
    const std::size_t end = std::max(first + 1, (piece + 1) * cells / LayerRecord::kPieces);
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) sum += layer.cells[i].error_mm;
    record.error_mm[piece] = static_cast<float>(sum / static_cast<double>(end - first));
  }
  layers_.push_back(std::move(record));
  cells_ = layer.cells;
}

}  // namespace lamina
