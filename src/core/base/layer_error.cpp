// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/layer_error.hpp"

#include <cstdio>

namespace lamina {

std::string layerPlace(std::size_t layer, double top_mm) {
  char text[80];
  std::snprintf(text, sizeof text, "layer %zu at %.6g mm", layer, top_mm);
  return text;
}

std::string islandPlace(std::size_t layer, double top_mm, std::size_t island) {
  return layerPlace(layer, top_mm) + ", island " + std::to_string(island);
}

std::string pathPlace(std::size_t layer, double top_mm, std::size_t path) {
  return layerPlace(layer, top_mm) + ", path " + std::to_string(path);
}

void throwFailure(const Failure& failure) {
  switch (failure.code) {
    case ErrorCode::InvalidInput:
      throw InvalidInput(failure.message);
    case ErrorCode::InvalidMesh:
      throw InvalidMesh(failure.message);
    case ErrorCode::InvalidConfig:
      throw InvalidConfig(failure.message);
    case ErrorCode::InvalidProgram:
      throw InvalidProgram(failure.message);
    case ErrorCode::FileError:
      throw FileError(failure.message);
    case ErrorCode::Unreachable:
      throw Unreachable(failure.message);
    case ErrorCode::DeviceError:
      throw DeviceError(failure.message);
    case ErrorCode::Disconnected:
      throw Disconnected(failure.message);
    case ErrorCode::Rejected:
      throw Rejected(failure.message);
    case ErrorCode::TimedOut:
      throw TimedOut(failure.message);
    case ErrorCode::Cancelled:
      throw Cancelled(failure.message);
    case ErrorCode::Ok:
    case ErrorCode::Internal:
      break;
  }
  throw Error(ErrorCode::Internal, failure.message);
}

void rethrowAt(const std::string& place) {
  const Failure failure = currentFailure();
  if (failure.code == ErrorCode::Cancelled) throw;
  try {
    throw;
  } catch (const RichError& error) {
    error.throwAt(place);
  } catch (...) {
    // It has no more than its failure.
  }
  throwFailure({failure.code, place + ": " + failure.message});
}

}  // namespace lamina
