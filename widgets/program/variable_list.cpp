// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/variable_list.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <utility>

#include "robot/station/program/run/program_runner.h"
#include "widgets/program/program_row_delegate.h"

namespace tiller {

using script::ProgramVariable;

namespace {

constexpr int kVariableColumns = 3;

/// A flag is selected from a list or typed. Other values are typed.
class VariableDelegate : public ProgramRowDelegate {
public:
    VariableDelegate(const program::ProgramRunner& runner, const VariableModel& model, QObject* parent)
        : ProgramRowDelegate(parent), runner_(runner), model_(model) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (runner_.variables().changeableType(model_.at(index).name) != script::GateVariable::Type::Flag) {
            return ProgramRowDelegate::createEditor(parent, option, index);
        }
        auto* editor = new QComboBox(parent);
        editor->setEditable(true);
        editor->setInsertPolicy(QComboBox::NoInsert);
        editor->addItems({QStringLiteral("False"), QStringLiteral("True")});
        return editor;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor)) {
            box->setCurrentIndex(box->findText(model_.at(index).text));
            box->lineEdit()->selectAll();
        } else {
            ProgramRowDelegate::setEditorData(editor, index);
        }
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        if (const auto* box = qobject_cast<QComboBox*>(editor)) {
            model->setData(index, box->currentText());
        } else {
            ProgramRowDelegate::setModelData(editor, model, index);
        }
    }

private:
    const program::ProgramRunner& runner_;
    const VariableModel& model_;
};

}  // namespace

VariableModel::VariableModel(const program::ProgramRunner& runner, QObject* parent)
    : QAbstractTableModel(parent), runner_(runner) {}

void VariableModel::follow() {
    const std::vector<ProgramVariable>& list = runner_.variables().list();
    const bool isSame =
        std::equal(list.begin(), list.end(), shown_.begin(), shown_.end(),
                   [](const ProgramVariable& a, const ProgramVariable& b) { return a.name == b.name; });
    if (!isSame) {
        beginResetModel();
        shown_ = list;
        endResetModel();
        return;
    }
    shown_ = list;
    if (!shown_.empty()) {
        // Report several cells, because a view replaces the text in an open editor if only its cell has
        // changed.
        Q_EMIT dataChanged(index(0, Type), index(rowCount() - 1, Value));
    }
}

const ProgramVariable& VariableModel::at(const QModelIndex& index) const {
    return shown_[static_cast<std::size_t>(index.row())];
}

QString VariableModel::obstacleAt(const QModelIndex& index) const {
    return index.isValid() ? runner_.changeObstacle(at(index)) : QString();
}

int VariableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int VariableModel::columnCount(const QModelIndex&) const {
    return kVariableColumns;
}

QVariant VariableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const ProgramVariable& variable = at(index);
    const bool isPending = runner_.variables().pending() == variable.name;
    switch (role) {
        case Qt::DisplayRole:
            return index.column() == Name   ? variable.name
                   : index.column() == Type ? program::typeName(variable.type)
                   : isPending              ? tr("%1 (changing…)").arg(variable.text)
                                            : variable.text;
        case Qt::EditRole:
            return variable.text;
        case Qt::ToolTipRole: {
            const QString obstacle = obstacleAt(index);
            return index.column() == Value && !obstacle.isEmpty()
                       ? QStringLiteral("%1\n%2").arg(variable.text, obstacle)
                       : data(index, Qt::DisplayRole);
        }
        default:
            return {};
    }
}

QVariant VariableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Name ? tr("Variable") : section == Type ? tr("Type") : tr("Value");
}

Qt::ItemFlags VariableModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
    return index.isValid() && index.column() == Value && obstacleAt(index).isEmpty()
               ? flags | Qt::ItemIsEditable
               : flags;
}

bool VariableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || index.column() != Value) {
        return false;
    }
    if (const QString obstacle = obstacleAt(index); !obstacle.isEmpty()) {
        Q_EMIT refused(obstacle);
        return false;
    }
    if (value.toString() != at(index).text) {
        Q_EMIT edited(at(index).name, value.toString());
    }
    return true;
}

VariableList::VariableList(const program::ProgramRunner& runner, QWidget* parent)
    : QTreeView(parent), runner_(runner), model_(new VariableModel(runner, this)) {
    setObjectName("program.variables");
    setAccessibleName(tr("Program variables"));
    setModel(model_);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setItemDelegate(new VariableDelegate(runner, *model_, this));
    setEditTriggers(DoubleClicked | EditKeyPressed);
    header()->setSectionResizeMode(VariableModel::Name, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(VariableModel::Type, QHeaderView::ResizeToContents);
    header()->setStretchLastSection(true);
    connect(model_, &VariableModel::edited, this, &VariableList::edited);
    connect(model_, &VariableModel::refused, this, &VariableList::refused);
    connect(this, &QTreeView::activated, this, [this](const QModelIndex& index) {
        const QModelIndex value = index.siblingAtColumn(VariableModel::Value);
        if (const QString obstacle = model_->obstacleAt(value); !obstacle.isEmpty()) {
            Q_EMIT refused(obstacle);
        } else if (!isPersistentEditorOpen(value) && state() != EditingState) {
            edit(value);
        }
    });
    for (const auto change : {&program::ProgramRunner::changed, &program::ProgramRunner::variablesChanged}) {
        connect(&runner, change, this, &VariableList::follow);
    }
    connect(&runner, &program::ProgramRunner::variableChanged, this, &VariableList::follow);
    follow();
}

void VariableList::follow() {
    const bool wasEditing = state() == EditingState;
    model_->follow();
    if (wasEditing && state() != EditingState) {
        Q_EMIT refused(
            tr("The variable list changed during editing, so the value was not applied. Enter the value "
               "again."));
    }
    setVisible(model_->rowCount() > 0 || !runner_.script().variables.empty());
}

QSize VariableList::sizeHint() const {
    constexpr int kRows = 4;
    return {QTreeView::sizeHint().width(),
            header()->sizeHint().height() + kRows * fontMetrics().height() * 2};
}

}  // namespace tiller

#include "moc_variable_list.cpp"
