// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Somebody who knows nothing and tries everything: clicks, keys, wheel, drags, other sizes of the window, while
// cables are pulled and stops are pressed on the simulated robot. A colleague, the "care", now and then puts
// right what has been put wrong, so that there is a robot to play with. All in real time, from one seed.
//
// Judged are, all the time or after each quiet moment:
// - places: nothing moves under the pointer after a click (PlacesWatch);
// - truth: what the window says is so, or is marked as unknown (TruthCheck);
// - rest: once the hand holds nothing the arm comes to stand, and stands until the next press.

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

/// Time as a window has it on a machine that gives it time: neither a processor that is busy elsewhere nor a
/// robot whose time stands still count against it.
class Patience {
public:
    explicit Patience(const simulator::Simulator& robot);
    /// Lets events run for a moment.
    void wait();
    double ms() const;  ///< so far
    /// Nobody waits that long: something stands still for good.
    bool isHopeless() const;

private:
    const simulator::Simulator& robot_;
    double began_;  ///< the robot's time [s]
    QElapsedTimer real_;
    int turns_ = 0;
};

class RandomUser : public QObject {
public:
    /// place  of the robot among those of one process: each has an address of its own
    RandomUser(quint32 seed, int place);
    ~RandomUser() override;

    /// Opens the window and takes control of the robot.
    /// Returns  false when it did not happen; failure() says why
    bool begin();
    /// So many steps, or until something is wrong.
    void play(int steps);
    /// Puts everything right and looks whether the window is as good as new.
    void finish();

    /// What was wrong; empty: nothing.
    QString failure() const { return failure_; }
    int steps() const { return number_; }

    // What was really tried: a user who never moves an arm finds nothing.
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
        bool whileHeld = false;   ///< also while a mouse button is down
        bool keepsWatch = false;  ///< nothing that could excuse a control for moving
        bool mayMoveArm = true;   ///< what rested may move from now on
    };
    static const QList<Act>& acts();

    void step();
    void note(const QString& what);
    void fail(const QString& what);
    bool isFine() const { return failure_.isEmpty(); }

    // Random choices.
    int below(qsizetype count);
    bool chance(int percent) { return below(100) < percent; }
    const Act& drawAct(bool held);
    QList<QWidget*> windowsInReach() const;
    QWidget* someWindow();
    std::optional<Target> someControl();
    std::optional<Target> somePixel();
    std::optional<Target> someHoldKey();

    // What a user does.
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

    // What happens to the robot.
    void faultOrCure();
    void care();
    void inject(const QString& words);
    void cureAll();
    void tellPendant(const QByteArray& line);

    // Around the steps.
    void bringWindowBack();
    void endOldDialogs();
    void closeAllDialogs();
    void visit();
    void endNestedLoop();
    void endFileDialog();

    // The judges.
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
    int dialogAge_ = 0;  ///< steps since a dialog stands before the window
    int stuck_ = 0;      ///< ticks in an event loop inside a step
    std::optional<Target> last_;
    QStringList cures_;  ///< what ends the faults under way
    bool linkTouched_ = false;
    QElapsedTimer sinceLinkTouched_;
    std::optional<JointPositions> resting_;  ///< where the arm stands since the hand has let go
};

}  // namespace tiller::test
