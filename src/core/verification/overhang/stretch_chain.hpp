// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/verification/overhang/overhang.hpp"

namespace lamina {

/// A piece of a bead that is carried or not as a whole.
struct DepositedPiece {
  WaypointIndex at;
  PathRole role = PathRole::Infill;
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, part frame]
  Point3 end = Point3::Zero();
  Bead section;
  double length_mm = 0.0;
  bool is_carried = false;
};

/// Joins pieces in the order in which they are deposited to runs and stretches.
class StretchChain {
 public:
  /// @param layers  of the toolpath
  explicit StretchChain(std::size_t layers) { report_.layers.resize(layers); }

  /// A piece that does not start where the one before ended begins another run.
  void lay(const DepositedPiece& piece);
  /// Nothing is deposited for a while.
  void stop();
  /// All that was deposited; the chain is empty afterwards.
  OverhangReport finish();

 private:
  void close(StretchKind kind);
  StretchKind kindIfCarriedAgain() const;

  OverhangReport report_;
  std::optional<Point3> end_;                  ///< of the run under way
  WaypointIndex last_;                         ///< of the stretch's last piece
  std::optional<UnsupportedStretch> stretch_;  ///< under way
};

}  // namespace lamina
