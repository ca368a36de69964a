// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/foreign_format.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string whyNoGcode(std::string_view start) {
  try {
    requireTextOfGcode(start, "part.gcode");
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

/// The first bytes as their specifications state them: binary G-code's magic number, ZIP's local file header,
/// the member header of gzip (RFC 1952), the byte order marks of UTF-16.
TEST(ForeignFormat, IsNamedWithWhatToDo) {
  EXPECT_EQ(whyNoGcode(std::string_view("GCDE\x01\x00\x00\x00", 8)),
            "cannot read 'part.gcode': it is binary G-code; expected text, as PrusaSlicer writes it with "
            "\"Supports binary G-code\" of the printer off");
  EXPECT_NE(whyNoGcode("PK\x03\x04rest").find("it is a ZIP archive, such as 3MF"), std::string::npos);
  EXPECT_NE(whyNoGcode("\x1F\x8B\x08").find("it is compressed by gzip"), std::string::npos);
  EXPECT_NE(whyNoGcode(std::string_view("\xFF\xFEG\x00", 4)).find("it is text in UTF-16"), std::string::npos);
}

TEST(ForeignFormat, IsNoGcode) {
  for (const std::string_view start : {"", "G", "G28\n", "GC", "; GCDE", "PK", "\xEF\xBB\xBFG28", "%\n"})
    EXPECT_EQ(whyNoGcode(start), "") << start;
}

}  // namespace
}  // namespace lamina
