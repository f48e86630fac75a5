// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tests at a real display share: a cell that is up, in control, with nothing held, before each test
// function; and the judgement of what the arm did after the last key was let go.

#include <QObject>
#include <QTest>
#include <cstdio>
#include <functional>
#include <memory>

#include "tests/desktop/desktop_cell.h"

namespace tiller::test {

/// What ctest takes for "skipped".
inline constexpr int kSkipped = 77;

/// The jog contract: nothing may move so long after the last key [s].
inline constexpr double kContract = 0.25;
/// Longer than it takes to get going, in the robot's time.
inline constexpr double kGetsGoing = 3.0;

inline QByteArray words(const Standstill& stop) {
    const QByteArray ms = QByteArray::number(stop.seconds * 1e3, 'f', 0) + " ms";
    switch (stop.verdict) {
        case Standstill::Verdict::Stood:
            return "stood after " + ms;
        case Standstill::Verdict::Late:
            return "stood late, after " + ms;
        case Standstill::Verdict::GoesOn:
            return "GOES ON, " + ms + " later";
        case Standstill::Verdict::Blind:
            return "no data from the robot";
    }
    return {};
}

class DesktopTest : public QObject {
    Q_OBJECT

protected:
    DesktopCell& cell() { return *cell_; }
    /// What is to be tried must be in sight.
    virtual QSize screen() const { return {1280, 800}; }
    XHand& hand() { return cell_->hand(); }
    ArmWatch& arm() { return cell_->arm(); }
    /// For tests that leave something broken behind: the next one gets a cell of its own.
    void useUp() { usedUp_ = true; }

    /// Presses, waits until the arm is under way. On a busy machine a press may be refused, because data were
    /// late: then another one, after `release`.
    void holdBy(const std::function<void()>& press, const std::function<void()>& release) {
        for (int attempt = 0; attempt < 5; ++attempt) {
            QVERIFY(cell().until([&] { return cell().place("jog.X+").enabled; }));
            press();
            if (arm().untilMoving(kGetsGoing)) {
                return;
            }
            release();
        }
        QFAIL("nothing moved while it was held: this proves nothing");
    }
    /// The arm stands for good, now that nothing is held. What only came late on a busy machine is told.
    void verifyStands(double contract = kContract) {
        const Standstill stop = arm().standstill(contract);
        qInfo("%s", words(stop).constData());
        QVERIFY2(stop.verdict != Standstill::Verdict::GoesOn && stop.verdict != Standstill::Verdict::Blind,
                 words(stop).constData());
        QVERIFY2(stop.verdict == Standstill::Verdict::Stood, words(stop).constData());
        QVERIFY2(arm().stays(0.5), "it stood, and moved again by itself");
    }

private Q_SLOTS:
    void init() {
        if (!cell_) {
            auto made = std::make_unique<DesktopCell>(screen());
            QVERIFY2(made->bringUp(), qPrintable(made->what()));
            cell_ = std::move(made);
        }
        QVERIFY2(cell_->setLayout("us"), "the layout could not be set");
        QVERIFY2(cell_->armKeyboard(), "keyboard jogging could not be armed");
        QVERIFY(arm().untilStanding(5));
    }
    void cleanup() {
        if (!cell_) {
            return;
        }
        hand().letGoOfAll();
        hand().tap(kEscape);
        // A run-away must not be the next test's.
        if (usedUp_ || QTest::currentTestFailed() || !arm().untilStanding(2)) {
            cell_.reset();
            usedUp_ = false;
        }
    }
    void cleanupTestCase() { cell_.reset(); }

private:
    std::unique_ptr<DesktopCell> cell_;
    bool usedUp_ = false;
};

}  // namespace tiller::test

/// Says what is missing and ends with ctest's code for "skipped" where the machine has no display to test on.
#define TILLER_DESKTOP_MAIN(Test)                                       \
    int main(int argc, char* argv[]) {                                  \
        QCoreApplication application(argc, argv);                       \
        const QString obstacle = tiller::test::DesktopCell::obstacle(); \
        if (!obstacle.isEmpty()) {                                      \
            std::printf("Skipped: %s\n", qPrintable(obstacle));         \
            return tiller::test::kSkipped;                              \
        }                                                               \
        Test test;                                                      \
        return QTest::qExec(&test, argc, argv);                         \
    }
