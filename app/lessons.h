// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What helps a newcomer in the window: the checklist of the first steps, shown by itself until it is dismissed,
// and the practice tasks. Both are for the simulated robot of this program.

#include <QObject>

#include "widgets/practice/first_steps.h"
#include "widgets/practice/practice.h"

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

class Lessons : public QObject {
    Q_OBJECT

public:
    /// All must outlive it; the cards lie over `view`.
    Lessons(RobotSession& session, ProjectDocument& document, LocalSimulator& simulator, Settings& settings,
            SceneView& view);
    ~Lessons() override;

    void addTo(ActionTable& table);
    /// The settings now say something else of what was done.
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
    bool here_ = false;  ///< connected to the simulated robot of this program
};

}  // namespace app
}  // namespace tiller
