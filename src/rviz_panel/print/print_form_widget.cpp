// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/print_form_widget.hpp"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFormLayout>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QUrl>
#include <algorithm>

#include "fields/path_field.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/profiles/profile_library.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {
namespace {

const char* const kPartFilter = "Parts (*.stl *.obj *.ply *.3mf);;Programs (*.gcode);;All files (*)";
const char* const kPrintedFilter = "Programs (*.gcode)";
constexpr int kSettingsHeight = 90;  // pixels

/// The file that is dragged; empty if it is none of this computer.
QString fileOf(const QMimeData& dragged) {
  return dragged.hasUrls() ? dragged.urls().front().toLocalFile() : QString();
}

/// None of folders that are not there: the form says so when it is filled in.
std::vector<std::string> profiles(ProfileKind kind) {
  try {
    return ProfileLibrary(profileFolders()).names(kind);
  } catch (const InvalidConfig&) {
    return {};
  }
}

/// Those that people own first, then those that are described without a profile.
std::vector<std::string> machinesToPrintOn() {
  std::vector<std::string> names = profiles(ProfileKind::Machine);
  for (std::string& name : machineNames())
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  return names;
}

QComboBox* choices(const char* name, const std::vector<std::string>& names, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->addItem("as the node has it", "");
  for (const std::string& each : names)
    box->addItem(QString::fromStdString(each), QString::fromStdString(each));
  return box;
}

void choose(QComboBox& box, const std::string& name) {
  box.setCurrentIndex(std::max(0, box.findData(QString::fromStdString(name))));
}

}  // namespace

PrintFormWidget::PrintFormWidget(QWidget* parent)
    : QWidget(parent),
      part_(new PathField("part", PathField::Mode::Open, kPartFilter, this)),
      program_(new PathField("program", PathField::Mode::Save, kPrintedFilter, this)),
      machine_(choices("machine", machinesToPrintOn(), this)),
      material_(choices("material", profiles(ProfileKind::Material), this)),
      process_(choices("process", profiles(ProfileKind::Process), this)),
      settings_(new QPlainTextEdit(this)) {
  auto* rows = new QFormLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addRow("Part", part_);
  rows->addRow("Program", program_);
  rows->addRow("Machine", machine_);
  rows->addRow("Material", material_);
  rows->addRow("Process", process_);
  rows->addRow("Settings", settings_);
  part_->setHint("part.stl; or drop a file here");
  program_->setHint("beside the part");
  settings_->setObjectName("settings");
  settings_->setPlaceholderText("infill.density = 0.15\nskins.top_layers = 4");
  settings_->setMaximumHeight(kSettingsHeight);
  setAcceptDrops(true);
  settings_->setAcceptDrops(false);
  const auto notify = [this] {
    if (changed) changed();
  };
  part_->chosen = [this] { choosePart(); };
  part_->edited = program_->edited = notify;
  for (QComboBox* choice : {machine_, material_, process_})
    connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, notify);
  connect(settings_, &QPlainTextEdit::textChanged, this, notify);
}

void PrintFormWidget::choosePart() {
  if (part_chosen) part_chosen();
}

void PrintFormWidget::dragEnterEvent(QDragEnterEvent* event) {
  if (!fileOf(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void PrintFormWidget::dropEvent(QDropEvent* event) {
  const QString file = fileOf(*event->mimeData());
  if (file.isEmpty()) return;
  event->acceptProposedAction();
  part_->setPath(file);
  choosePart();
}

PrintForm PrintFormWidget::form() const {
  PrintForm form;
  form.part = part_->path().toStdString();
  form.program = program_->path().toStdString();
  form.machine = machine_->currentData().toString().toStdString();
  form.material = material_->currentData().toString().toStdString();
  form.process = process_->currentData().toString().toStdString();
  form.settings = settings_->toPlainText().toStdString();
  return form;
}

void PrintFormWidget::setForm(const PrintForm& form) {
  program_->setPath(QString::fromStdString(form.program));
  choose(*machine_, form.machine);
  choose(*material_, form.material);
  choose(*process_, form.process);
  settings_->setPlainText(QString::fromStdString(form.settings));
  part_->setPath(QString::fromStdString(form.part));
  choosePart();
}

}  // namespace lamina
