// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_reader.hpp"

#include <cstdio>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "program/gcode/foreign_format.hpp"
#include "program/gcode/gcode_interpreter.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestLine = 1U << 20;

}  // namespace

class GcodeReader::Interpreter : public GcodeInterpreter {
  using GcodeInterpreter::GcodeInterpreter;
};

GcodeReader::GcodeReader(GcodeReaderSettings settings, GcodeHandlers handlers)
    : interpreter_(std::make_unique<Interpreter>(settings, std::move(handlers))) {}
GcodeReader::~GcodeReader() = default;
GcodeReader::GcodeReader(GcodeReader&&) noexcept = default;
GcodeReader& GcodeReader::operator=(GcodeReader&&) noexcept = default;

void GcodeReader::read(std::string_view piece) {
  for (std::size_t end = piece.find('\n'); end != std::string_view::npos; end = piece.find('\n')) {
    if (unfinished_.empty()) {
      interpreter_->readLine(piece.substr(0, end), ++line_);
    } else {
      unfinished_.append(piece.substr(0, end));
      interpreter_->readLine(unfinished_, ++line_);
      unfinished_.clear();
    }
    piece.remove_prefix(end + 1);
  }
  if (unfinished_.size() + piece.size() > kLongestLine)
    throw InvalidProgram("line " + std::to_string(line_ + 1) + ": longer than 1 MiB; this is no G-code");
  unfinished_.append(piece);
}

void GcodeReader::finish() {
  if (unfinished_.empty()) return;
  interpreter_->readLine(unfinished_, ++line_);
  unfinished_.clear();
}

void readGcodeFile(const std::string& path, const GcodeReaderSettings& settings,
                   const GcodeHandlers& handlers) {
  InputFile file(path);
  GcodeReader reader(settings, handlers);
  std::vector<char> buffer(1U << 18);
  const auto next = [&] { return std::string_view(buffer.data(), file.read(buffer.data(), buffer.size())); };
  const std::string_view first = next();
  requireTextOfGcode(first, path);
  for (std::string_view piece = withoutUtf8Mark(first); !piece.empty(); piece = next()) reader.read(piece);
  reader.finish();
}

}  // namespace lamina
