// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "job/part/part_reading.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

TEST(PartUnit, IsRefusedForAFileThatStatesItsOwn) {
  const test::ScratchFolder folder;
  const std::string part = folder.file("part.step");
  writeFile(part, "ISO-10303-21;\nHEADER;\n");
  InputSettings settings;
  settings.units.unit = LengthUnit::Centimetre;
  NoProgress nobody;
  EXPECT_THROW(readPart(part, settings, nobody), InvalidConfig);
  EXPECT_THROW(readParts(part, settings, nobody), InvalidConfig);
}

}  // namespace
}  // namespace lamina
