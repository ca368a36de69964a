// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/random.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Random numbers that differ for each layer, each island in it and each region of that island.
/// @param seed  as in the settings
inline Random randomOf(int seed, const InfillRequest& request, std::size_t region) {
  Random random(static_cast<std::uint64_t>(seed));
  for (const std::size_t index : {request.layer, request.island, region})
    random = Random(random.bits() + index);
  return random;
}

}  // namespace lamina
