// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streamer_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, GcodeStreamerSettings& settings) {
  schema.text("port", settings.port.name,
              "Serial port or pseudo-terminal, tcp:host:port, or http://host:port of a print server.");
  schema.integer("baud", settings.port.baud, {50, 4000000}, "Baud rate of a serial port.");
  describe(schema, settings.machine, "Machine whose axes the reported positions belong to.");
  describe(schema, settings.stream);
  describe(schema, settings.program);
  describe(schema, settings.startup);
}

}  // namespace lamina
