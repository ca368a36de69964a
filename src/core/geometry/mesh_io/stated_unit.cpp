// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/stated_unit.hpp"

#include <array>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "mesh_formats.hpp"

namespace lamina {
namespace {

std::string nameOf(LengthUnit wanted) {
  for (const auto& [name, unit] : lengthUnits())
    if (unit == wanted) return name;
  return "";
}

}  // namespace

void requireUnitUnstated(const std::string& path, LengthUnit unit, const std::string& option) {
  if (unit == LengthUnit::Millimetre) return;
  InputFile file(path);
  // What is read from a pipe is gone for whoever reads the mesh.
  if (file.size() == 0) return;
  std::array<char, kBinaryStlStart> buffer{};
  const std::string_view start(buffer.data(), file.read(buffer.data(), buffer.size()));
  if (!isThreemf(start) && !isStep(start)) return;
  throw InvalidConfig(option + " is " + nameOf(unit) + ", but '" + path + "' is a " +
                      (isStep(start) ? "STEP" : "3MF") + " file, which states its own unit; expected " +
                      nameOf(LengthUnit::Millimetre) + ", the default, which leaves that of the file");
}

}  // namespace lamina
