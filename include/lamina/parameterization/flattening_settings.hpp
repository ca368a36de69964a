// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a curved layer gets its parameterization.
enum class FlatteningMethod {
  Arap,    ///< what unrolls is unrolled; otherwise triangles keep their shape as well as they can
  Mds,     ///< classical multidimensional scaling of geodesic distances
  Stress,  ///< least error of the lengths of sides and of geodesic distances
};

/// How curved layers are laid out flat.
struct FlatteningSettings {
  FlatteningMethod method = FlatteningMethod::Arap;
  int landmarks = 8;
  double tolerance = 0.15;
};

void describe(SettingsSchema& schema, FlatteningSettings& settings);

}  // namespace lamina
