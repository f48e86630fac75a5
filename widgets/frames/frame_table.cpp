// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_table.h"

#include "widgets/frames/frame_model.h"

namespace tiller {

FrameTable::FrameTable(FrameModel& model, QWidget* parent) : RowTable(model, FrameModel::Name, parent) {
    setObjectName(QStringLiteral("frame.table"));
    setAccessibleName(tr("Frames"));
    setItemDelegate(new RowDelegate(QStringLiteral("frame.editor"), this));
    setSelectionMode(SingleSelection);
}

void FrameTable::resizeEvent(QResizeEvent* event) {
    shareWidth();
    RowTable::resizeEvent(event);
}

void FrameTable::shareWidth() {
    const int room = viewport()->width();
    // Column widths [px] for a sign and four digits before the decimal point.
    constexpr int kName = 90;
    constexpr int kThreeDigits = 196;
    constexpr int kPoints = 58;
    constexpr int kDistance = 82;
    setColumnWidth(FrameModel::Origin, kThreeDigits);
    setColumnWidth(FrameModel::Rotation, kThreeDigits);
    setColumnWidth(FrameModel::Waypoints, kPoints);
    setColumnWidth(FrameModel::Distance, kDistance);
    // Hide columns to keep a minimum width for the name. The details below the table show the values of the
    // hidden columns.
    const int least = kName + 2 * kThreeDigits + kPoints;
    setColumnHidden(FrameModel::Distance, room < least + kDistance);
    setColumnHidden(FrameModel::Rotation, room < least);
}

}  // namespace tiller

#include "moc_frame_table.cpp"
