// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/layer_height_csv.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(LayerHeightCsv, HasOneRowALayer) {
  EXPECT_EQ(
      layerHeightCsv({{4, 1.0, {-0.0125, 0.02, 0.25, 0.75, 1200}, LayerSight::Seen, 31},
                      {5, 1.5, {0.0125, 0.02, 0.25, 0.5, 800}, LayerSight::CutShort, 12}}),
      "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells,profiles,sight\n"
      "4,1,-0.0125,0.02,0.25,0.75,1200,31,seen\n"
      "5,1.5,0.0125,0.02,0.25,0.5,800,12,cut_short\n");
}

TEST(LayerHeightCsv, ALayerThatWasNotSeenHasNoErrors) {
  EXPECT_EQ(
      layerHeightCsv({{77, 23.4, {}, LayerSight::NotSeen, 0}}),
      "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells,profiles,sight\n"
      "77,23.4,,,,0,0,0,not_seen\n");
}

TEST(LayerHeightCsv, WithoutLayersIsTheHeaderAlone) {
  EXPECT_EQ(
      layerHeightCsv({}),
      "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells,profiles,sight\n");
}

}  // namespace
}  // namespace lamina
