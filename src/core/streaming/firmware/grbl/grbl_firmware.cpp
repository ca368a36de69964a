// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/firmware/grbl/grbl_firmware.hpp"

#include <string>
#include <utility>

#include "lamina/base/text.hpp"
#include "streaming/firmware/grbl/grbl_job.hpp"
#include "streaming/firmware/grbl/grbl_syntax.hpp"

namespace lamina {

bool GrblFirmware::isSpokenBy(std::string_view firmware_name) const {
  const std::string name = lowerCase(firmware_name);
  return name.find("grbl") != std::string::npos || name.find("fluidnc") != std::string::npos;
}

std::string GrblFirmware::defectOf(std::string_view command, const StreamSettings& settings) const {
  return defectForAllGrbl(command, settings.max_line_bytes);
}

std::unique_ptr<StreamJob> GrblFirmware::begin(StreamOrder order) const {
  return std::make_unique<GrblJob>(std::move(order));
}

}  // namespace lamina
