// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Cauchy stress [MPa].
struct Stress {
  float xx = 0.0F;
  float yy = 0.0F;
  float zz = 0.0F;
  float xy = 0.0F;
  float yz = 0.0F;
  float zx = 0.0F;

  /// Von Mises stress [MPa]: uniaxial stress with the same energy of distortion.
  float vonMises() const;
};

}  // namespace lamina
