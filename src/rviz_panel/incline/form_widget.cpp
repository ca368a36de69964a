// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline/form_widget.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

#include "fields/angle_dial.hpp"
#include "fields/axis_field.hpp"
#include "fields/path_field.hpp"
#include "fields/position_field.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {
namespace {

const char* const kProgramFilter = "Programs (*.gcode);;All files (*)";
constexpr int kTabsHeight = 180;  // pixels

}  // namespace

FormWidget::FormWidget(QWidget* parent)
    : QWidget(parent),
      source_(new PathField("source", PathField::Mode::Open, kProgramFilter, this)),
      output_(new PathField("output", PathField::Mode::Save, kProgramFilter, this)),
      dial_(new AngleDial(this)),
      angle_(new QDoubleSpinBox(this)),
      axis_(new AxisField(this)),
      table_(new PositionField("table_position", "Part's middle on the table", 2, this)),
      final_(new PositionField("final_position", "Nozzle at the end", 3, this)),
      drops_aids_(new QCheckBox("Leave out skirt, brim, raft and support", this)),
      machine_(new QComboBox(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeFiles());
  column->addWidget(makeTurn());
  auto* tabs = new QTabWidget(this);
  tabs->setObjectName("tabs");
  tabs->setMaximumHeight(kTabsHeight);
  tabs->addTab(makePlace(), "Place");
  tabs->addTab(makeCode("begin_code", "G-code after the comments at the head", begin_code_), "Begin code");
  tabs->addTab(makeCode("end_code", "G-code after all else", end_code_), "End code");
  column->addWidget(tabs);
  joinDialAndNumber();
  source_->chosen = [this] { chooseSource(); };
  const auto notify = [this] { notifyChange(); };
  source_->edited = output_->edited = axis_->changed = table_->changed = final_->changed = notify;
  connect(drops_aids_, &QCheckBox::toggled, this, notify);
  connect(machine_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, notify);
  setForm({});
}

QWidget* FormWidget::makeFiles() {
  auto* files = new QWidget(this);
  auto* rows = new QFormLayout(files);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addRow("Source", source_);
  rows->addRow("Output", output_);
  source_->setHint("part.gcode");
  output_->setHint("part_rotate.gcode");
  return files;
}

QWidget* FormWidget::makeTurn() {
  auto* turn = new QWidget(this);
  auto* row = new QHBoxLayout(turn);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(dial_);
  auto* rows = new QFormLayout();
  dial_->setObjectName("dial");
  angle_->setObjectName("angle");
  angle_->setRange(kLeastInclination, kGreatestInclination);
  angle_->setDecimals(2);
  angle_->setSuffix(" °");
  machine_->setObjectName("machine");
  machine_->addItem("as the node has it", "");
  for (const std::string& name : machineNames())
    machine_->addItem(QString::fromStdString(name), QString::fromStdString(name));
  machine_->setToolTip("Whose limits are checked");
  machine_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rows->addRow("Angle", angle_);
  rows->addRow("Axis", axis_);
  rows->addRow("Machine", machine_);
  row->addLayout(rows, 1);
  return turn;
}

QWidget* FormWidget::makePlace() {
  auto* place = new QWidget(this);
  auto* column = new QVBoxLayout(place);
  column->addWidget(table_);
  column->addWidget(final_);
  drops_aids_->setObjectName("drop_build_aids");
  drops_aids_->setToolTip("What lies on the slicer's bed cannot lie on the machine's once it is turned");
  column->addWidget(drops_aids_);
  column->addStretch();
  return place;
}

QWidget* FormWidget::makeCode(const QString& name, const QString& hint, QPlainTextEdit*& edit) {
  edit = new QPlainTextEdit(this);
  edit->setObjectName(name);
  edit->setPlaceholderText(hint);
  edit->setLineWrapMode(QPlainTextEdit::NoWrap);
  edit->setMinimumHeight(60);
  connect(edit, &QPlainTextEdit::textChanged, this, [this] { notifyChange(); });
  return edit;
}

void FormWidget::joinDialAndNumber() {
  dial_->turned = [this](double angle_deg) { angle_->setValue(angle_deg); };
  connect(angle_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double angle_deg) {
    dial_->setAngle(angle_deg);
    notifyChange();
  });
}

void FormWidget::chooseSource() {
  const std::string source = source_->path().toStdString();
  if (source == shown_source_) return;
  const std::string output = output_->path().toStdString();
  if (output.empty() || output == outputFor(shown_source_))
    output_->setPath(QString::fromStdString(outputFor(source)));
  shown_source_ = source;
  if (source_chosen) source_chosen(source);
}

void FormWidget::notifyChange() {
  if (changed) changed();
}

InclineForm FormWidget::form() const {
  InclineForm form;
  form.source = source_->path().toStdString();
  form.output = output_->path().toStdString();
  form.angle_deg = angle_->value();
  form.axis = axis_->axis();
  form.machine = machine_->currentData().toString().toStdString();
  form.begin_code = begin_code_->toPlainText().toStdString();
  form.end_code = end_code_->toPlainText().toStdString();
  form.table_position_mm = table_->position();
  form.final_position_mm = final_->position();
  form.drops_build_aids = drops_aids_->isChecked();
  return form;
}

void FormWidget::setForm(const InclineForm& form) {
  angle_->setValue(form.angle_deg);
  dial_->setAngle(form.angle_deg);
  axis_->setAxis(form.axis);
  machine_->setCurrentIndex(std::max(0, machine_->findData(QString::fromStdString(form.machine))));
  begin_code_->setPlainText(QString::fromStdString(form.begin_code));
  end_code_->setPlainText(QString::fromStdString(form.end_code));
  table_->setPosition(form.table_position_mm);
  final_->setPosition(form.final_position_mm);
  drops_aids_->setChecked(form.drops_build_aids);
  source_->setPath(QString::fromStdString(form.source));
  output_->setPath(QString::fromStdString(form.output));
  chooseSource();
}

}  // namespace lamina
