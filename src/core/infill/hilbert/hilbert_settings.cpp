// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/hilbert/hilbert_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, HilbertSettings& settings) {
  schema.integer("hilbert.angles", settings.angles, {1, 3600},
                 "Turns of the curve that are tried for the fewest jumps.");
}

}  // namespace lamina
