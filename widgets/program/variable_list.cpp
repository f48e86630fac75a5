// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/variable_list.h"

#include <QHeaderView>
#include <utility>

#include "robot/station/program/run/program_runner.h"
#include "widgets/program/program_row_delegate.h"

namespace tiller {

using script::ProgramVariable;

namespace {
constexpr int kVariableColumns = 3;
}

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
            // A flag is chosen from a list, other values are typed.
            return runner_.variables().changeableType(variable.name) == script::GateVariable::Type::Flag
                       ? QVariant(variable.number > 0)
                       : QVariant(variable.text);
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
    if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable)) {
        return false;
    }
    const QString text = value.typeId() != QMetaType::Bool ? value.toString()
                         : value.toBool()                  ? QStringLiteral("True")
                                                           : QStringLiteral("False");
    if (text != at(index).text) {
        Q_EMIT edited(at(index).name, text);
    }
    return true;
}

VariableList::VariableList(const program::ProgramRunner& runner, QWidget* parent)
    : QTreeView(parent), runner_(runner), model_(new VariableModel(runner, this)) {
    setObjectName("program.variables");
    setAccessibleName(tr("Variables of the program"));
    setModel(model_);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setItemDelegate(new ProgramRowDelegate(this));
    setEditTriggers(DoubleClicked | EditKeyPressed);
    header()->setSectionResizeMode(VariableModel::Name, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(VariableModel::Type, QHeaderView::ResizeToContents);
    header()->setStretchLastSection(true);
    connect(model_, &VariableModel::edited, this, &VariableList::edited);
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
    model_->follow();
    setVisible(model_->rowCount() > 0 || !runner_.script().variables.empty());
}

QSize VariableList::sizeHint() const {
    constexpr int kRows = 4;
    return {QTreeView::sizeHint().width(),
            header()->sizeHint().height() + kRows * fontMetrics().height() * 2};
}

}  // namespace tiller

#include "moc_variable_list.cpp"
