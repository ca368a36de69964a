// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sliced_upload.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/web/mesh_upload.hpp"
#include "request_settings.hpp"

namespace lamina {
namespace {

std::string programNameOf(const DeskMesh& mesh) {
  return std::filesystem::path(mesh.name).stem().string() + ".gcode";
}

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + fresh.size()))
    text.replace(at, old.size(), fresh);
  return text;
}

}  // namespace

SlicedUpload::SlicedUpload(const DeskMesh& mesh)
    : mesh_(mesh), linked_(mesh.path + meshSuffix(mesh.name)), program_(mesh.path + ".gcode") {
  std::error_code error;
  std::filesystem::create_hard_link(mesh_.path, linked_, error);
  if (error) throw FileError(mesh_.name + ": cannot be linked beside its upload: " + error.message());
}

SlicedUpload::~SlicedUpload() {
  std::error_code error;
  std::filesystem::remove(linked_, error);
  std::filesystem::remove(program_, error);
}

lamina_msgs::SliceMesh SlicedUpload::request() const {
  lamina_msgs::SliceMesh call;
  call.request.part = linked_;
  call.request.output = program_;
  call.request.material = mesh_.material;
  call.request.process = mesh_.process;
  call.request.is_file_only = 1;
  call.request.settings.reserve(mesh_.settings.size() + 1);
  // The job's digest is that of its files: the program says what it was sliced by.
  call.request.settings.push_back(settingMessage("program.settings_in_file", "true"));
  for (const SettingText& setting : mesh_.settings)
    call.request.settings.push_back(settingMessage(setting.key, setting.text));
  return call;
}

DeskProgram SlicedUpload::program() const {
  return {program_, programNameOf(mesh_), mesh_.part, mesh_.source, linked_, mesh_.name};
}

std::string SlicedUpload::withNames(std::string message) const {
  return replaced(replaced(std::move(message), linked_, mesh_.name), program_, programNameOf(mesh_));
}

}  // namespace lamina
