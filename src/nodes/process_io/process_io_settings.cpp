// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_io_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ProcessIoSettings& settings) {
  describe(schema, settings.tables);
  describe(schema, settings.bridge);
  schema.number("state_hz", settings.state_hz, {1.0, 250.0}, "Process states published a second.");
}

}  // namespace lamina
