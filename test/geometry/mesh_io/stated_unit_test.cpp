// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/stated_unit.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::string refusalOf(const std::string& path, LengthUnit unit) {
  try {
    requireUnitUnstated(path, unit, "input.unit");
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

TEST(StatedUnit, RefusesAnotherOfFilesThatStateTheirOwn) {
  const test::ScratchFolder folder;
  const std::string step = folder.file("part.stp");
  const std::string threemf = folder.file("part.3mf");
  writeFile(step, "ISO-10303-21;\nHEADER;\n");
  writeFile(threemf, "PK\x03\x04");
  EXPECT_EQ(refusalOf(step, LengthUnit::Inch),
            "input.unit is inch, but '" + step +
                "' is a STEP file, which states its own unit; expected mm, the default, which leaves that of "
                "the file");
  EXPECT_EQ(refusalOf(threemf, LengthUnit::Metre),
            "input.unit is m, but '" + threemf +
                "' is a 3MF file, which states its own unit; expected mm, the default, which leaves that of "
                "the file");
  EXPECT_EQ(refusalOf(step, LengthUnit::Millimetre), "");
}

TEST(StatedUnit, RefusesAnotherOfOutlinesAndOfPartsByName) {
  EXPECT_EQ(refusalOf("plate.SVG", LengthUnit::Inch),
            "input.unit is inch, but 'plate.SVG' is an SVG file, which states its own unit; expected mm, the "
            "default, which leaves that of the file");
  EXPECT_EQ(refusalOf("box", LengthUnit::Centimetre),
            "input.unit is cm, but 'box' is a part whose lengths are in mm; expected mm, the default, "
            "which leaves that of the part");
  EXPECT_EQ(refusalOf("plate.svg", LengthUnit::Millimetre), "");
  EXPECT_EQ(refusalOf("box", LengthUnit::Millimetre), "");
}

TEST(StatedUnit, LeavesFilesThatStateNone) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.obj");
  writeFile(path, "v 1 0 0\n");
  EXPECT_EQ(refusalOf(path, LengthUnit::Inch), "");
}

}  // namespace
}  // namespace lamina
