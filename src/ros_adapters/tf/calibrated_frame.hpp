// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tf/frames.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {

/// The frame of the sensor that a calibration is that of, among the frames of all clouds:
/// `names::kSensorFrame`, or as long as no cloud of that came, the frame that came first. Frames count with a
/// leading slash as without.
class CalibratedFrame {
 public:
  /// Adds the frame of a cloud that has come.
  /// @return whether the calibration is that of its sensor
  bool see(const std::string& frame) {
    const std::string bare = bareFrame(frame);
    if (frame_.empty() || bare == names::kSensorFrame) frame_ = bare;
    return bare == frame_;
  }

  /// Whether the calibration is that of the sensor with that frame, by the frames so far.
  bool is(const std::string& frame) const { return !frame_.empty() && bareFrame(frame) == frame_; }

 private:
  std::string frame_;  ///< empty before a cloud
};

}  // namespace lamina
