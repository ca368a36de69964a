// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/repeat_watch.hpp"

namespace lamina {

bool RepeatWatch::add(double now_s) {
  while (!times_s_.empty() && now_s - times_s_.front() > within_s_) times_s_.pop_front();
  times_s_.push_back(now_s);
  if (times_s_.size() <= most_) return false;
  times_s_.clear();
  return true;
}

}  // namespace lamina
