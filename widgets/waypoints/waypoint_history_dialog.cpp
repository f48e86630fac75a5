// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_history_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "robot/project/relative_move.h"
#include "robot/station/document/project_document.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/notation.h"
#include "widgets/waypoints/waypoint_properties.h"

namespace tiller {

WaypointHistoryDialog::WaypointHistoryDialog(const ProjectDocument& document,
                                             const project::Waypoint& waypoint, QWidget* parent)
    : QDialog(parent)
    , document_(document)
    , waypoint_(waypoint)
    , list_(new QListWidget)
    , compare_(new QLabel) {
    setObjectName(QStringLiteral("waypoint.history"));
    setWindowTitle(tr("History of “%1”").arg(waypoint.name));
    list_->setObjectName(QStringLiteral("waypoint.history.list"));
    list_->setAccessibleName(tr("Changes, newest first"));
    for (int i = waypoint.history.size() - 1; i >= 0; --i) {
        const project::WaypointRevision& one = waypoint.history.at(i);
        const QString when = QLocale().toString(one.at.toLocalTime(), QLocale::ShortFormat);
        list_->addItem(one.who.isEmpty() ? tr("%1  %2").arg(when, one.what)
                                         : tr("%1  %2  (%3)").arg(when, one.what, one.who));
    }
    compare_->setObjectName(QStringLiteral("waypoint.history.compare"));
    compare_->setWordWrap(true);
    compare_->setMinimumSize(420, 6 * fontMetrics().height());
    compare_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    revert_ = buttons->button(QDialogButtonBox::Ok);
    revert_->setText(tr("Restore the version before this change"));
    revert_->setObjectName(QStringLiteral("waypoint.history.revert"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list_, 1);
    layout->addWidget(compare_);
    layout->addWidget(buttons);
    connect(list_, &QListWidget::currentRowChanged, this, &WaypointHistoryDialog::refresh);
    list_->setCurrentRow(0);
    refresh();
}

const project::WaypointRevision& WaypointHistoryDialog::revision() const {
    return waypoint_.history.at(waypoint_.history.size() - 1 - std::max(0, list_->currentRow()));
}

project::Waypoint WaypointHistoryDialog::chosen() const {
    project::Waypoint result = revision().before;
    result.history = waypoint_.history;
    // Since that change, another waypoint may have received the name, and the pattern may have been deleted.
    const int named = document_.waypoints().indexOfName(result.name);
    if (named >= 0 && document_.waypoints().at(named).id != result.id) {
        result.name = waypoint_.name;
    }
    if (document_.patterns().find(result.place.pattern) == nullptr) {
        result.place = {};
    }
    return result;
}

QStringList WaypointHistoryDialog::differences(const project::Waypoint& before, const project::Waypoint& now,
                                               const ProjectDocument& document) {
    QStringList lines;
    if (before.name != now.name) {
        lines << tr("Name: “%1” → “%2”").arg(before.name, now.name);
    }
    const auto placeBefore = project::placeOf(before, document.robot(), document.frames());
    const auto placeNow = project::placeOf(now, document.robot(), document.frames());
    if (placeBefore && placeNow) {
        const project::PoseDifference by = project::poseDifference(*placeBefore, *placeNow);
        if (by.distance > 1e-6 || by.angle > 1e-5) {
            lines << tr("Position: moved by %1 (%2, base frame)")
                         .arg(format::difference(by.distance, by.angle),
                              format::shift(placeNow->position - placeBefore->position));
        }
    }
    const Vector6 turns = now.joints.values - before.joints.values;
    int joint = 0;
    if (turns.cwiseAbs().maxCoeff(&joint) > 1e-5) {
        lines << tr("Joints: largest change %2 (%1)").arg(jointName(joint), format::degrees(turns[joint], 1));
    }
    const auto frameText = [&](const project::Waypoint& point) {
        const project::Frame* frame = document.frames().find(point.frame);
        return point.priority == project::TargetKind::Joints ? tr("none (joints have priority)")
               : point.frame.isNull()                        ? tr("Base")
               : frame != nullptr                            ? frame->name
                                                             : tr("a deleted frame");
    };
    if (before.priority != now.priority || before.frame != now.frame) {
        lines << tr("Frame: %1 → %2").arg(frameText(before), frameText(now));
    }
    if (before.move != now.move) {
        lines << (now.move == project::MoveKind::Joint ? tr("Move: MoveL → MoveJ")
                                                       : tr("Move: MoveJ → MoveL"));
    }
    if (before.jointSpeed != now.jointSpeed) {
        lines << tr("MoveJ speed: %1 → %2")
                     .arg(format::degreesPerSecond(before.jointSpeed),
                          format::degreesPerSecond(now.jointSpeed));
    }
    if (before.toolSpeed != now.toolSpeed) {
        lines
            << tr("MoveL speed: %1 → %2").arg(format::speed(before.toolSpeed), format::speed(now.toolSpeed));
    }
    if (before.blend != now.blend) {
        lines << tr("Blend: %1 → %2").arg(format::length(before.blend, 1), format::length(now.blend, 1));
    }
    if (!(before.tcpOffset == now.tcpOffset)) {
        lines << tr("TCP: taught with a different TCP");
    }
    if (before.group != now.group) {
        lines << tr("Group: “%1” → “%2”").arg(before.group, now.group);
    }
    if (before.colour != now.colour) {
        lines << tr("Colour: %1 → %2")
                     .arg(WaypointProperties::colourNames().value(static_cast<int>(before.colour)),
                          WaypointProperties::colourNames().value(static_cast<int>(now.colour)));
    }
    if (before.note != now.note) {
        lines << tr("Note: “%1” → “%2”").arg(before.note, now.note);
    }
    if (before.actions != now.actions) {
        lines << tr("Actions: changed");
    }
    return lines;
}

void WaypointHistoryDialog::refresh() {
    revert_->setEnabled(!waypoint_.history.isEmpty());
    if (waypoint_.history.isEmpty()) {
        compare_->setText(tr("No changes have been recorded for this waypoint."));
        return;
    }
    const QStringList lines = differences(revision().before, waypoint_, document_);
    compare_->setText(lines.isEmpty()
                          ? tr("The version before this change is identical to the current version.")
                          : tr("Changes from the version before this change to the current version:") +
                                QLatin1Char('\n') + lines.join(QLatin1Char('\n')));
}

}  // namespace tiller

#include "moc_waypoint_history_dialog.cpp"
