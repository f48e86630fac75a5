// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/step_form.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "robot/station/program/program_edit.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/text_entry.h"

namespace tiller {

using program::FieldType;
using program::StepField;

namespace {

/// Multi-line editor. Losing the focus finishes editing.
class LinesEditor : public QPlainTextEdit {
public:
    LinesEditor(const QString& text, std::function<void(const QString&)> done)
        : QPlainTextEdit(text), done_(std::move(done)) {
        setTabChangesFocus(true);
        setMaximumHeight(fontMetrics().lineSpacing() * 8);
    }
    void release() { done_ = nullptr; }

protected:
    bool event(QEvent* event) override {
        return leavesUndoToProject(*event, document()->isUndoAvailable(), document()->isRedoAvailable()) ||
               QPlainTextEdit::event(event);
    }
    void focusOutEvent(QFocusEvent* event) override {
        QPlainTextEdit::focusOutEvent(event);
        if (done_) {
            done_(toPlainText());
        }
    }

private:
    std::function<void(const QString&)> done_;
};

/// Single-line editor. Esc restores the last accepted text.
class LineEditor : public QLineEdit {
public:
    explicit LineEditor(const QString& text) : QLineEdit(text), accepted_(text) {}

protected:
    bool event(QEvent* event) override {
        return leavesUndoToProject(*event, isUndoAvailable(), isRedoAvailable()) || QLineEdit::event(event);
    }
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Escape && text() != accepted_) {
            setText(accepted_);
            selectAll();
            return;
        }
        QLineEdit::keyPressEvent(event);
    }

private:
    QString accepted_;
};

QLabel* wrappedLabel(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->hide();
    return label;
}

void showText(QLabel& label, const QString& text) {
    label.setText(text.isEmpty() ? QString() : QStringLiteral("⚠ ") + text);
    label.setVisible(!text.isEmpty());
}

}  // namespace

StepForm::StepForm(QWidget* parent)
    : QWidget(parent)
    , title_(new QLabel)
    , problem_(wrappedLabel("program.problem"))
    , refusal_(wrappedLabel("program.refusal")) {
    setObjectName("program.form");
    title_->setWordWrap(true);
    title_->setTextFormat(Qt::PlainText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->addWidget(title_);
    layout->addWidget(problem_);
    layout->addWidget(refusal_);
    layout->addStretch(1);
}

void StepForm::setStep(const project::Project& project, const project::ProgramStep* step) {
    const QWidget* focus = fields_ != nullptr ? fields_->focusWidget() : nullptr;
    const bool isTyping = focus != nullptr && focus->hasFocus() && step != nullptr && step->id == shown_.id;
    if (isTyping && *step == shown_) {
        return;  // another part of the project changed
    }
    const QString focused = isTyping ? focus->objectName() : QString();
    shown_ = step != nullptr ? *step : project::ProgramStep();
    showText(*refusal_, {});
    // Delete the editors later, because one of them may have emitted the edit that is being processed.
    if (fields_ != nullptr) {
        for (QWidget* editor : fields_->findChildren<QWidget*>()) {
            editor->disconnect(this);
            editor->setObjectName({});
            if (auto* lines = dynamic_cast<LinesEditor*>(editor)) {
                lines->release();
            }
        }
        fields_->hide();
        fields_->deleteLater();
        fields_ = nullptr;
    }
    const program::StepKind* kind = step != nullptr ? program::findStepKind(step->kind) : nullptr;
    title_->setText(step != nullptr ? program::kindName(*step) : tr("Select one step to edit it."));
    if (kind == nullptr) {
        return;
    }
    fields_ = new QWidget(this);
    auto* form = new QFormLayout(fields_);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapAllRows);
    for (const StepField& field : kind->fields()) {
        QWidget* editor = editorFor(project, field, program::fieldValue(*step, field));
        editor->setObjectName(QStringLiteral("program.field.%1").arg(QLatin1String(field.key)));
        editor->setAccessibleName(field.label);
        const QString unit = program::unitText(field.unit);
        auto* label =
            new QLabel(unit.isEmpty() ? field.label : QStringLiteral("%1 [%2]").arg(field.label, unit));
        label->setWordWrap(true);
        label->setBuddy(editor);
        form->addRow(label, editor);
    }
    static_cast<QVBoxLayout*>(layout())->insertWidget(2, fields_);
    fields_->show();
    if (!focused.isEmpty()) {
        if (auto* editor = fields_->findChild<QWidget*>(focused)) {
            editor->setFocus();
        }
    }
}

void StepForm::setProblem(const QString& text) {
    showText(*problem_, text);
}

void StepForm::focusField(const QString& key) {
    if (fields_ == nullptr) {
        return;
    }
    auto* editor = fields_->findChild<QWidget*>(QStringLiteral("program.field.%1").arg(key));
    const QFormLayout* form = static_cast<QFormLayout*>(fields_->layout());
    if (editor == nullptr && form->rowCount() > 0) {
        editor = form->itemAt(0, QFormLayout::FieldRole)->widget();
    }
    if (editor != nullptr) {
        editor->setFocus();
    }
}

void StepForm::finish(const QUuid& step, const StepField& field, const QJsonValue& value) {
    showText(*refusal_, {});
    Q_EMIT edited(step, QLatin1String(field.key), field.label, value);
}

QWidget* StepForm::lineEditor(const StepField& field, const QJsonValue& value) {
    const QString shown = program::editText(field, value);
    auto* edit = new LineEditor(shown);
    connect(edit, &QLineEdit::textChanged, edit, [edit] { markRefused(*edit, false); });
    // Capture the step, because the selection may change before editing is finished.
    connect(edit, &QLineEdit::editingFinished, this, [this, step = shown_.id, edit, field, shown] {
        if (edit->text() == shown) {
            showText(*refusal_, {});
            return;
        }
        const program::FieldInput input = program::fieldInput(field, edit->text());
        markRefused(*edit, !input.refusal.isEmpty());
        if (input.refusal.isEmpty()) {
            finish(step, field, input.value);
        } else {
            showText(*refusal_, input.refusal);
        }
    });
    return edit;
}

QWidget* StepForm::editorFor(const project::Project& project, const StepField& field,
                             const QJsonValue& value) {
    const QUuid step = shown_.id;
    switch (field.type) {
        case FieldType::Flag: {
            auto* box = new QCheckBox;
            box->setChecked(value.toBool());
            connect(box, &QCheckBox::clicked, this,
                    [this, step, field](bool on) { finish(step, field, on); });
            return box;
        }
        case FieldType::Lines:
            return new LinesEditor(value.toString(),
                                   [this, step, field, before = value.toString()](const QString& text) {
                                       if (text != before) {
                                           finish(step, field, text);
                                       }
                                   });
        case FieldType::Number:
        case FieldType::Whole:
        case FieldType::Text:
        case FieldType::Expression:
        case FieldType::Variable:
            return lineEditor(field, value);
        default: {
            auto* box = new ChoiceBox;
            if (field.optional || value.isUndefined() || value.isNull()) {
                box->addItem(tr("(none)"));
            }
            for (const auto& [choice, text] : program::choicesOf(project, field)) {
                box->addItem(text, choice);
                if (choice == value) {
                    box->setCurrentIndex(box->count() - 1);
                }
            }
            if (!value.isUndefined() && !value.isNull() && box->currentData().toJsonValue() != value) {
                box->addItem(QStringLiteral("?"), value);
                box->setCurrentIndex(box->count() - 1);
            }
            // Use the width of the current text, because longer choices would widen the whole panel.
            box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
            box->setMinimumContentsLength(std::max(8, static_cast<int>(box->currentText().size())));
            connect(box, &QComboBox::activated, this, [this, step, box, field] {
                const QVariant chosen = box->currentData();
                finish(step, field,
                       chosen.isValid() ? chosen.toJsonValue() : QJsonValue(QJsonValue::Undefined));
            });
            return box;
        }
    }
}

}  // namespace tiller

#include "moc_step_form.cpp"
