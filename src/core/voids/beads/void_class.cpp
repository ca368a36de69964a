// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_class.hpp"

namespace lamina {

const char* toString(VoidClass kind) {
  switch (kind) {
    case VoidClass::RasterBorder:
      return "R1";
    case VoidClass::DenseBorder:
      return "D1";
    case VoidClass::Core:
      return "C1";
    case VoidClass::Meeting:
      return "C2";
    case VoidClass::ShapeChange:
      return "C3";
    case VoidClass::Corner:
      return "C4";
    case VoidClass::Between:
      return "between";
  }
  return "unknown";
}

}  // namespace lamina
