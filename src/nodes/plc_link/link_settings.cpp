// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "link_settings.hpp"
#include "lamina/base/text.hpp"

namespace lamina {

void describe(SettingsSchema& schema, LinkSettings& settings) {
  schema.text("modbus.bind", settings.bind,
              "Address to listen on; Modbus knows no passwords, so that any but 127.0.0.1 needs a network of "
              "its own.");
  schema.integer("modbus.port", settings.port, {0, 65535}, "Port to listen on; 0 for any that is free.");
  schema.integer("modbus.connections", settings.connections, {1, 32}, "Connections at once.");
  schema.text("modbus.allow", settings.allow, "Addresses that may connect, commas between.");
  schema.choice<WordOrder>("modbus.word_order", settings.link.word_order,
                           {{"high_first", WordOrder::HighFirst}, {"low_first", WordOrder::LowFirst}},
                           "Which word of 32-bit values stands in the lower register.");
  schema.number("modbus.watchdog_s", settings.link.watchdog_s, {0.5, 10.0},
                "Time without a change of the PLC's heartbeat after which it counts as lost.");
  schema.choice<WatchdogAction>(
      "modbus.watchdog_action", settings.on_silence,
      {{"hold", WatchdogAction::Hold}, {"stop", WatchdogAction::Stop}, {"none", WatchdogAction::None}},
      "What the unit does when the PLC's heartbeat is lost.");
  schema.number("modbus.abandon_s", settings.link.abandon_s, {1.0, 86400.0},
                "Time without a heartbeat after which a unit that is held is stopped.");
}

ModbusServerSettings serverSettings(const LinkSettings& settings) {
  ModbusServerSettings server;
  server.bind = settings.bind;
  server.port = static_cast<std::uint16_t>(settings.port);
  server.connections = static_cast<std::size_t>(settings.connections);
  server.allow = listEntries(settings.allow);
  return server;
}

}  // namespace lamina
