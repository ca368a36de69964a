// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/flattening_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, FlatteningSettings& settings) {
  schema.choice<FlatteningMethod>(
      "flattening.method", settings.method,
      {{"arap", FlatteningMethod::Arap},
       {"landmark_mds", FlatteningMethod::Mds},
       {"smacof", FlatteningMethod::Stress}},
      "Parameterization of a curved layer: as rigid as possible, landmark multidimensional scaling, "
      "or stress majorisation.");
  schema.renamedChoice("flattening.method", "rigid", "arap");
  schema.renamedChoice("flattening.method", "mds", "landmark_mds");
  schema.renamedChoice("flattening.method", "stress", "smacof");
  schema.integer("flattening.landmarks", settings.landmarks, {4.0, 100000.0},
                 "Vertices from which geodesic distances are taken; pieces with fewer vertices use all.");
  schema.number("flattening.tolerance", settings.tolerance, {0.001, 0.5},
                "Share by which lengths on the layer may differ from those in its parameterization; beyond "
                "it the layer is cut.");
}

}  // namespace lamina
