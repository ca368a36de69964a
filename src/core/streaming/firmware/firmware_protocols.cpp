// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/firmware_protocol.hpp"

#include "lamina/streaming/firmware/grbl/grbl_firmware.hpp"
#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "streaming/firmware/klipper/klipper_firmware.hpp"
#include "streaming/firmware/reprapfirmware/reprap_firmware.hpp"

namespace lamina {

Registry<std::shared_ptr<const FirmwareProtocol>>& firmwareProtocols() {
  static Registry<std::shared_ptr<const FirmwareProtocol>> registry(
      "stream.firmware", {{"grbl", std::make_shared<GrblFirmware>()},
                          {"klipper", std::make_shared<KlipperFirmware>()},
                          {"marlin", std::make_shared<MarlinFirmware>()},
                          {"reprapfirmware", std::make_shared<RepRapFirmware>()}});
  return registry;
}

}  // namespace lamina
