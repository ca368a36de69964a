// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Whether lines of a sparse fill that end beside each other are joined along the border.
enum class LineLink {
  Border,  ///< where the way is at most three times the distance of neighbouring lines
  None,    ///< every line is a run
  UpTo,    ///< where the way is at most a given length
};

struct LineLinks {
  LineLink link = LineLink::Border;
  double longest_mm = 10.0;  ///< of `UpTo`
};

}  // namespace lamina
