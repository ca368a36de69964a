// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Young's modulus [MPa] of a solid body that needs the force F for the compression dL, with the length L0
/// and the cross-section A (ISO 604; [Vega2023, eq. 13]): F L0 / (A dL).
double compressionModulus(double force_n, double length_mm, double area_mm2, double compression_mm);

/// Rectangular cross-section of a beam.
struct BeamSection {
  double width_mm = 0.0;   ///< across the load
  double height_mm = 0.0;  ///< along the load
};

/// Young's modulus [MPa] of a solid beam that needs the force F for the deflection s half way between two
/// supports at the span L, with the width b and the height h (ISO 178; [Vega2023, eq. 6]): F L³ / (4 s b h³).
double bendingModulus(double force_n, double span_mm, double deflection_mm, const BeamSection& section);

}  // namespace lamina
