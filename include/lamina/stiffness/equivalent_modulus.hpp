// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Young's modulus [MPa] of a solid body that would bear the same force under the same compression (ISO 604;
/// [Vega2023, eq. 13]): F L0 / (A dL).
double compressionModulus(double force_n, double length_mm, double area_mm2, double compression_mm);

/// Section of a beam.
struct BeamSection {
  double width_mm = 0.0;
  double height_mm = 0.0;  ///< along the load
};

/// Young's modulus [MPa] of a solid beam that would bear the same force at the same deflection half way
/// between two supports (ISO 178; [Vega2023, eq. 6]): F L³ / (4 s b h³).
double bendingModulus(double force_n, double span_mm, double deflection_mm, const BeamSection& section);

}  // namespace lamina
