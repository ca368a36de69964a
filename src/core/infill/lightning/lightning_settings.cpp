// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/lightning/lightning_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, LightningSettings& settings) {
  schema.number("lightning.angle_deg", settings.angle_deg, {10.0, 80.0},
                "Greatest lean of branches of lightning from the vertical; flatter ones take less material.");
}

}  // namespace lamina
