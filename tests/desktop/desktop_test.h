// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Common parts of the tests on a real display. Before each test function, they provide a running cell in
// control with no key held. They also evaluate the arm's motion after the last key was released.

#include <QObject>
#include <QTest>
#include <cstdio>
#include <functional>
#include <memory>

#include "tests/desktop/desktop_cell.h"

namespace tiller::test {

/// Exit code that ctest reports as "skipped".
inline constexpr int kSkipped = 77;

/// Jog contract: maximum time of motion after the release of the last key [s].
inline constexpr double kContract = 0.25;
/// Maximum robot time until a motion has started [s].
inline constexpr double kGetsGoing = 3.0;

inline QByteArray words(const Standstill& stop) {
    const QByteArray ms = QByteArray::number(stop.seconds * 1e3, 'f', 0) + " ms (" +
                          QByteArray::number(stop.withoutProcessor * 1e3, 'f', 0) +
                          " ms without a processor)";
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
    /// The controls used by the test must be visible on this screen.
    virtual QSize screen() const { return {1280, 800}; }
    /// Name of the window manager for the current row.
    virtual QString windowManager() const { return DesktopCell::kOpenbox; }
    XHand& hand() { return cell_->hand(); }
    ArmWatch& arm() { return cell_->arm(); }
    /// For tests that leave the cell in an unusable state. The next test then gets a new cell.
    void useUp() { usedUp_ = true; }

    /// Presses and waits until the arm is moving. On a busy computer, a press may be refused because of late
    /// data, or control may be lost. The press is then repeated after `release`.
    void holdBy(const std::function<void()>& press, const std::function<void()>& release) {
        for (int attempt = 0; attempt < 5; ++attempt) {
            QVERIFY(beReady());
            press();
            if (arm().untilMoving(kGetsGoing)) {
                return;
            }
            release();
        }
        QFAIL("the arm did not move during the hold, so the test shows nothing");
    }
    /// Makes sure that the cell is in control with the keyboard armed. On a busy machine, control may have
    /// been lost.
    bool beReady() {
        return cell().until(
            [&] { return cell().toTheFront() && cell().takeControl() && cell().armKeyboard(); });
    }
    /// Verifies that the arm stops within the time allowed by the jog contract and does not move again.
    void verifyStands(double contract = kContract) {
        const Standstill stop = cell().standstill(contract);
        qInfo("%s", words(stop).constData());
        QVERIFY2(stop.verdict != Standstill::Verdict::GoesOn && stop.verdict != Standstill::Verdict::Blind,
                 words(stop).constData());
        QVERIFY2(stop.verdict == Standstill::Verdict::Stood, words(stop).constData());
        QVERIFY2(arm().stays(0.5), "the arm stopped, but moved again by itself");
    }

private Q_SLOTS:
    void init() {
        if (const QString obstacle = DesktopCell::obstacle(windowManager()); !obstacle.isEmpty()) {
            QSKIP(qPrintable(obstacle));
        }
        if (!cell_) {
            auto made = std::make_unique<DesktopCell>(screen(), windowManager());
            QVERIFY2(made->bringUp(), qPrintable(made->what()));
            cell_ = std::move(made);
        }
        QVERIFY2(cell_->setLayout("us"), "the layout could not be set");
        QVERIFY2(beReady(), "control could not be taken, or keyboard jogging could not be armed");
        QVERIFY(arm().untilStanding(5));
    }
    void cleanup() {
        if (!cell_) {
            return;
        }
        hand().letGoOfAll();
        hand().tap(kEscape);
        // An arm that is still moving must not affect the next test.
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

/// If the computer has no display for tests, prints the missing requirement and exits with ctest's code for
/// "skipped".
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
