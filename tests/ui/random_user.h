// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A random user: clicks, presses keys, uses the mouse wheel, drags and resizes the window, while connections
// are cut and stops are triggered on the simulated robot. A "care" function occasionally corrects problems,
// so that a usable robot exists. Everything runs in real time, with one seed.
//
// Checks, made continuously or after each quiet period:
// - places: nothing moves under the pointer after a click (PlacesWatch);
// - truth: the displayed state is correct, or marked as unknown (TruthCheck);
// - rest: without operator input the arm stops, and it does not move before the next press.

#include <QObject>
#include <QRandomGenerator>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTimer>
#include <optional>

#include "app/main_window.h"
#include "robot/simulator/simulator.h"
#include "tests/ui/places_watch.h"
#include "tests/ui/truth_check.h"
#include "tests/ui/window_hand.h"

namespace tiller::test {

/// Measures the time that the window had for its work. Excludes time in which other processes used the CPU or
/// robot time did not advance.
class WaitTime {
public:
    explicit WaitTime(const simulator::Simulator& robot);
    /// Processes events for a few milliseconds.
    void wait();
    double ms() const;  ///< time so far
    /// True if no operation can take this time, so the window must be hanging.
    bool isHopeless() const;

private:
    const simulator::Simulator& robot_;
    double began_;  ///< robot time at the start [s]
    QElapsedTimer real_;
    int turns_ = 0;
};

class RandomUser : public QObject {
public:
    /// place  index of the robot in this process, used for a separate address
    RandomUser(quint32 seed, int place);
    ~RandomUser() override;

    /// Opens the window and takes control of the robot.
    /// Returns false on failure; failure() contains the reason.
    bool begin();
    /// Performs this number of steps, or fewer if a check fails.
    void play(int steps);
    /// Corrects all problems and checks that the window works normally.
    void finish();

    /// The description of the failed check; empty if none has failed.
    QString failure() const { return failure_; }
    int steps() const { return number_; }

    // Statistics of the actions. They show whether the random user was effective: without motions, it would
    // not find any errors.
    int stepsInMotion() const { return stepsInMotion_; }
    int watchedClicks() const { return watchedClicks_; }
    int comparedValues() const { return truth_.compared(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Target {
        QPointer<QWidget> window;
        QPoint at;
        QString name;
    };
    struct Act {
        int weight;
        void (RandomUser::*run)();
        bool whileHeld = false;   ///< true if the action is also possible while a mouse button is pressed
        bool keepsWatch = false;  ///< true if controls must not move during the action
        bool mayMoveArm = true;   ///< true if the action may move an arm at standstill
    };
    static const QList<Act>& acts();

    void step();
    void note(const QString& what);
    void fail(const QString& what);
    bool isFine() const { return failure_.isEmpty(); }

    // Pseudo-random numbers.
    int below(qsizetype count);
    bool chance(int percent) { return below(100) < percent; }
    const Act& drawAct(bool held);
    QList<QWidget*> windowsInReach() const;
    QWidget* someWindow();
    std::optional<Target> someControl();
    std::optional<Target> somePixel();
    std::optional<Target> someHoldKey();

    // User actions.
    void clickControl();
    void clickPixel();
    void clickAgain();
    void clickOther();
    void doubleClick();
    void holdKeyOnScreen();
    void wander();
    void turnWheel();
    void drag();
    void pressKey();
    void holdKey();
    void typeText();
    void pasteText();
    void resizeWindow();
    void letGo();
    void wait();
    void click(const Target& target);

    // Robot events.
    void faultOrCure();
    void care();
    void inject(const QString& words);
    void cureAll();
    void tellPendant(const QByteArray& line);

    // Clean-up functions that are called before and after the steps.
    void bringWindowBack();
    void endOldDialogs();
    void closeAllDialogs();
    void visit();
    void endNestedLoop();
    void endFileDialog();

    // The checks.
    void judgePlaces();
    void judgeRest();
    void watchOn(int ms);
    void quietMoment();
    bool comesToRest();
    void judgeTruth();
    int graceOf(const Lie& lie) const;

    QRandomGenerator random_;
    QTemporaryDir folder_;
    simulator::Simulator robot_;
    app::MainWindow window_;
    WindowHand hand_;
    PlacesWatch places_;
    TruthCheck truth_;
    QTimer visitor_;

    QString failure_;
    int number_ = 0;
    int stepsInMotion_ = 0;
    int watchedClicks_ = 0;
    int dialogAge_ = 0;  ///< steps since a dialog was opened
    int stuck_ = 0;      ///< number of ticks in an event loop inside a step
    std::optional<Target> last_;
    QStringList cures_;  ///< commands that end the active faults
    bool linkTouched_ = false;
    QElapsedTimer sinceLinkTouched_;
    std::optional<JointPositions> resting_;  ///< position of the arm after it has stopped
};

}  // namespace tiller::test
