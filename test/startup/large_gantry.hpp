// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/atomic_file.hpp"
#include "lamina/startup/startup_settings.hpp"
#include "lamina/streaming/emulator/emulated_settings.hpp"

namespace lamina::test {

/// Sets the keys of a shipped configuration that begin with a prefix.
inline void applyShipped(SettingsSchema& schema, const std::string& file, const std::string& prefix) {
  const std::string path = std::string(LAMINA_SOURCE_DIR) + "/config/" + file;
  for (const SettingText& setting : settingsFromYaml(readFile(path), path))
    if (setting.key.compare(0, prefix.size(), prefix) == 0) schema.set(setting.key, setting.text);
}

/// The start-up that is shipped for the large gantry.
inline StartupSettings largeGantry() {
  StartupSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applyShipped(schema, "large_gantry_45_startup.yaml", "startup.");
  return settings;
}

/// The emulated machine that is shipped for it.
inline EmulatedSettings emulatedLargeGantry() {
  EmulatedSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applyShipped(schema, "large_gantry_45_emulator.yaml", "emulator.");
  return settings;
}

}  // namespace lamina::test
