// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_adapters/refusal_text.hpp"

#include <gtest/gtest.h>

namespace {

TEST(RefusalText, NamesTheRequestAndTheReason) {
  const lamina::Failure failure{lamina::ErrorCode::InvalidMesh, "layer 3 at 0.8 mm, island 1: too thin"};
  EXPECT_EQ(lamina::refusalText({"slice", "cube.stl", "cube.gcode"}, failure),
            "cannot slice 'cube.stl' into 'cube.gcode': InvalidMesh: layer 3 at 0.8 mm, island 1: too thin");
  EXPECT_EQ(lamina::refusalText({"slice", "cube.stl", ""}, failure),
            "cannot slice 'cube.stl': InvalidMesh: layer 3 at 0.8 mm, island 1: too thin");
}

TEST(RefusalText, SaysWhereNothingIsNamed) {
  EXPECT_EQ(lamina::refusalText({"run the study", "", ""}, {lamina::ErrorCode::FileError, "no file"}),
            "cannot run the study nothing named: FileError: no file");
}

}  // namespace
