// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/order/anchoring.hpp"

namespace lamina {

void describe(SettingsSchema& schema, AnchorSettings& anchoring) {
  schema.choice<Anchoring>(
      "anchoring.strategy", anchoring.strategy,
      {{"none", Anchoring::None}, {"supported_start", Anchoring::SupportedStart}},
      "Runs of inclined layers begin as deposited, or where bed or the layer before is below them.");
}

}  // namespace lamina
