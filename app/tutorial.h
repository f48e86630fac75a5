// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Introduction for new users: the practice tasks, and the checklist of the first steps, which is shown until
// the user closes it. Both require the simulated robot of this application.

#include <QObject>

#include "robot/station/practice/first_steps.h"
#include "robot/station/practice/practice.h"

namespace tiller {

class FirstStepsCard;
class PracticeCard;
class ProjectDocument;
class RobotSession;
class SceneView;

namespace app {

class ActionTable;
class LocalSimulator;
class Settings;

class Tutorial : public QObject {
    Q_OBJECT

public:
    /// All arguments must outlive the object. The cards are overlays on `view`.
    Tutorial(RobotSession& session, ProjectDocument& document, LocalSimulator& simulator, Settings& settings,
             SceneView& view);
    ~Tutorial() override;

    void addTo(ActionTable& table);
    /// Reloads the progress after an import of the settings.
    void readAgain();
    void showFirstSteps();
    void showPractice();

private:
    PracticeHooks hooks();
    void onState(const SessionState& state);
    void setUp(PracticeTask task);

    RobotSession& session_;
    ProjectDocument& document_;
    LocalSimulator& simulator_;
    Settings& settings_;
    FirstSteps steps_;
    Practice practice_;
    FirstStepsCard* stepsCard_;
    PracticeCard* practiceCard_;
    bool here_ = false;  ///< true while connected to the simulated robot of this application
};

}  // namespace app
}  // namespace tiller
