// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/layer_height_csv.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(LayerHeightCsv, HasOneRowALayer) {
  EXPECT_EQ(layerHeightCsv({{4, 1.0, {-0.0125, 0.02, 0.25, 0.75, 1200}}}),
            "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells\n"
            "4,1,-0.0125,0.02,0.25,0.75,1200\n");
}

TEST(LayerHeightCsv, WithoutLayersIsTheHeaderAlone) {
  EXPECT_EQ(layerHeightCsv({}),
            "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells\n");
}

}  // namespace
}  // namespace lamina
