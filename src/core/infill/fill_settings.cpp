// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/fill_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, FillSettings& settings) {
  describe(schema, settings.raster);
  describe(schema, settings.hybrid);
  describe(schema, settings.perimeters);
  describe(schema, settings.contour);
  describe(schema, settings.vase);
  describe(schema, settings.hilbert);
  describe(schema, settings.lightning);
  describe(schema, settings.drops);
  describe(schema, settings.smoothing);
}

}  // namespace lamina
