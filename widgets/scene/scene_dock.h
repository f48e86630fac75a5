// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The panel "View": the scene, fed by the session, with the ghost's figures in the title bar.

#include "widgets/common/panel.h"

namespace tiller {

class RobotSession;
class SceneView;

class SceneDock : public Panel {
    Q_OBJECT

public:
    explicit SceneDock(RobotSession& session, QWidget* parent = nullptr);

    SceneView& view() { return *view_; }

private:
    SceneView* view_;
};

}  // namespace tiller
