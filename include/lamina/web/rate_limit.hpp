// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace lamina {

/// How many of something may happen: `burst` at once, and `per_second` in the long run.
struct Rate {
  double per_second = 20.0;
  double burst = 40.0;
};

/// Holds each of several sources, such as addresses of clients, to the same rate, each by itself (token
/// bucket). At most 1024 sources are kept: the ones that took nothing for long are forgotten first.
class RateLimit {
 public:
  explicit RateLimit(Rate rate) : rate_(rate) {}

  /// Takes one. @return false if there is none left
  bool take(const std::string& source, double now_s);

  /// True if one is left.
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
