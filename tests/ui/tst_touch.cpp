// SPDX-License-Identifier: GPL-3.0-or-later
//
// With Touch density, all touch targets have the height needed by a finger: joint buttons, rows of the I/O
// tab, tabs, check boxes, fields and menus. The mouse densities are not changed.

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>

#include "app/action_table.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/density.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/io/io_channel.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kFinger = 48;
constexpr QSize kRoomy{1920, 1080};

struct Bench : WindowBench {
    explicit Bench(QSize size, Density density = Density::Touch) {
        show(size);
        app::Preferences preferences;
        preferences.density = density;
        window.applyPreferences(preferences);
        QTest::qWait(50);
    }
};

/// True for a widget inside a table row. The height of the row (44 px) limits the widget, so it is not
/// checked.
bool isInTableRow(const QWidget& widget) {
    for (const QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
        if (up->inherits("QAbstractItemView")) {
            return true;
        }
    }
    return false;
}

bool isTouched(const QWidget& widget) {
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QTabBar*>(&widget) != nullptr;
}

/// Returns the visible widgets that are too low for a finger.
QStringList tooLow(const QWidget& window) {
    QStringList found;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!isTouched(*widget) || !widget->isVisible() || widget->window() != &window ||
            clipping::isInner(*widget) || isInTableRow(*widget)) {
            continue;
        }
        if (widget->height() < kFinger) {
            found << QStringLiteral("%1: %2 px").arg(clipping::nameOf(*widget)).arg(widget->height());
        }
    }
    return found;
}

}  // namespace

class TestTouch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        applyTheme(*qApp, Theme::light());
        applyDensity(*qApp, Density::Mouse);
    }
    void cleanupTestCase() {
        applyDensity(*qApp, Density::Mouse);
        setRoomForTouch(*qApp, true);
    }

    void everyControlInTheWindowIsLargeEnoughForTouch_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("joints below each other") << QSize(1920, 1160);
        QTest::newRow("joints in pairs") << QSize(1920, 1000);
        QTest::newRow("joints in a tab") << QSize(1600, 985);
    }
    void everyControlInTheWindowIsLargeEnoughForTouch() {
        QFETCH(QSize, size);
        Bench bench(size);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.cell.advanceMs(300);
        bench.window.frames().teachFromTcp();
        auto& detail = bench.find<SegmentedControl>("jogDetail");
        for (int shown = 0; shown < 2; ++shown) {
            detail.setCurrentIndex(shown);
            for (const char* tab : {"waypoints", "frames", "io", "log"}) {
                bench.window.showTab(tab);
                bench.cell.advanceMs(50);
                QTest::qWait(50);
                QTRY_VERIFY2_WITH_TIMEOUT(
                    tooLow(bench.window).isEmpty(),
                    qPrintable(QLatin1String(tab) + ":\n" + tooLow(bench.window).join('\n')), 60'000);
                const QStringList found = stillClipped(bench.window);
                QVERIFY2(found.isEmpty(), qPrintable(QLatin1String(tab) + ":\n" + found.join('\n')));
            }
        }
    }

    void everyJointHasTouchSizedKeys() {
        Bench bench(kRoomy);
        for (int joint = 0; joint < 6; ++joint) {
            for (const char* key : {"minus", "plus"}) {
                const auto& button = bench.find<QAbstractButton>(
                    QStringLiteral("joint.%1.%2").arg(joint).arg(QLatin1String(key)).toLatin1().constData());
                QVERIFY2(button.height() >= kFinger && button.width() >= 36,
                         qPrintable(QStringLiteral("%1: %2 x %3")
                                        .arg(button.objectName())
                                        .arg(button.width())
                                        .arg(button.height())));
                QVERIFY(button.parentWidget()->rect().contains(button.geometry()));
            }
        }
    }

    void ioRowsAreTouchSizedInEveryWindowSize_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("large") << kRoomy;
        QTest::newRow("smallest") << QSize(1280, 720);
    }
    void ioRowsAreTouchSizedInEveryWindowSize() {
        QFETCH(QSize, size);
        Bench bench(size);
        bench.window.showTab("io");
        QTest::qWait(50);
        for (const IoChannel* row : bench.window.findChildren<IoChannel*>()) {
            QVERIFY2(row->height() >= kFinger, qPrintable(row->objectName()));
        }
        for (const char* name : {"io.AO0.set", "io.register.write"}) {
            QVERIFY2(bench.find<QAbstractButton>(name).height() >= kFinger, name);
        }
    }

    void menuEntriesAreTouchSized() {
        Bench bench(QSize(1280, 720));
        for (const char* name : {"mainMenu", "waypoint.menu", "plots.span.menu"}) {
            auto& menu = bench.find<QMenu>(name);
            menu.popup(QPoint(0, 0));
            for (const QAction* action : menu.actions()) {
                if (action->isVisible() && !action->isSeparator()) {
                    QVERIFY2(menu.actionGeometry(const_cast<QAction*>(action)).height() >= kFinger,
                             qPrintable(action->text()));
                }
            }
            menu.close();
        }
    }

    void settingsControlsAreTouchSized() {
        Bench bench(kRoomy);
        QTest::keyClick(&bench.window, Qt::Key_Comma, Qt::ControlModifier);
        auto* page = bench.window.findChild<app::SettingsPage*>();
        QVERIFY(page != nullptr);
        auto* pages = page->findChild<QTabWidget*>("settingsPages");
        for (int i = 0; i < pages->count(); ++i) {
            pages->setCurrentIndex(i);
            QTest::qWait(50);
            QTRY_VERIFY2_WITH_TIMEOUT(tooLow(*page).isEmpty(), qPrintable(tooLow(*page).join('\n')), 60'000);
        }
        const QList<QCheckBox*> boxes = page->findChildren<QCheckBox*>();
        QVERIFY(!boxes.isEmpty());
        for (const QCheckBox* box : boxes) {
            QVERIFY2(box->sizeHint().height() >= kFinger, qPrintable(box->objectName()));
        }
    }

    void paletteCommandsAreTouchSized() {
        Bench bench(QSize(1280, 720));
        QTest::keyClick(&bench.window, Qt::Key_K, Qt::ControlModifier);
        auto* list = bench.window.findChild<QListWidget*>("paletteList");
        QVERIFY(list != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(list->visualItemRect(list->item(0)).height() >= kFinger, 60'000);
    }

    void aLowerWindowCutsNothingOff() {
        Bench bench(kRoomy);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QCOMPARE(touchHeight(), kFinger);
        bench.window.resize(1280, 720);
        QTRY_COMPARE_WITH_TIMEOUT(touchHeight(), 0, 60'000);
        const QStringList found = stillClipped(bench.window);
        QVERIFY2(
            found.isEmpty(),
            qPrintable(found.join('\n') + QDebug::toString(bench.find<QWidget>("stage").minimumSizeHint()) +
                       QDebug::toString(bench.find<QWidget>("stage").geometry()) +
                       QDebug::toString(bench.find<QWidget>("viewDock").minimumSizeHint()) +
                       QDebug::toString(bench.find<QWidget>("tabsDock").minimumSizeHint()) +
                       QDebug::toString(bench.find<QWidget>("plotsDock").minimumSizeHint())));
        bench.window.resize(kRoomy);
        QTRY_COMPARE_WITH_TIMEOUT(touchHeight(), kFinger, 60'000);
        QTRY_VERIFY2_WITH_TIMEOUT(tooLow(bench.window).isEmpty(), qPrintable(tooLow(bench.window).join('\n')),
                                  60'000);
    }

    void aJointIsJoggedByItsLargeKey() {
        Bench bench(kRoomy);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        auto* key = bench.window.findChild<HoldToRunButton*>("joint.0.plus");
        QVERIFY(key != nullptr);
        const double before = bench.cell.truth().q[0];
        press(*key);
        bench.cell.advanceMs(500);
        release(*key);
        bench.cell.advanceMs(300);
        QVERIFY2(bench.cell.truth().q[0] > before + 0.005,
                 qPrintable(QString::number(bench.cell.truth().q[0] - before)));
        QVERIFY(standsStill(bench.cell));
    }

    void mouseDensityKeepsItsSizes() {
        Bench bench(kRoomy, Density::Mouse);
        QCOMPARE(touchHeight(), 0);
        QCOMPARE(bench.find<QAbstractButton>("joint.0.plus").height(), 26);
        QCOMPARE(bench.find<IoChannel>("io.DO0").sizeHint().height(), 30);
        QVERIFY(bench.find<QAbstractButton>("plots.pause").height() < 30);
    }
};

QTEST_MAIN(TestTouch)
#include "tst_touch.moc"
