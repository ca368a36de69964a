// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/cell/plc_watch.hpp"
#include "lamina/modbus/modbus_server.hpp"
#include "lamina/modbus/plc_link.hpp"

namespace lamina {

/// Parameters of the node plc_link.
struct LinkSettings {
  std::string bind = "127.0.0.1";
  int port = 1502;  ///< 0 for any that is free
  int connections = 4;
  std::string allow = "127.0.0.1";  ///< addresses, separated by commas
  PlcLinkSettings link;
  WatchdogAction on_silence = WatchdogAction::Hold;
};

/// Adds the keys modbus.*.
void describe(SettingsSchema& schema, LinkSettings& settings);

/// Address of the server, and the clients that it accepts.
ModbusServerSettings serverSettings(const LinkSettings& settings);

}  // namespace lamina
