// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>

namespace lamina {

/// Reports when an event has occurred too often: more than `most` times within `within_s`.
class RepeatWatch {
 public:
  RepeatWatch(std::size_t most, double within_s) : most_(most), within_s_(within_s) {}

  /// Counts an event.
  /// @return true if it has now occurred too often; counting then starts anew
  bool add(double now_s);

 private:
  std::size_t most_;
  double within_s_;
  std::deque<double> times_s_;
};

}  // namespace lamina
