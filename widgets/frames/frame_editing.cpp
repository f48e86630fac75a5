// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_editing.h"

#include "robot/station/document/project_document.h"
#include "robot/station/text/notation.h"
#include "widgets/common/notice_bar.h"

namespace tiller {
namespace {

QString movedText(int waypoints) {
    return waypoints == 0 ? FrameEditing::tr("No waypoints moved with the frame.")
                          : FrameEditing::tr("%n waypoints moved with the frame.", nullptr, waypoints);
}

QString outOfReachText(int waypoints) {
    return waypoints == 0 ? QString() : FrameEditing::tr("Waypoints out of reach: %n.", nullptr, waypoints);
}

}  // namespace

FrameEditing::FrameEditing(ProjectDocument& document, FrameModel& model, NoticeBar& notice, Journal& journal,
                           QObject* parent)
    : QObject(parent), document_(document), model_(model), notice_(notice), journal_(journal) {
    connect(&document_, &ProjectDocument::documentChanged, this, [this] { checked_.reset(); });
}

void FrameEditing::insert(const Pose& T_base_frame) {
    project::Frame frame;
    frame.id = QUuid::createUuid();
    frame.name = model_.frames().nextName(tr("frame"));
    frame.T_base_frame = T_base_frame;
    document_.insertFrame(model_.rowCount(), frame, tr("Teach “%1”").arg(frame.name));
}

FrameUse FrameEditing::useAt(const QUuid& id, const Pose& T_base_frame) {
    constexpr double kSamePosition = 1e-4;  // [m] measured positions vary at standstill
    constexpr double kSameRotation = 1e-3;  // [rad]
    if (checked_ && checked_->id == id) {
        const project::PoseDifference by = project::poseDifference(checked_->T_base_frame, T_base_frame);
        if (by.distance < kSamePosition && by.angle < kSameRotation) {
            return checked_->use;
        }
    }
    checked_ = {id, T_base_frame, model_.use(id, T_base_frame)};
    return checked_->use;
}

QString FrameEditing::moveText(const QUuid& id, const Pose& T_base_frame) {
    const int row = model_.rowOf(id);
    if (row < 0) {
        return {};
    }
    const project::Frame& frame = model_.frames().at(static_cast<std::size_t>(row));
    const project::PoseDifference by = project::poseDifference(frame.T_base_frame, T_base_frame);
    const FrameUse use = useAt(id, T_base_frame);
    QStringList lines = {tr("The frame moves by %1 (%2, base frame).")
                             .arg(format::difference(by.distance, by.angle),
                                  format::shift(T_base_frame.position - frame.T_base_frame.position)),
                         use.waypoints == 0
                             ? tr("No waypoint uses this frame.")
                             : tr("%n waypoints move with the frame.", nullptr, use.waypoints)};
    if (use.outOfReach > 0) {
        lines << outOfReachText(use.outOfReach);
    }
    return lines.join(QLatin1Char(' '));
}

void FrameEditing::askToMove(const QUuid& id, const PoseSource& newPose) {
    const int row = model_.rowOf(id);
    if (row < 0) {
        return;
    }
    const QString name = model_.frames().at(static_cast<std::size_t>(row)).name;
    const auto accepted = [this, id, newPose, name] {
        const NewPose now = newPose();
        if (!now.obstacle.isEmpty()) {
            notice_.show(NoticeBar::Kind::Warning, now.obstacle, {});
            return;
        }
        const QString moved = move(id, now.T_base_frame, tr("Touch up “%1”").arg(name));
        const QString done = tr("Touched up “%1”").arg(name);
        notice_.show(NoticeBar::Kind::Question, done, moved);
        journal_.add(Severity::Info, done + QStringLiteral(". ") + moved);
    };
    notice_.show(NoticeBar::Kind::Question,
                 {.title = tr("Touch up “%1”?").arg(name),
                  .accept = tr("Touch up"),
                  .accepted = accepted,
                  .liveText = [this, id, newPose] { return moveText(id, newPose().T_base_frame); }});
}

QString FrameEditing::move(const QUuid& id, const Pose& T_base_frame, const QString& step) {
    const int row = model_.rowOf(id);
    if (row < 0) {
        return {};
    }
    project::Frame frame = model_.frames().at(static_cast<std::size_t>(row));
    frame.T_base_frame = T_base_frame;
    document_.changeFrame(row, frame, step);
    const FrameUse use = model_.use(frame);
    QString text = movedText(use.waypoints);
    if (use.outOfReach > 0) {
        text += QLatin1Char(' ') + outOfReachText(use.outOfReach);
    }
    return text;
}

void FrameEditing::place(const project::Frame& frame, const Pose& T_base_frame) {
    // Show only a log entry, because a notice would be distracting while the user edits numbers.
    const QString moved = move(frame.id, T_base_frame, tr("Change the pose of “%1”").arg(frame.name));
    journal_.add(Severity::Info, tr("The pose of “%1” was changed. %2").arg(frame.name, moved));
}

void FrameEditing::duplicate(const project::Frame& frame) {
    project::Frame copy = frame;
    copy.id = QUuid::createUuid();
    copy.name = model_.frames().uniqueName(frame.name);
    document_.insertFrame(model_.rowOf(frame.id) + 1, copy, tr("Duplicate “%1”").arg(frame.name));
}

void FrameEditing::remove(const project::Frame& frame) {
    const int waypoints = model_.use(frame).waypoints;
    if (waypoints == 0) {
        document_.removeFrame(model_.rowOf(frame.id));
        return;
    }
    notice_.show(NoticeBar::Kind::Question, tr("Delete “%1”?").arg(frame.name),
                 tr("%n waypoints use this frame. They keep their positions and are converted to Base.",
                    nullptr, waypoints),
                 tr("Delete frame"), [this, id = frame.id] {
                     if (const int row = model_.rowOf(id); row >= 0) {
                         document_.removeFrame(row);
                     }
                 });
}

}  // namespace tiller

#include "moc_frame_editing.cpp"
