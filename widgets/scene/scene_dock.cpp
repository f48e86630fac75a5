// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_dock.h"

#include <QVBoxLayout>

#include "robot/receive/robot_state.h"
#include "robot/station/link/robot_session.h"
#include "widgets/common/replay_band.h"
#include "widgets/scene/scene_view.h"

namespace tiller {

SceneDock::SceneDock(RobotSession& session, QWidget* parent)
    : Panel(QString(), parent)
    , view_(new SceneView)
    , band_(new ReplayBand(QStringLiteral("view.replay"), view_)) {
    setObjectName(QStringLiteral("view"));
    setTitle(tr("View"));
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(view_, 1);
    layout->addWidget(band_);
    setContent(content);
    connect(band_, &ReplayBand::liveWanted, this, &SceneDock::liveWanted);
    connect(view_, &SceneView::ghostTextChanged, this, &Panel::setHint);
    connect(&session, &RobotSession::stateChanged, view_, &SceneView::setState);
    view_->setState(session.state());
}

void SceneDock::setReplay(const Replay& moment) {
    std::optional<ReplayMark> mark;
    if (moment) {
        mark = ReplayMark{JointPositions(), moment->words()};
        mark->q.values.setConstant(receive::kAbsent);
        if (!moment->sample.isEmpty()) {
            mark->q = receive::RobotState(moment->sample).q();
        }
        mark->model = moment->model;
        if (!mark->q.allFinite()) {
            // Insert this text at the start, because the end of the text may be elided.
            mark->words = tr("No joint positions to replay") + QStringLiteral(" · ") + mark->words;
        } else if (!mark->model) {
            mark->words = tr("Robot model unknown") + QStringLiteral(" · ") + mark->words;
        }
    }
    band_->tell(mark ? mark->words : QString());
    view_->setReplay(mark);
}

}  // namespace tiller

#include "moc_scene_dock.cpp"
