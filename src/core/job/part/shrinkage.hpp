// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/part/source_part.hpp"

namespace lamina {

/// Whether a part is to be made larger than it is drawn, or smaller.
bool changesSize(const CompensationSettings& settings);

/// The part as large as it must be deposited to have its size once it has shrunk: scaled about the middle of
/// its underside, in the frame of the layers.
SourcePart grownForShrinkage(SourcePart source, const JobSettings& settings);

/// What to know of the sizes [mm] as drawn and as deposited.
std::string sizeNote(const Point3& drawn, const Point3& deposited);

}  // namespace lamina
