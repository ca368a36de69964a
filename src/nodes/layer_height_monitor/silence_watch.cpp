// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "silence_watch.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr double kLongestGlance = 0.1;  // s between two looks that count

}  // namespace

bool SilenceWatch::look(std::uint64_t news, double now_s) {
  const double since_s = std::clamp(now_s - looked_at_s_, 0.0, kLongestGlance);
  silent_s_ = news == news_ ? silent_s_ + since_s : 0.0;
  news_ = news;
  looked_at_s_ = now_s;
  return longest_s_ > 0.0 && silent_s_ > longest_s_;
}

}  // namespace lamina
