// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Checks by the bounding boxes of layers that a program deposits a part: boxes may differ by three widths of
/// a layer's widest bead.
/// @param sections  of the part in the program's layers, anywhere in the plane
/// @param part      its name for the message
/// @throws InvalidInput if the boxes of most layers differ
void requireSameSize(const Toolpath& program, const std::vector<Regions>& sections, const std::string& part);

/// Checks by what lies within the boxes, on some of the layers, that a program deposits a part. A layer is of
/// another part if beads of the part lie outside the section by more than 1.5 widths of the layer's widest
/// bead, or if its outer walls leave a hole without beads, wider than three such widths, where the section
/// has material. A program without outer walls is checked by its beads alone; layers of drops are not
/// checked.
/// @param sections  of the part, where the program deposits them
/// @returns what the first layer of another section has, and where; empty if there is none
/// @throws InvalidInput if most of the layers are of another part, or two that were compared one after the
///   other
std::string requireSameSections(const Toolpath& program, const std::vector<Regions>& sections,
                                const std::string& part);

}  // namespace lamina
