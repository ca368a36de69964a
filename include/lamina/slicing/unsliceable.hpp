// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A part that cannot be sliced as asked for. The message gives the reason and the place; the region shows
/// the place.
class Unsliceable : public InvalidMesh, public RichError {
 public:
  Unsliceable(const std::string& message, Mesh region) : InvalidMesh(message), region_(std::move(region)) {}

  /// The region of the surface that prevents slicing [mm, part frame].
  const Mesh& region() const { return region_; }
  /// The mesh of the whole part, to show the region on; empty until `on` sets it.
  const Mesh& part() const { return part_; }

  [[noreturn]] void throwAt(const std::string& place) const override {
    throw Unsliceable(place + ": " + what(), region_).withPart(part_);
  }

  /// This error, with the mesh of the whole part.
  Unsliceable withPart(Mesh part) && {
    part_ = std::move(part);
    return std::move(*this);
  }

 private:
  Mesh region_;
  Mesh part_;
};

}  // namespace lamina
