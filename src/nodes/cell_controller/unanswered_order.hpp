// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// An order that was given and not answered yet. Times are of one clock [s].
class UnansweredOrder {
 public:
  /// @return whether the order is new, not the one already under way
  bool give(const std::string& order, double now_s);
  void answer(const std::string& order);
  /// The order that was not answered for `patience_s`; returned once, empty if there is none.
  std::string take(double now_s, double patience_s);

 private:
  std::string order_;  ///< empty: none
  double given_s_ = 0.0;
};

}  // namespace lamina
