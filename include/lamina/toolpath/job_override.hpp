// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace lamina {

/// A quantity of a job that can be changed while it runs, as a share of its planned or programmed value.
enum class OverrideKind : std::uint8_t {
  Feed,   ///< speed along the path, of beads and travels
  Flow,   ///< rate of material: extrusion, wire, screw, powder
  Power,  ///< power of the laser or arc
};

/// Bounds of the share to which a quantity can be changed.
struct OverrideBounds {
  double least = 0.0;
  double most = 0.0;
};

/// The bounds of a quantity, the same for driver and streamer: 0.1 to 3 for feed and flow, 0.1 to 2 for
/// power. Grbl allows no more power, and more would be no mere correction.
constexpr OverrideBounds boundsOf(OverrideKind kind) {
  return kind == OverrideKind::Power ? OverrideBounds{0.1, 2.0} : OverrideBounds{0.1, 3.0};
}

/// The name of a quantity: "feed", "flow" or "power".
const char* nameOf(OverrideKind kind);

/// The reason why a share is refused: "flow is 4; must be from 0.1 to 3". Empty if it is accepted.
/// @param share  1 for the planned value
std::string overrideRefusal(OverrideKind kind, double share, const OverrideBounds& bounds);

}  // namespace lamina
