// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace lamina {

/// Whether a metadata key of a slicer states where a volume or object came from, and so nothing on how it is
/// printed.
inline bool saysOrigin(std::string_view key) {
  // Keys that end with _ are prefixes.
  constexpr std::array<std::string_view, 8> kOrigins = {
      "name",      "matrix",      "modifier",  "source_",
      "text_info", "volume_type", "mesh_stat", "cura:drop_to_buildplate"};
  return std::any_of(kOrigins.begin(), kOrigins.end(), [&](std::string_view origin) {
    return origin.back() == '_' ? key.substr(0, origin.size()) == origin : key == origin;
  });
}

}  // namespace lamina
