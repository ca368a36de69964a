// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace lamina {

/// Greatest frequency of an event: `burst` at once, and `per_second` in the long run.
struct Rate {
  double per_second = 20.0;
  double burst = 40.0;
};

/// Limits events of several sources, such as addresses of clients, to the same rate, each source by itself
/// (token bucket). At most 1024 sources are remembered; the ones without events for the longest time are
/// forgotten first.
class RateLimit {
 public:
  explicit RateLimit(Rate rate) : rate_(rate) {}

  /// Counts an event, if the rate allows it.
  /// @return false if it does not
  bool take(const std::string& source, double now_s);

  /// Whether the rate allows an event now.
  bool hasLeft(const std::string& source, double now_s) const;

 private:
  struct Taken {
    double amount = 0.0;  ///< at `at_s`; runs down by the rate
    double at_s = 0.0;
  };
  double takenOf(const std::string& source, double now_s) const;
  void forgetOld(double now_s);

  Rate rate_;
  std::map<std::string, Taken> taken_;
};

}  // namespace lamina
