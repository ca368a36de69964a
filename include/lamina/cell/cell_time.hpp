// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// A time by two clocks.
struct CellTime {
  double steady_s = 0.0;  ///< never goes back; for durations
  double utc_s = 0.0;     ///< since 1970; for the journal, and between hosts
};

}  // namespace lamina
