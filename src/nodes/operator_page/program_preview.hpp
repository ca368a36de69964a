// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lamina/web/cell_desk.hpp"

namespace lamina {

/// The layers of a program as lines, read once for each program. Several threads ask at a time.
class ProgramPreview {
 public:
  /// A layer of a program; nothing if it has no such layer.
  /// @throws Error if it cannot be read, or has more than 256 MB
  std::optional<LayerPreview> layer(const std::string& program, std::int32_t layer);

 private:
  std::mutex mutex_;
  std::string program_;
  std::vector<LayerPreview> layers_;
};

/// All layers of a program, at most a million points of it. Layers are those of the slicer's comments;
/// without any, one begins at each new height that something is deposited at.
/// @throws Error if it cannot be read
std::vector<LayerPreview> previewOf(const std::string& program);

}  // namespace lamina
