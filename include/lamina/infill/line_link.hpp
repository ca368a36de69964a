// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Whether neighbouring lines of a sparse fill are joined along the border where they end side by side.
enum class LineLink {
  Border,  ///< if the link is at most three times as long as the distance of the lines
  None,    ///< never: every line is a run of its own
  UpTo,    ///< if the link is at most as long as given
};

/// How lines of a sparse fill are joined.
struct LineLinks {
  LineLink link = LineLink::Border;
  double longest_mm = 10.0;  ///< greatest length of a link, used with `UpTo`
};

}  // namespace lamina
