// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/error.hpp"
#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/upload/print_server.hpp"

namespace lamina {

std::string PrintServer::otherOutputsOff() const {
  const UsedOutputs& outputs = order_->body.outputs();
  std::string lines;
  for (const auto& commands : {outputs.beamOff(), outputs.airOff()})
    for (const std::string& command : commands)
      if (command != "M107") lines += command + "\n";
  return lines;
}

std::vector<std::unique_ptr<PrintServer>> printServers(const std::string& firmware,
                                                       const std::shared_ptr<const UploadOrder>& order) {
  std::vector<std::unique_ptr<PrintServer>> servers;
  for (const auto make : {makeMoonraker, makeDuetWithComputer, makeDuet}) {
    auto server = make(order);
    if (firmware == kAnyFirmware || firmware == server->firmware()) servers.push_back(std::move(server));
  }
  if (!servers.empty()) return servers;
  throw InvalidConfig("stream.firmware is " + firmware +
                      ", which is not spoken to over http://; expected auto, klipper or reprapfirmware");
}

}  // namespace lamina
