// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a curved layer gets its parameterization.
enum class FlatteningMethod {
  Arap,    ///< a developable surface is unrolled; otherwise triangles keep their shape as well as possible
  Mds,     ///< classical multidimensional scaling of geodesic distances
  Stress,  ///< least squared error of the lengths of sides and of geodesic distances
};

/// How curved layers are flattened.
struct FlatteningSettings {
  FlatteningMethod method = FlatteningMethod::Arap;
  int landmarks = 8;        ///< vertices from which geodesic distances are measured, for Mds and Stress
  double tolerance = 0.15;  ///< share by which lengths on the layer and in the plane may differ
};

/// Adds the keys flattening.*.
void describe(SettingsSchema& schema, FlatteningSettings& settings);

}  // namespace lamina
