// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tutorial.h"

#include <QRandomGenerator>
#include <algorithm>

#include "app/action_table.h"
#include "app/local_simulator.h"
#include "app/settings.h"
#include "robot/station/document/project_document.h"
#include "widgets/practice/first_steps_card.h"
#include "widgets/practice/practice_card.h"
#include "widgets/scene/scene_view.h"

namespace tiller::app {
namespace {

// Force range for the task "record and measure" [N]. The forces are measurable and far below those that cause
// a protective stop.
constexpr int kMinHandForce = 25;
constexpr int kMaxHandForce = 60;

}  // namespace

Tutorial::Tutorial(RobotSession& session, ProjectDocument& document, LocalSimulator& simulator,
                   Settings& settings, SceneView& view)
    : session_(session)
    , document_(document)
    , simulator_(simulator)
    , settings_(settings)
    , steps_(session, document)
    , practice_(session, document, hooks())
    , stepsCard_(new FirstStepsCard(steps_, view))
    , practiceCard_(new PracticeCard(practice_, view)) {
    readAgain();
    const auto remember = [this] {
        settings_.setTutorialProgress({settings_.learned().dismissed, steps_.done(), practice_.done()});
    };
    connect(&steps_, &FirstSteps::changed, this, remember);
    connect(&practice_, &Practice::taskDone, this, remember);
    connect(&session_, &RobotSession::stateChanged, this, &Tutorial::onState);
    connect(stepsCard_, &FirstStepsCard::practiceRequested, this, &Tutorial::showPractice);
    connect(stepsCard_, &FirstStepsCard::dismissed, this, [this] {
        settings_.setTutorialProgress({true, steps_.done(), practice_.done()});
        stepsCard_->putAway();
    });
    connect(stepsCard_, &ViewCard::closeRequested, stepsCard_, &ViewCard::putAway);
    const auto uncover = [this, &view] {
        view.setCoveredBelow(std::max(stepsCard_->covered(), practiceCard_->covered()));
    };
    connect(stepsCard_, &ViewCard::coveredChanged, &view, uncover);
    connect(practiceCard_, &ViewCard::coveredChanged, &view, uncover);
    connect(practiceCard_, &ViewCard::closeRequested, this, [this] {
        practice_.abandon();
        practiceCard_->putAway();
    });
}

Tutorial::~Tutorial() {
    delete stepsCard_;
    delete practiceCard_;
}

void Tutorial::readAgain() {
    const TutorialProgress learned = settings_.learned();
    // Restore the practice tasks first, because a change of the first steps saves both.
    practice_.setDone(learned.practice);
    steps_.setDone(learned.firstSteps);
}

void Tutorial::addTo(ActionTable& table) {
    table.add({"app.firstSteps",
               tr("First steps"),
               tr("Shows a checklist in the view, from powering on to recording."),
               {},
               [this] { showFirstSteps(); }});
    table.add({"app.practice",
               tr("Practice tasks"),
               tr("Five tasks on the simulated robot. Each task checks the result."),
               {},
               [this] { showPractice(); }});
}

void Tutorial::showFirstSteps() {
    practice_.abandon();
    practiceCard_->putAway();
    stepsCard_->setFolded(false);
    stepsCard_->open();
}

void Tutorial::showPractice() {
    stepsCard_->putAway();
    practiceCard_->setFolded(false);
    practiceCard_->open();
}

void Tutorial::onState(const SessionState& state) {
    const bool here = simulator_.controllerOf(state) != nullptr;
    // Keep the state during a gap between two packets.
    if (!here && state.link != LinkState::Disconnected && !state.hasData()) {
        return;
    }
    steps_.setFollowing(here);
    if (here == here_) {
        return;
    }
    here_ = here;
    if (!here) {
        stepsCard_->putAway();
    } else if (!settings_.learned().dismissed && practiceCard_->isHidden()) {
        stepsCard_->openQuietly();
    }
}

PracticeHooks Tutorial::hooks() {
    return {.obstacle =
                [this](const SessionState& state) {
                    return simulator_.controllerOf(state) != nullptr || state.link == LinkState::Lost ||
                                   state.link == LinkState::Stale
                               ? QString()
                               : tr("Practice works only with the built-in simulated robot. The current "
                                    "robot is “%1”. Connect to the simulated robot first.")
                                     .arg(state.robotName);
                },
            .setUp = [this](PracticeTask task) { setUp(task); },
            .tidyUp =
                [this] {
                    for (simulator::Simulator* controller : simulator_.controllers()) {
                        controller->pressHand({});
                    }
                },
            .addWaypoint =
                [this](const project::Waypoint& point) {
                    steps_.setFollowing(false);  // this waypoint does not count as taught
                    document_.insertWaypoints(document_.waypoints().size(), {point},
                                              tr("Practice: add “%1”").arg(point.name));
                }};
}

void Tutorial::setUp(PracticeTask task) {
    simulator::Simulator* controller = simulator_.controllerOf(session_.state());
    if (controller == nullptr) {
        return;
    }
    if (task == PracticeTask::Recover) {
        controller->protectiveStop();
    } else if (task == PracticeTask::Measure) {
        const double force = QRandomGenerator::global()->bounded(kMinHandForce, kMaxHandForce);
        controller->pressHand({Eigen::Vector3d(0, 0, -force), Eigen::Vector3d::Zero()});
    }
}

}  // namespace tiller::app

#include "moc_tutorial.cpp"
