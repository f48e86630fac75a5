// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/step_tree.h"

#include <QHeaderView>
#include <algorithm>
#include <functional>

#include "widgets/common/list_typing.h"
#include "widgets/program/program_model.h"
#include "widgets/program/program_row_delegate.h"

namespace tiller {

StepTree::StepTree(ProgramModel& model, QWidget* parent) : QTreeView(parent), model_(model) {
    setObjectName("program.tree");
    setAccessibleName(tr("Program steps"));
    setModel(&model);
    setSelectionMode(ExtendedSelection);
    setSelectionBehavior(SelectRows);
    setDragEnabled(true);
    setAcceptDrops(true);
    setDropIndicatorShown(true);
    setDragDropMode(DragDrop);
    setDefaultDropAction(Qt::MoveAction);
    setItemDelegate(new ProgramRowDelegate(this));
    setUniformRowHeights(true);
    setEditTriggers(NoEditTriggers);
    setAllColumnsShowFocus(true);
    setExpandsOnDoubleClick(false);
    setHorizontalScrollMode(ScrollPerPixel);
    new ListTyping(*this);
    header()->setSectionResizeMode(QHeaderView::Fixed);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(ProgramModel::Result, QHeaderView::Stretch);
    // Combine several changes into one fit, because a run changes the results often.
    fitTimer_.setSingleShot(true);
    connect(&fitTimer_, &QTimer::timeout, this, &StepTree::fitColumns);
    for (const auto changed : {&QTreeView::collapsed, &QTreeView::expanded}) {
        connect(this, changed, &fitTimer_, [this] { fitTimer_.start(0); });
    }
    connect(&model, &QAbstractItemModel::dataChanged, &fitTimer_, [this] { fitTimer_.start(0); });
    connect(&model, &ProgramModel::treeChanged, &fitTimer_, [this] { fitTimer_.start(0); });
    connect(&model, &ProgramModel::runningStepMoved, this, &StepTree::followRun);
    connect(this, &QTreeView::collapsed, this,
            [this](const QModelIndex& index) { collapsed_.insert(model_.idAt(index)); });
    connect(this, &QTreeView::expanded, this,
            [this](const QModelIndex& index) { collapsed_.remove(model_.idAt(index)); });
    connect(&model, &QAbstractItemModel::modelAboutToBeReset, this, [this] {
        selected_ = selectedIds();
        current_ = currentId();
        isRestoring_ = true;
    });
    connect(&model, &ProgramModel::treeChanged, this, [this] {
        const std::function<void(const QModelIndex&)> restore = [&](const QModelIndex& section) {
            for (int row = 0; row < model_.rowCount(section); ++row) {
                const QModelIndex index = model_.index(row, 0, section);
                if (model_.rowCount(index) > 0) {
                    setExpanded(index, !collapsed_.contains(model_.idAt(index)));
                    restore(index);
                }
            }
        };
        restore({});
        isRestoring_ = false;
        selectIds(selected_.values());
        if (const QModelIndex index = model_.indexOf(current_); index.isValid()) {
            selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
        }
        Q_EMIT selectionMoved();
    });
}

QSet<QUuid> StepTree::selectedIds() const {
    QSet<QUuid> ids;
    for (const QModelIndex& index : selectionModel()->selectedRows()) {
        ids.insert(model_.idAt(index));
    }
    return ids;
}

QUuid StepTree::currentId() const {
    return model_.idAt(currentIndex());
}

void StepTree::selectIds(const QList<QUuid>& ids) {
    QItemSelection selection;
    QModelIndex last;
    for (const QUuid& id : ids) {
        if (const QModelIndex index = model_.indexOf(id); index.isValid()) {
            selection.select(index, index);
            last = index;
        }
    }
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    if (last.isValid()) {
        selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
        scrollTo(last);
    }
}

void StepTree::resizeEvent(QResizeEvent* event) {
    QTreeView::resizeEvent(event);
    fitColumns();
}

void StepTree::fitColumns() {
    const auto contents = [this](int column) {
        return std::max(sizeHintForColumn(column), header()->sectionSizeHint(column));
    };
    // Keep all titles readable, even if a very narrow tree must be scrolled. The step names have priority.
    const auto title = [this](int column) { return header()->sectionSizeHint(column); };
    const int room = viewport()->width();
    const int others = title(ProgramModel::Values) + title(ProgramModel::Result);
    const int step =
        std::max(std::min(contents(ProgramModel::Step), room - others), title(ProgramModel::Step));
    const int result =
        std::max(std::min(contents(ProgramModel::Result), room - step - title(ProgramModel::Values)),
                 title(ProgramModel::Result));
    const int values =
        std::max(std::min(contents(ProgramModel::Values), room - result - step), title(ProgramModel::Values));
    header()->resizeSection(ProgramModel::Step, step);
    header()->resizeSection(ProgramModel::Values, values);
}

void StepTree::followRun(const QModelIndex& before, const QModelIndex& now) {
    const bool isFollowed =
        !before.isValid() || viewport()->rect().intersects(visualRect(shownRowOf(before)));
    if (now.isValid() && isFollowed) {
        scrollTo(shownRowOf(now));
    }
}

QModelIndex StepTree::shownRowOf(const QModelIndex& step) const {
    QModelIndex shown = step;
    for (QModelIndex section = step.parent(); section.isValid(); section = section.parent()) {
        if (!isExpanded(section)) {
            shown = section;
        }
    }
    return shown;
}

void StepTree::selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) {
    QTreeView::selectionChanged(selected, deselected);
    if (!isRestoring_) {
        Q_EMIT selectionMoved();
    }
}

}  // namespace tiller

#include "moc_step_tree.cpp"
