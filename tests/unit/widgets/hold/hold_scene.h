// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Two hold-to-run buttons, an edit field and a push button in one window, in virtual time. Shared by the
// tests of the hold guard.

#include <QApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>

#include "robot/core/clock.h"
#include "widgets/hold/hold_to_run_button.h"

Q_DECLARE_METATYPE(tiller::control::StopCause)

namespace tiller::test {

using control::StopCause;

/// Replaces the session and counts the calls.
struct FakeTarget {
    std::uint64_t next = 0;
    std::uint64_t running = 0;  // 0: no motion is active
    int begun = 0;
    int holds = 0;
    QList<StopCause> ends;
    bool refuse = false;
    bool bounded = false;

    HoldMotion motion() {
        return {.begin = [this]() -> Result<HoldMotion::Id> {
                    if (refuse) {
                        return Error{ErrorCode::NotInControl, QStringLiteral("jog"), {}};
                    }
                    ++begun;
                    running = ++next;
                    return running;
                },
                .hold =
                    [this](HoldMotion::Id id) {
                        ++holds;
                        return id == running;
                    },
                .end =
                    [this](HoldMotion::Id id, StopCause cause) {
                        if (id == running) {
                            running = 0;
                        }
                        ends.append(cause);
                    },
                .runsToEnd = [this] { return bounded; }};
    }
};

struct Scene {
    VirtualClock clock;
    FakeTarget target;
    FakeTarget otherTarget;
    HoldPolicy policy;
    QWidget window;
    HoldToRunButton* key;
    HoldToRunButton* other;
    QLineEdit* edit;
    QPushButton* button;

    Scene() {
        auto* layout = new QHBoxLayout(&window);
        layout->setContentsMargins(60, 60, 60, 60);
        key = new HoldToRunButton(QStringLiteral("X+"), policy, &window);
        other = new HoldToRunButton(QStringLiteral("Y+"), policy, &window);
        edit = new QLineEdit(&window);
        button = new QPushButton(QStringLiteral("Teach"), &window);
        for (QWidget* w : {static_cast<QWidget*>(key), static_cast<QWidget*>(other),
                           static_cast<QWidget*>(edit), static_cast<QWidget*>(button)}) {
            w->setFixedSize(80, 60);
            layout->addWidget(w);
        }
        for (auto [k, t] : {std::pair{key, &target}, std::pair{other, &otherTarget}}) {
            k->guard().setClock(clock);
            k->setMotion(t->motion());
        }
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            qFatal("the window did not become active");
        }
    }
    void press() { QTest::mousePress(key, Qt::LeftButton, {}, QPoint(40, 30)); }
    void release() { QTest::mouseRelease(key, Qt::LeftButton, {}, QPoint(40, 30)); }
    void expectStopped(StopCause cause) {
        QCOMPARE(target.ends, QList<StopCause>{cause});
        QVERIFY(!key->isHolding());
        QVERIFY(!key->isDown());
        // The motion stays stopped, regardless of the operator's actions.
        const int holds = target.holds;
        clock.advanceNs(20 * kNsPerMs);
        key->guard().pump();
        QTest::mouseMove(key, QPoint(41, 31));
        QCOMPARE(target.holds, holds);
        QCOMPARE(target.begun, 1);
        release();
        QCOMPARE(target.begun, 1);
        QCOMPARE(target.ends.size(), 1);
    }
    void expectNewPressMoves() {
        window.activateWindow();
        press();
        QCOMPARE(target.begun, 2);
        release();
    }
};

}  // namespace tiller::test
