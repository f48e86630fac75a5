// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields of one step, each with its unit. A problem with the step is shown above the fields. An editor
// reports its value when editing is finished. If the value is outside its range, the form refuses it and
// shows the permitted range, and the typed text is kept.

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

    /// step  if null, the form is empty
    void setStep(const project::Project& project, const project::ProgramStep* step);
    /// Shows a problem with the step as a sentence. An empty text removes it.
    void setProblem(const QString& text);
    /// Sets the focus to the editor of a field, or to the first editor if the field does not exist.
    void focusField(const QString& key);

Q_SIGNALS:
    /// value  undefined if the field has no value
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
