// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/step_palette.h"

#include <QHeaderView>
#include <QMimeData>

#include "robot/station/program/program_edit.h"
#include "robot/station/program/step_kind.h"
#include "widgets/common/list_typing.h"
#include "widgets/program/program_model.h"
#include "widgets/program/program_row_delegate.h"

namespace tiller {

namespace {
constexpr int kKindRole = Qt::UserRole;
}

StepPalette::StepPalette(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("program.palette");
    setAccessibleName(tr("Steps to add"));
    setHeaderHidden(true);
    setItemDelegate(new ProgramRowDelegate(this));
    setDragEnabled(true);
    setDragDropMode(DragOnly);
    setIndentation(12);
    setExpandsOnDoubleClick(false);
    new ListTyping(*this);
    QHash<int, QTreeWidgetItem*> groups;
    for (const program::StepKind* kind : program::stepKinds()) {
        QTreeWidgetItem*& group = groups[static_cast<int>(kind->group)];
        if (group == nullptr) {
            group = new QTreeWidgetItem(this, {program::groupName(kind->group)});
            group->setFlags(Qt::ItemIsEnabled);
        }
        auto* item = new QTreeWidgetItem(group, {kind->name()});
        item->setToolTip(0, kind->name());
        item->setData(0, kKindRole, QString::fromLatin1(kind->id));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
    }
    expandAll();
    connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (const program::StepKind* kind = program::findStepKind(item->data(0, kKindRole).toString())) {
            Q_EMIT stepChosen(program::newStep(*kind));
        }
    });
}

QStringList StepPalette::mimeTypes() const {
    return {QLatin1String(ProgramModel::kStepsMime)};
}

QMimeData* StepPalette::mimeData(const QList<QTreeWidgetItem*>& items) const {
    program::Steps steps;
    for (const QTreeWidgetItem* item : items) {
        if (const program::StepKind* kind = program::findStepKind(item->data(0, kKindRole).toString())) {
            steps.push_back(program::newStep(*kind));
        }
    }
    auto* mime = new QMimeData;
    mime->setData(QLatin1String(ProgramModel::kStepsMime), program::textOf(steps));
    return mime;
}

}  // namespace tiller

#include "moc_step_palette.cpp"
