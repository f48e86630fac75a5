// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_search.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "robot/station/document/project_document.h"
#include "widgets/waypoints/waypoint_table.h"

namespace tiller {

WaypointSearch::WaypointSearch(ProjectDocument& document, WaypointTable& table, QWidget* parent)
    : QFrame(parent), document_(document), table_(table), field_(new QLineEdit), count_(new QLabel) {
    setObjectName(QStringLiteral("waypoint.search"));
    setAccessibleName(tr("Find waypoints"));
    setAutoFillBackground(true);
    field_->setObjectName(QStringLiteral("waypoint.search.field"));
    field_->setAccessibleName(tr("Find waypoints by name, group or note"));
    field_->setPlaceholderText(tr("Name, group or note"));
    field_->setClearButtonEnabled(true);
    count_->setObjectName(QStringLiteral("waypoint.search.count"));
    count_->setProperty("role", "secondary");
    auto* done = new QPushButton(tr("Show all"));
    done->setObjectName(QStringLiteral("waypoint.search.close"));
    done->setAccessibleName(tr("Show all waypoints"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(field_, 1);
    layout->addWidget(count_);
    layout->addWidget(done);
    connect(field_, &QLineEdit::textChanged, this, &WaypointSearch::apply);
    connect(done, &QPushButton::clicked, this, &WaypointSearch::close);
    connect(&document_, &ProjectDocument::documentChanged, this, [this] {
        if (isVisible()) {
            apply();
        }
    });
    hide();
}

void WaypointSearch::open() {
    show();
    raise();
    field_->setFocus(Qt::ShortcutFocusReason);
    field_->selectAll();
    apply();
}

void WaypointSearch::close() {
    hide();
    words_.clear();
    apply();
    table_.setFocus();
    if (table_.currentIndex().isValid()) {
        table_.scrollTo(table_.currentIndex());
    }
}

bool WaypointSearch::matches(int row) const {
    if (words_.isEmpty()) {
        return true;
    }
    const project::Waypoint& point = document_.waypoints().at(row);
    return point.name.contains(words_, Qt::CaseInsensitive) ||
           point.group.contains(words_, Qt::CaseInsensitive) ||
           point.note.contains(words_, Qt::CaseInsensitive);
}

void WaypointSearch::apply() {
    words_ = isVisible() ? field_->text().trimmed() : QString();
    if (words_.isEmpty() && !filtered_) {
        count_->setText(QString());
        return;
    }
    int found = 0;
    table_.setUpdatesEnabled(false);
    for (int row = 0; row < document_.waypoints().size(); ++row) {
        const bool shown = matches(row);
        found += shown ? 1 : 0;
        if (table_.isRowHidden(row) == shown) {
            table_.setRowHidden(row, !shown);
        }
    }
    table_.setUpdatesEnabled(true);
    filtered_ = !words_.isEmpty();
    count_->setText(words_.isEmpty() ? QString() : tr("%n found", nullptr, found));
}

void WaypointSearch::next(int by) {
    const int rows = document_.waypoints().size();
    const int from = table_.currentIndex().isValid() ? table_.currentIndex().row() : -1;
    for (int step = 1; step <= rows; ++step) {
        const int row = ((from + by * step) % rows + rows) % rows;
        if (matches(row)) {
            Q_EMIT rowWanted(row);
            return;
        }
    }
}

void WaypointSearch::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape:
            close();
            return;
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Down:
            next(event->modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1);
            return;
        case Qt::Key_Up:
            next(-1);
            return;
        default:
            QFrame::keyPressEvent(event);
    }
}

}  // namespace tiller

#include "moc_waypoint_search.cpp"
