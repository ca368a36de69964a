// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/motion_time.hpp"

#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

MotionTime::MotionTime()
    : reader_(GcodeReaderSettings{}, {[this](const GcodeMotion& motion) {
                                        const double length = (motion.end - motion.start).norm();
                                        if (motion.feed_mm_s > 0.0) seconds_ += length / motion.feed_mm_s;
                                      },
                                      [](std::size_t, double) {},
                                      [](std::size_t, std::string_view) {},
                                      {}}) {}

double MotionTime::secondsOf(std::string_view command) {
  seconds_ = 0.0;
  if (!is_readable_) return 0.0;
  try {
    reader_.read(std::string(command) + "\n");
  } catch (const Error&) {
    is_readable_ = false;
    return 0.0;
  }
  return seconds_;
}

}  // namespace lamina
