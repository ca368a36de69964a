// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/run_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, RunSettings& settings) {
  describe(schema, settings.joints);
  describe(schema, settings.timing.motion);
  describe(schema, settings.timing.trajectory);
  describe(schema, settings.timing.process);
}

void validate(const RunSettings& settings) {
  RunSettings copy = settings;
  SettingsSchema schema;
  describe(schema, copy);
  schema.validate();
  validate(settings.joints);
}

RunSettings runSettings(const JobSettings& settings) {
  return {settings.joints, {settings.motion, settings.trajectory, settings.process}};
}

}  // namespace lamina
