// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/stated_unit.hpp"

#include <array>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/geometry/svg/svg_reader.hpp"
#include "mesh_formats.hpp"

namespace lamina {
namespace {

std::string nameOf(LengthUnit wanted) {
  for (const auto& [name, unit] : lengthUnits())
    if (unit == wanted) return name;
  return "";
}

[[noreturn]] void refuse(const std::string& option, LengthUnit unit, const std::string& because) {
  throw InvalidConfig(option + " is " + nameOf(unit) + ", but " + because);
}

}  // namespace

void requireUnitUnstated(const std::string& path, LengthUnit unit, const std::string& option) {
  if (unit == LengthUnit::Millimetre) return;
  const std::string kept =
      "; expected " + nameOf(LengthUnit::Millimetre) + ", the default, which leaves that of the ";
  if (isPartName(path))
    refuse(option, unit, "'" + path + "' is a part whose lengths are in mm" + kept + "part");
  if (isSvgName(path))
    refuse(option, unit, "'" + path + "' is an SVG file, which states its own unit" + kept + "file");
  InputFile file(path);
  // What is read from a pipe is gone for whoever reads the mesh.
  if (file.size() == 0) return;
  std::array<char, kBinaryStlStart> buffer{};
  const std::string_view start(buffer.data(), file.read(buffer.data(), buffer.size()));
  if (!isThreemf(start) && !isStep(start)) return;
  refuse(option, unit,
         "'" + path + "' is a " + (isStep(start) ? "STEP" : "3MF") + " file, which states its own unit" +
             kept + "file");
}

}  // namespace lamina
