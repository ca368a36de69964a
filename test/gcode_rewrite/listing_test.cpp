// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode_rewrite/transformed.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using test::contains;
using test::transformed;

RewriteSettings asListing(double layer_height_mm) {
  RewriteSettings settings = test::withHeight(layer_height_mm);
  settings.mode = RewriteMode::Listing;
  return settings;
}

TEST(Listing, ThePublishedExampleComesOutByteForByte) {
  EXPECT_EQ(transformed(test::publishedExample(), asListing(1.5)).text,
            "M83\n;LAYER:0\nM107\n"
            "G1 F1200 X0.00 Y-3.18 Z1.50 \n"
            "G0 F18000 X474.33 Y210.40 Z215.08 \n"
            ";MESH:Cubo.stl\n;TYPE:WALL-OUTER\n"
            "G1 F1200 X474.33 Y212.52 Z212.96 \n"
            "G1 F3600 E13.05577\n"
            "G1 F884.2 X475.10 Y212.57 Z213.01 E0.45598\n"
            "G1 F884.3 X650.24 Y212.57 Z213.01 E103.69276\n"
            "G1 X825.38 Y212.57 Z213.01 E103.69276\n");
}

TEST(Listing, LinesThatDoNotMoveAreLeftAlone) {
  const std::string text = transformed(
                               "G28 X0 Y0\nG28 ;Home\nG28\n\n  \nG1 X5 Y5\nG92 E0\nM190 "
                               "S90\n;LAYER:0\nM107\nG10\nG11\nG1 X1 Y2 Z3\n",
                               asListing(0.2))
                               .text;
  EXPECT_EQ(text.substr(0, text.find("G1 X1.00")),
            ";Anulada: G28 X0 Y0\n;Anulada: G28 ;Home\nG28\nG1 X5 Y5\nG92 E0\nM190 "
            "S90\n;LAYER:0\nM107\nG10\nG11\n");
}

TEST(Listing, WhatFollowsTheCoordinatesFollowsThemStill) {
  const std::string text =
      transformed(";LAYER:0\nG1 X0 Y20 Z30\nG1 X10 E5\nG1 Z4.5 F1200\nG1 X10 Y20 ;Zeta\n", asListing(0.2))
          .text;
  EXPECT_TRUE(contains(text, "\nG1 X10.00 Y-7.07 Z18.23 E5\n")) << text;
  EXPECT_TRUE(contains(text, "\nG1 X10.00 Y10.96 Z0.20 F1200\n")) << text;
  EXPECT_TRUE(contains(text, "\nG1 X10.00 Y10.96 Z0.20 ;Zeta\n")) << text;
}

TEST(Listing, Simplify3dIsRotatedToo) {
  EXPECT_TRUE(contains(transformed("; layer 1, Z = 0.3\nG1 X10 Y20 Z30\n", asListing(0.3)).text,
                       "G1 X10.00 Y-7.07 Z0.30 \n"));
}

TEST(Listing, TheEndCodeIsRotatedAsPublished) {
  EXPECT_TRUE(contains(transformed(";LAYER:0\nG1 X0 Y0 Z0\n;End of Gcode\nG1 Y100\n", asListing(0.0001)).text,
                       ";End of Gcode\nG1 X0.00 Y70.71 Z70.71"));
}

TEST(Listing, WhatItWouldLeaveUnrotatedIsRefused) {
  for (const std::string bad : {"G2 X1 Y1 I1", "G91\nG1 X1", "G20\nG1 X1", "g1 X1", "X1 Y1", "G1 Y20 X10 E1",
                                "G1 X10 E1 Y20", "N7 G1 X1"})
    EXPECT_THROW(transformed(";LAYER:0\nG1 X1 Y2 Z3\n" + bad + "\n", asListing(0.2)), InvalidProgram) << bad;
  EXPECT_THROW(transformed("G1 X1 Y2 Z3\n", asListing(0.2)), InvalidProgram);
  EXPECT_THROW(transformed(";LAYER:0\nM107\n", asListing(0.2)), InvalidProgram);
  EXPECT_THROW(transformed(";LAYER:0\nG1 X1\n", asListing(0.2), scaling({2.0, 2.0, 2.0})), InvalidConfig);
}

}  // namespace
}  // namespace lamina
