// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_dock.h"

#include "widgets/scene/scene_view.h"
#include "widgets/session/robot_session.h"

namespace tiller {

SceneDock::SceneDock(RobotSession& session, QWidget* parent)
    : Panel(QString(), parent), view_(new SceneView) {
    setObjectName(QStringLiteral("view"));
    setTitle(tr("View"));
    setContent(view_);
    connect(view_, &SceneView::ghostTextChanged, this, &Panel::setHint);
    connect(&session, &RobotSession::stateChanged, view_, &SceneView::setState);
    view_->setState(session.state());
}

}  // namespace tiller

#include "moc_scene_dock.cpp"
