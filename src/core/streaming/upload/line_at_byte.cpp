// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/line_at_byte.hpp"

namespace lamina {

void CommandEnds::add(std::uint64_t end, std::int32_t layer) {
  if (layers_.empty() || layers_.back().layer != layer) layers_.push_back({lines_, layer});
  std::uint64_t distance = end - last_end_;
  for (; distance >= 0x80U; distance >>= 7U) distances_ += static_cast<char>((distance & 0x7FU) | 0x80U);
  distances_ += static_cast<char>(distance);
  last_end_ = end;
  ++lines_;
}

void LineAtByte::rewind() {
  at_ = next_layer_ = 0;
  lines_ = end_ = 0;
  layer_ = -1;
}

/// @param at  where it begins, and then where the next one does
std::uint64_t LineAtByte::nextDistance(std::size_t& at) const {
  std::uint64_t distance = 0;
  for (unsigned shift = 0;; shift += 7U) {
    const auto byte = static_cast<unsigned char>(ends_->distances_[at++]);
    distance |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
    if ((byte & 0x80U) == 0) return distance;
  }
}

std::uint64_t LineAtByte::linesBefore(std::uint64_t byte) {
  if (byte < end_) rewind();
  while (lines_ < ends_->lines_) {
    std::size_t at = at_;
    const std::uint64_t end = end_ + nextDistance(at);
    if (end > byte) break;
    at_ = at;
    end_ = end;
    const std::vector<CommandEnds::LayerBegin>& layers = ends_->layers_;
    if (next_layer_ < layers.size() && layers[next_layer_].line == lines_)
      layer_ = layers[next_layer_++].layer;
    ++lines_;
  }
  return lines_;
}

}  // namespace lamina
