// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/contour/vase_settings.hpp"

#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {
namespace {

std::vector<std::string> baseStrategies() {
  std::vector<std::string> names;
  for (const std::string& name : infillStrategyNames()) {
    const InfillStrategy strategy = infillStrategy(name);
    if (strategy.deposit == Deposit::Bead && strategy.link != LayerLink::Rising) names.push_back(name);
  }
  return names;
}

}  // namespace

void describe(SettingsSchema& schema, VaseSettings& settings) {
  schema.integer("vase.base_layers", settings.base_layers, {0, 100000},
                 "Solid layers below the rising wall of infill.strategy vase.");
  schema.choice("vase.base_strategy", settings.base_strategy, baseStrategies(),
                "How these layers are filled.");
}

}  // namespace lamina
