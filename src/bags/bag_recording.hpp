// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/calibration/sensor_recording.hpp"
#include "names.hpp"

namespace lamina {

/// Names in a bag, without the namespace they stand in.
struct BagNames {
  std::string profile = names::kProfile;
  std::string bed = names::kBedFrame;
  std::string nozzle = names::kNozzleFrame;
};

/// What a bag holds of a machine and its sensor.
struct BagRecording {
  SensorRecording recording;
  std::uint64_t malformed = 0;            ///< clouds without the fields or bytes a cloud needs
  std::uint64_t points_not_finite = 0;    ///< left out
  std::uint64_t stamps_without_pose = 0;  ///< of tf, at which it does not place the nozzle
};

/// Reads poses of the nozzle from tf, at each stamp that it reports, and profiles as clouds in their own
/// frame. Memory for tf is bounded; that of the result is not.
/// @throws FileError if it is no bag; InvalidInput if there is no pose of the nozzle or no profile
BagRecording readBagRecording(const std::string& path, const BagNames& names);

}  // namespace lamina
