// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// A layer as errors name it: "layer 12 at 2.4 mm".
/// @param layer   index, from 0, as in `;LAYER:`
/// @param top_mm  height at which the nozzle tip runs, in the frame of the layers
std::string layerPlace(std::size_t layer, double top_mm);

/// An island of a layer: "layer 12 at 2.4 mm, island 3".
/// @param island  index in its layer, from 0
std::string islandPlace(std::size_t layer, double top_mm, std::size_t island);

/// A path of a layer: "layer 12 at 2.4 mm, path 3".
/// @param path  index in its layer, from 0
std::string pathPlace(std::size_t layer, double top_mm, std::size_t path);

/// Throws the error of a failure: of the kind of its code, with its message. The code `Ok`, which is no
/// error, gives an Internal one.
[[noreturn]] void throwFailure(const Failure& failure);

/// An error that carries more than its message.
class RichError {
 public:
  virtual ~RichError() = default;

  /// Throws this error, with all that it carries, and the place before its message.
  [[noreturn]] virtual void throwAt(const std::string& place) const = 0;
};

/// Throws the exception that is being handled again, with the place before its message: "layer 12 at 2.4 mm:
/// ...". Its code stays, and so does what a `RichError` carries. `Cancelled` stays as it is; an exception
/// that is not an `Error` becomes Internal. Call it only inside a catch block.
[[noreturn]] void rethrowAt(const std::string& place);

}  // namespace lamina
