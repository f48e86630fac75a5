// SPDX-License-Identifier: GPL-3.0-or-later
//
// A window that is not visible must not paint.

#include <QTemporaryDir>
#include <QTest>

#include "app/main_window.h"
#include "resources/resources.h"
#include "tests/ui/jog_fixture.h"

using namespace tiller;
using namespace tiller::test;

namespace {

class PaintWatch : public QObject {
public:
    PaintWatch() { qApp->installEventFilter(this); }
    int count = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
};

}  // namespace

class TestWindowAtRest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    app::Settings settings() const { return app::Settings(folder_.filePath("settings.ini")); }

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void nothingIsPaintedWhileMinimised() {
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        VirtualCell cell(clock, window.session());
        window.resize(1920, 1080);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY2(cell.bringUp(), qPrintable(cell.what()));
        window.showMinimized();
        QTRY_VERIFY_WITH_TIMEOUT(window.isMinimized(), 60'000);
        QCoreApplication::processEvents();
        PaintWatch paints;
        const std::uint64_t before = window.session().state().sequence;
        window.session().journal().add(Severity::Warning, QStringLiteral("read later"));
        cell.advanceMs(3000);
        QVERIFY(window.session().state().sequence > before + 1000);
        QCOMPARE(paints.count, 0);

        window.showNormal();
        QTRY_VERIFY_WITH_TIMEOUT(paints.count > 0, 60'000);
    }

    // Content in a hidden tab or in a folded part is not painted either.
    void nothingIsPaintedWhileHidden() {
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        VirtualCell cell(clock, window.session());
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY2(cell.bringUp(), qPrintable(cell.what()));
        window.hide();
        PaintWatch paints;
        cell.advanceMs(1000);
        QCOMPARE(paints.count, 0);
        window.show();
        QTRY_VERIFY_WITH_TIMEOUT(paints.count > 0, 60'000);
    }
};

QTEST_MAIN(TestWindowAtRest)
#include "tst_window_at_rest.moc"
