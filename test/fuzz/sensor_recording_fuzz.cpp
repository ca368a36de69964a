// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "lamina/calibration/hand_eye.hpp"
#include "lamina/calibration/sensor_recording.hpp"
#include "lamina/calibration/time_offset.hpp"

namespace {

/// Whatever is refused is refused as input.
template <class Read>
void tryReading(Read read) {
  try {
    read();
  } catch (const lamina::InvalidInput&) {
  }
}

}  // namespace

/// Any bytes are read as tables and files of calibration, or refused; what is read is evaluated or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  tryReading([&] { lamina::calibrationFromYaml(std::string(text), "fuzz"); });
  tryReading([&] { lamina::fitHandEye(lamina::sightsFromCsv(text, "fuzz")); });
  tryReading([&] {
    // One text serves as both tables: profiles need no column that poses do not have.
    const lamina::SensorRecording recording{lamina::posesFromCsv(text, "fuzz"),
                                            lamina::profilesFromCsv(text, "fuzz")};
    tryReading([&] { lamina::offsetByBobbing(recording, 0.1); });
    tryReading([&] { lamina::offsetByPasses(recording, {}); });
  });
  return 0;
}
