// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/layer_volume.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(LayerVolume, IsAreaByMeanHeight) {
  LayerSurface wedge;
  wedge.middle.vertices = {{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 3.0, 0.0}, {0.0, 3.0, 0.0}};
  wedge.middle.triangles = {{0, 1, 2}, {0, 2, 3}};
  wedge.height_mm = {0.2, 0.4, 0.4, 0.2};
  EXPECT_NEAR(volume(wedge), 12.0 * 0.3, 1e-12);
  EXPECT_NEAR(volume(std::vector<LayerSurface>{wedge, wedge}), 2.0 * 12.0 * 0.3, 1e-12);
  EXPECT_EQ(volume(LayerSurface{}), 0.0);
}

}  // namespace
}  // namespace lamina
