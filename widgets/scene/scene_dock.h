// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "View": the scene, fed by the session, with the ghost's figures in the title bar.

#include "robot/station/history/replay_moment.h"
#include "widgets/common/panel.h"

namespace tiller {

class ReplayBand;
class RobotSession;
class SceneView;

class SceneDock : public Panel {
    Q_OBJECT

public:
    explicit SceneDock(RobotSession& session, QWidget* parent = nullptr);

    SceneView& view() { return *view_; }
    /// Shows besides how the arm stood in a moment, and says so under the picture. Nothing: live.
    void setReplay(const Replay& moment);

Q_SIGNALS:
    /// From a replay back to what is live.
    void liveWanted();

private:
    SceneView* view_;
    ReplayBand* band_;
};

}  // namespace tiller
