// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "unanswered_order.hpp"

#include <utility>

namespace lamina {

bool UnansweredOrder::give(const std::string& order, double now_s) {
  if (order_ == order) return false;
  order_ = order;
  given_s_ = now_s;
  return true;
}

void UnansweredOrder::answer(const std::string& order) {
  if (order_ == order) order_.clear();
}

std::string UnansweredOrder::take(double now_s, double patience_s) {
  if (order_.empty() || now_s - given_s_ <= patience_s) return "";
  return std::exchange(order_, {});
}

}  // namespace lamina
