// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tf/frames.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {

/// The frame of the calibrated sensor among the frames of all clouds: `names::kSensorFrame` or, until a cloud
/// of this frame arrives, the frame that arrived first. A leading slash of a frame is ignored.
class CalibratedFrame {
 public:
  /// Adds the frame of an arrived cloud.
  /// @return whether the calibration belongs to this frame's sensor
  bool see(const std::string& frame) {
    const std::string bare = bareFrame(frame);
    if (frame_.empty() || bare == names::kSensorFrame) frame_ = bare;
    return bare == frame_;
  }

  /// Whether the calibration belongs to the sensor of that frame, judged by the frames so far.
  bool is(const std::string& frame) const { return !frame_.empty() && bareFrame(frame) == frame_; }

 private:
  std::string frame_;  ///< empty before the first cloud
};

}  // namespace lamina
