// SPDX-License-Identifier: GPL-3.0-or-later
// The stop rules for events outside the button: focus, windows, dialogs, the application.
#include <QDialog>
#include <QMenu>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabWidget>
#include <QWheelEvent>
#include <memory>

#include "tests/unit/widgets/hold/hold_scene.h"

using namespace tiller;
using namespace tiller::test;

class TestHoldWindow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void focusToAnotherWidgetStops() {
        Scene s;
        s.press();
        s.edit->setFocus();
        s.expectStopped(StopCause::FocusLost);
        s.expectNewPressMoves();
    }

    void tabKeyStops() {
        Scene s;
        s.press();
        QTest::keyClick(s.key, Qt::Key_Tab);
        s.expectStopped(StopCause::FocusLost);
    }

    void anotherWindowStops() {
        Scene s;
        s.press();
        QWidget second;
        second.show();
        second.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&second));
        s.expectStopped(StopCause::DialogOpened);  // showing the dialog is sufficient
    }

    void deactivatedWindowStops() {
        QWidget second;
        second.show();
        Scene s;
        s.press();
        second.activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(!s.target.ends.isEmpty(), 60'000);
        s.expectStopped(StopCause::WindowDeactivated);
    }

    void minimisedWindowStops() {
        Scene s;
        s.press();
        s.window.showMinimized();
        QTRY_VERIFY_WITH_TIMEOUT(!s.target.ends.isEmpty(), 60'000);
        s.expectStopped(StopCause::WindowDeactivated);
    }

    void hiddenWindowStops() {
        Scene s;
        s.press();
        s.window.hide();
        s.expectStopped(StopCause::WindowClosed);
    }

    void closedWindowStops() {
        Scene s;
        s.press();
        s.window.close();
        s.expectStopped(StopCause::WindowClosed);
    }

    void destroyedKeyStops() {
        Scene s;
        s.press();
        delete s.key;
        QCOMPARE(s.target.ends.size(), 1);
        QCOMPARE(s.target.running, 0U);
    }

    void anotherTabStops() {
        VirtualClock clock;
        FakeTarget target;
        HoldPolicy policy;
        QTabWidget tabs;
        auto* key = new HoldToRunButton(QStringLiteral("X+"), policy);
        key->guard().setClock(clock);
        key->setMotion(target.motion());
        tabs.addTab(key, QStringLiteral("one"));
        tabs.addTab(new QWidget, QStringLiteral("two"));
        tabs.show();
        QVERIFY(QTest::qWaitForWindowActive(&tabs));
        QTest::mousePress(key, Qt::LeftButton);
        QCOMPARE(target.begun, 1);
        tabs.setCurrentIndex(1);
        QCOMPARE(target.ends.size(), 1);
        QVERIFY(!key->isHolding());
    }

    void hiddenKeyStops() {
        Scene s;
        s.press();
        s.key->hide();
        s.expectStopped(StopCause::SelectionChanged);
    }

    void modalDialogStops() {
        Scene s;
        s.press();
        QDialog dialog(&s.window);
        dialog.setModal(true);
        dialog.show();
        s.expectStopped(StopCause::DialogOpened);
    }

    void modelessDialogStops() {
        Scene s;
        s.press();
        QDialog dialog(&s.window);
        dialog.show();
        s.expectStopped(StopCause::DialogOpened);
    }

    void menuStops() {
        Scene s;
        s.press();
        QMenu menu;
        menu.addAction(QStringLiteral("one"));
        menu.popup(s.window.mapToGlobal(QPoint(0, 0)));
        s.expectStopped(StopCause::DialogOpened);
    }

    void tooltipDoesNotStop() {
        Scene s;
        s.press();
        QWidget tip(&s.window, Qt::ToolTip);
        tip.show();
        QVERIFY(s.key->isHolding());
        s.release();
        s.expectStopped(StopCause::Released);
    }

    void inactiveApplicationStops() {
        Scene s;
        s.press();
        Q_EMIT qApp->applicationStateChanged(Qt::ApplicationInactive);
        s.expectStopped(StopCause::WindowDeactivated);
    }

    void pressInAnInactiveWindowMovesNothing() {
        Scene s;
        QWidget other;
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other));
        QSignalSpy refused(&s.key->guard(), &HoldGuard::refused);
        s.press();
        QCOMPARE(s.target.begun, 0);
        QCOMPARE(refused.count(), 1);
        s.release();
        // The window is active again. The earlier press has ended, and a new press starts a motion.
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QCOMPARE(s.target.begun, 0);
        s.press();
        QCOMPARE(s.target.begun, 1);
        s.release();
    }
};

QTEST_MAIN(TestHoldWindow)
#include "tst_hold_window.moc"
