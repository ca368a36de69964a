// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/equivalent_modulus.hpp"

namespace lamina {

double compressionModulus(double force_n, double length_mm, double area_mm2, double compression_mm) {
  return force_n * length_mm / (area_mm2 * compression_mm);
}

double bendingModulus(double force_n, double span_mm, double deflection_mm, const BeamSection& section) {
  const double h = section.height_mm;
  return force_n * span_mm * span_mm * span_mm / (4.0 * deflection_mm * section.width_mm * h * h * h);
}

}  // namespace lamina
