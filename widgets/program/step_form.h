// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields of one step, each with its unit. A problem with the step is shown above the fields. An editor
// reports its value when editing is finished. A value outside the range is rejected, and the permitted range
// is shown. The text remains as typed.

#include <QJsonValue>
#include <QWidget>

#include "robot/project/project_file.h"
#include "robot/station/program/step_kind.h"

class QLabel;

namespace tiller {

class StepForm : public QWidget {
    Q_OBJECT

public:
    explicit StepForm(QWidget* parent = nullptr);

    /// step  null: no step to edit
    void setStep(const project::Project& project, const project::ProgramStep* step);
    /// Shows a problem with the step. `text` is a sentence, or empty if there is no problem.
    void setProblem(const QString& text);
    /// Sets the focus to the editor of a field, or to the first editor if there is no such field.
    void focusField(const QString& key);

Q_SIGNALS:
    /// value  undefined: the field has no value
    void edited(const QUuid& step, const QString& key, const QString& label, const QJsonValue& value);

private:
    QWidget* editorFor(const project::Project& project, const program::StepField& field,
                       const QJsonValue& value);
    QWidget* lineEditor(const program::StepField& field, const QJsonValue& value);
    void finish(const QUuid& step, const program::StepField& field, const QJsonValue& value);

    QWidget* fields_ = nullptr;
    QLabel* title_;
    QLabel* problem_;
    QLabel* refusal_;
    project::ProgramStep shown_;
};

}  // namespace tiller
