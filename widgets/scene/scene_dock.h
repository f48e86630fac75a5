// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "View". Shows the scene with data from the session, and values of the ghost in the title bar.

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
    /// Also shows the arm at a past time, with a text below the image. Empty: live data only.
    void setReplay(const Replay& moment);

Q_SIGNALS:
    /// The user wants to return to live data.
    void liveWanted();

private:
    SceneView* view_;
    ReplayBand* band_;
};

}  // namespace tiller
