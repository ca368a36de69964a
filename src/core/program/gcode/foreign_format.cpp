// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/foreign_format.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

struct Format {
  std::string_view start;  ///< bytes that every file of it begins with
  const char* description;
};

constexpr Format kFormats[] = {
    {"GCDE",
     "binary G-code; expected text, as PrusaSlicer writes it with \"Supports binary G-code\" of the printer "
     "off"},
    {"PK\x03\x04", "a ZIP archive, such as 3MF; expected G-code, as a slicer exports it"},
    {"\x1F\x8B", "compressed by gzip; expected the file unpacked"},
};

}  // namespace

void requireTextOfGcode(std::string_view start, const std::string& path) {
  for (const Format& format : kFormats) {
    if (start.substr(0, format.start.size()) == format.start)
      throw FileError("cannot read '" + path + "': it is " + format.description);
  }
  utf8Text(start, path);
}

}  // namespace lamina
