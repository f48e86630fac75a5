// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The viewing directions of the 3D view as commands, for the keyboard and the command list.

#include <QCoreApplication>

namespace tiller {
class SceneView;
}  // namespace tiller

namespace tiller::app {

class ActionTable;

class SceneActions {
    Q_DECLARE_TR_FUNCTIONS(SceneActions)

public:
    /// view  must outlive the table
    static void addTo(ActionTable& table, SceneView& view);
};

}  // namespace tiller::app
