// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

/// What of a job may be changed while it runs, as a share of what is planned or programmed.
enum class JobOverride : std::uint8_t {
  Feed,   ///< speed along the path, of beads and travels
  Flow,   ///< material: extrusion, wire, screw, powder
  Power,  ///< of the laser or arc
};

/// The shares that are taken.
struct OverrideBounds {
  double least = 0.0;
  double most = 0.0;
};

/// Of driver and streamer alike: feed and flow 0.1 to 3, power 0.1 to 2. Power may be no more because that is
/// what grbl takes, and twice a melting power is no correction any more.
constexpr OverrideBounds boundsOf(JobOverride kind) {
  return kind == JobOverride::Power ? OverrideBounds{0.1, 2.0} : OverrideBounds{0.1, 3.0};
}

/// Its name: "feed", "flow" or "power".
const char* nameOf(JobOverride kind);

/// Why a share is not taken: "flow is 4; must be from 0.1 to 3". Empty if it is.
/// @param share  1 is as planned
std::string overrideRefusal(JobOverride kind, double share, const OverrideBounds& bounds);

}  // namespace lamina
