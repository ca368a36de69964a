// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// An isotropic linear-elastic material.
struct ElasticMaterial {
  double youngs_modulus_mpa = 3861.0;  ///< the default is that of the polylactide in [Vega2023, table 12]
  double poissons_ratio = 0.35;        ///< below 0.5; above 0.49 elements of eight nodes lock

  /// Lamé's first constant [MPa].
  double lambda() const {
    return youngs_modulus_mpa * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio));
  }
  /// Shear modulus [MPa].
  double mu() const { return youngs_modulus_mpa / (2.0 * (1.0 + poissons_ratio)); }
};

}  // namespace lamina
