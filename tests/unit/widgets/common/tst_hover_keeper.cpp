// SPDX-License-Identifier: GPL-3.0-or-later
//
// A button is displayed as hovered only while the pointer is over it.

#include <QApplication>
#include <QCursor>
#include <QEnterEvent>
#include <QMenu>
#include <QPointingDevice>
#include <QPushButton>
#include <QTest>
#include <memory>

#include "widgets/common/hover_keeper.h"
#include "widgets/hold/hold_to_run_button.h"

using namespace tiller;

namespace {

struct Bench {
    QWidget window;
    QPushButton key{QStringLiteral("Teach here"), &window};
    HoldPolicy policy;
    HoldToRunButton hold{QStringLiteral("Home"), policy, &window};
    HoverKeeper keeper;

    Bench() {
        window.setGeometry(0, 0, 400, 300);
        key.setGeometry(20, 20, 120, 40);
        hold.setGeometry(20, 80, 120, 40);
        QCursor::setPos(390, 290);
        window.show();
        if (!QTest::qWaitForWindowExposed(&window)) {
            qFatal("the window was not shown");
        }
    }
    /// Sends the same events as the window system.
    static void enter(QWidget& widget) {
        const QPointF at = QRectF(widget.rect()).center();
        QEnterEvent event(at, widget.mapTo(widget.window(), at), widget.mapToGlobal(at));
        QApplication::sendEvent(&widget, &event);
        QVERIFY(widget.underMouse());
    }
};

}  // namespace

class TestHoverKeeper : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aTouchLeavesNoHoverState() {
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        Bench bench;
        for (QWidget* key : {static_cast<QWidget*>(&bench.key), static_cast<QWidget*>(&bench.hold)}) {
            Bench::enter(*key);
            const QPoint at = key->rect().center();
            QTest::touchEvent(key, screen.get()).press(0, at);
            QTest::touchEvent(key, screen.get()).release(0, at);
            QTRY_VERIFY_WITH_TIMEOUT(!key->underMouse(), 60'000);
        }
    }

    void closedMenuLeavesNoHoverState() {
        Bench bench;
        QMenu menu(&bench.window);
        menu.addAction(QStringLiteral("Rename"));
        menu.popup(bench.window.mapToGlobal(QPoint(200, 100)));
        QTRY_VERIFY_WITH_TIMEOUT(menu.isVisible(), 60'000);
        bench.key.setAttribute(Qt::WA_UnderMouse);  // the state when the menu grabs the pointer
        menu.close();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.key.underMouse(), 60'000);
    }

    void widgetUnderThePointerKeepsItsHoverState() {
        Bench bench;
        QCursor::setPos(bench.key.mapToGlobal(bench.key.rect().center()));
        QCoreApplication::processEvents();
        bench.key.setAttribute(Qt::WA_UnderMouse);
        bench.hold.setAttribute(Qt::WA_UnderMouse);
        QEvent deactivated(QEvent::WindowDeactivate);
        QApplication::sendEvent(&bench.window, &deactivated);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.hold.underMouse(), 60'000);
        QVERIFY(bench.key.underMouse());
    }
};

QTEST_MAIN(TestHoverKeeper)
#include "tst_hover_keeper.moc"
