// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/part_mesh.hpp"

#include "job/part/part_reading.hpp"

namespace lamina {

Mesh partMesh(const std::string& part, const InputSettings& settings) {
  NoProgress nobody;
  return readPart(part, settings, nobody).mesh;
}

}  // namespace lamina
