// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>

namespace lamina {

/// Reports when something has happened too often: more than `most` times within a time.
class RepeatWatch {
 public:
  RepeatWatch(std::size_t most, double within_s) : most_(most), within_s_(within_s) {}

  /// It has happened once more.
  /// @return true if that was once too often; it is counted anew from then on
  bool add(double now_s);

 private:
  std::size_t most_;
  double within_s_;
  std::deque<double> times_s_;
};

}  // namespace lamina
