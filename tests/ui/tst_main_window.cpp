// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the whole window: nothing is clipped at the smallest size, every control has a name, and
// connecting and disconnecting work.

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/main_window.h"
#include "resources/resources.h"
#include "robot/simulator/simulator.h"
#include "tests/support/event_spy.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/pose_view.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestMainWindow : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    app::Settings settings() const { return app::Settings(folder_.filePath("settings.ini")); }

    /// Saves screenshots for review to the folder TILLER_SCREENSHOTS.
    static void saveScreenshots(app::MainWindow& window, const QString& name) {
        const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (folder.isEmpty()) {
            return;
        }
        for (const char* theme : {"dark", "light"}) {
            window.setTheme(QString::fromLatin1(theme));
            QCoreApplication::processEvents();
            QVERIFY(window.grab().save(QStringLiteral("%1/main-%2-%3.png").arg(folder, name, theme)));
        }
    }

private Q_SLOTS:
    // A killed process does not close its window.
    void theSizeIsSavedBeforeClosing() {
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        window.resize(1333, 777);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.resize(1340, 780);
        QTRY_COMPARE_WITH_TIMEOUT(settings().windowGeometry(), window.saveGeometry(), 60'000);
    }
    void initTestCase() { initResources(); }

    // The titles distinguish two robots in the window list of the desktop.
    void theTitleNamesTheRobot() {
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        QCOMPARE(window.windowTitle(), QStringLiteral("Tiller"));
        VirtualCell cell(clock, window.session());
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        const SessionState& state = window.session().state();
        QVERIFY2(window.windowTitle().endsWith(" — Tiller"), qPrintable(window.windowTitle()));
        QVERIFY2(window.windowTitle().contains(state.address), qPrintable(window.windowTitle()));
        QVERIFY2(window.windowTitle().contains(state.robotName), qPrintable(window.windowTitle()));
        window.session().disconnectFromRobot();
        QTRY_COMPARE_WITH_TIMEOUT(window.windowTitle(), QStringLiteral("Tiller"), 60'000);
    }

    void nothingIsCutOffAtTheSmallestSize_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x720") << QSize(1280, 720);
        QTest::newRow("1280x720 less a title bar") << QSize(1264, 672);
        QTest::newRow("1600x900") << QSize(1600, 900);
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }
    void nothingIsCutOffAtTheSmallestSize() {
        QFETCH(QSize, size);
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        VirtualCell cell(clock, window.session());
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCOMPARE(window.size(), size);
        QVERIFY2(cell.bringUp(), qPrintable(cell.what()));
        window.waypoints().teach();
        cell.advanceMs(200);
        const QList<QWidget*> widgets = window.findChildren<QWidget*>();
        int looked = 0;
        for (QWidget* widget : widgets) {
            if (!widget->isVisible() || widget->isWindow()) {
                continue;
            }
            const bool control = qobject_cast<QAbstractButton*>(widget) != nullptr;
            if (!control) {
                continue;
            }
            ++looked;
            const QRect inWindow(widget->mapTo(&window, QPoint(0, 0)), widget->size());
            QVERIFY2(window.rect().contains(inWindow),
                     qPrintable(QStringLiteral("%1 extends beyond the window").arg(widget->objectName())));
            QVERIFY2(widget->width() >= widget->minimumSizeHint().width(),
                     qPrintable(
                         QStringLiteral("%1 is narrower than its minimum width").arg(widget->objectName())));
            QVERIFY2(widget->visibleRegion().boundingRect().size() == widget->size(),
                     qPrintable(QStringLiteral("%1 \"%2\" is partly covered")
                                    .arg(widget->objectName(), widget->accessibleName())));
        }
        QVERIFY2(looked > 30, "too few controls were checked");
        // The limiter line also needs enough space. Otherwise, it would be drawn over the buttons.
        auto* limiter = window.findChild<LimiterLine*>();
        const QList<HoldToRunButton*> keys = window.findChildren<HoldToRunButton*>();
        for (const int tab : {1, 0}) {
            window.findChild<SegmentedControl*>("jogDetail")->setCurrentIndex(tab);
            cell.advanceMs(20);
            const QRect line(limiter->mapTo(&window, QPoint(0, 0)), limiter->size());
            QVERIFY(limiter->height() >= limiter->minimumSizeHint().height());
            for (const HoldToRunButton* key : keys) {
                const QRect place(key->mapTo(&window, QPoint(0, 0)), key->size());
                QVERIFY2(!key->isVisible() || !place.intersects(line), qPrintable(key->objectName()));
            }
        }
        saveScreenshots(window, QStringLiteral("%1x%2").arg(size.width()).arg(size.height()));
    }

    void theJointsAreExpandedWhenTheyFit_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("unfolded");
        QTest::newRow("1280x720") << QSize(1280, 720) << false;
        QTest::newRow("1600x900") << QSize(1600, 900) << true;
        QTest::newRow("1600x900 less a title bar") << QSize(1592, 860) << true;
        QTest::newRow("1920x1080") << QSize(1920, 1080) << true;
    }
    void theJointsAreExpandedWhenTheyFit() {
        QFETCH(QSize, size);
        QFETCH(bool, unfolded);
        app::MainWindow window(settings());
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QTRY_COMPARE_WITH_TIMEOUT(window.findChild<JointRows*>()->isVisible(), unfolded, 60'000);
        QVERIFY(window.findChild<PoseView*>()->isVisible());
        QCOMPARE(window.findChild<SegmentedControl*>("jogDetail")->isVisible(), !unfolded);
    }

    void everyButtonHasANameForScreenReaders() {
        app::MainWindow window(settings());
        QStringList nameless;
        const QList<QAbstractButton*> buttons = window.findChildren<QAbstractButton*>();
        for (const QAbstractButton* button : buttons) {
            // Internal parts of Qt's widgets have no names.
            if (button->objectName().startsWith("qt_") || button->inherits("QTableCornerButton") ||
                button->inherits("QLineEditIconButton") ||
                qobject_cast<QTabBar*>(button->parent()) != nullptr) {
                continue;
            }
            if (button->accessibleName().isEmpty() && button->text().isEmpty()) {
                nameless << button->metaObject()->className() + QStringLiteral(" ") + button->objectName();
            }
        }
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
    }

    // The keyboard has only a Russian layout, without Latin letters.
    void shortcutsFollowThePhysicalKeyPosition() {
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        VirtualCell cell(clock, window.session());
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QVERIFY2(cell.bringUp(), qPrintable(cell.what()));
        struct Letter {
            quint32 code;
            int key;
        };
        constexpr Letter kJ{44, 0x041e};
        constexpr Letter kT{28, 0x0415};
        const auto type = [](QWidget& to, const Letter& letter, Qt::KeyboardModifiers modifiers = {},
                             bool repeat = false) {
            const QString text = modifiers == Qt::NoModifier ? QString(QChar(letter.key)) : QString();
            QKeyEvent press(QEvent::KeyPress, letter.key, modifiers, letter.code, 0, 0, text, repeat);
            QApplication::sendEvent(&to, &press);
        };
        window.setFocus();
        type(window, kJ, Qt::ControlModifier);
        QVERIFY2(window.findChild<QWidget*>("armedFrame") != nullptr, "Ctrl+J did not arm the keyboard");
        type(window, kJ, Qt::ControlModifier, true);
        QVERIFY2(window.findChild<QWidget*>("armedFrame") != nullptr, "a key repeat disarmed the keyboard");
        type(window, kJ, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY2(window.findChild<QWidget*>("armedFrame") != nullptr,
                 "another shortcut disarmed the keyboard");
        type(window, kJ, Qt::ControlModifier);
        QVERIFY2(window.findChild<QWidget*>("armedFrame") == nullptr,
                 "the second Ctrl+J did not disarm the keyboard");

        auto* table = window.waypoints().findChild<QTableView*>();
        QVERIFY(table != nullptr);
        const int taught = table->model()->rowCount();
        type(window, kT);
        QCOMPARE(table->model()->rowCount(), taught + 1);
        QLineEdit field(&window);
        field.show();
        field.setFocus();
        type(field, kT);
        QCOMPARE(table->model()->rowCount(), taught + 1);
        QCOMPARE(field.text(), QString(QChar(kT.key)));
    }

    void stopIsAlwaysVisibleAndLargeEnough() {
        app::MainWindow window(settings());
        window.resize(1280, 720);
        window.show();
        auto* stop = window.findChild<QAbstractButton*>("stopButton");
        QVERIFY(stop != nullptr);
        QVERIFY(stop->isVisible() && stop->isEnabled());
        QVERIFY(stop->toolTip().contains("Not an emergency stop"));
    }

    void connectionIsRestoredButMotionDoesNotResume() {
        VirtualClock clock;
        app::MainWindow window(settings(), clock);
        window.show();
        VirtualCell cell(clock, window.session());
        QVERIFY2(cell.bringUp(), qPrintable(cell.what()));
        driveKeys(cell, window.jogColumn().holdKeys());
        auto* key = window.findChild<HoldToRunButton*>("jog.X+");
        QVERIFY(key != nullptr);
        press(*key);
        cell.advanceMs(200);
        QVERIFY(!standsStill(cell));

        cell.robot.closeClients();
        QElapsedTimer waited;
        waited.start();
        while (window.session().state().control == ControlState::InControl && waited.elapsed() < 20'000) {
            cell.clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
            window.session().refresh();
            QTest::qWait(1);
        }
        QVERIFY(window.session().state().control != ControlState::InControl);
        while (window.session().state().link != LinkState::Live && waited.elapsed() < 30'000) {
            cell.clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
            window.session().refresh();
            QTest::qWait(1);
        }
        QCOMPARE(window.session().state().link, LinkState::Live);
        // Data may resume within the 250 ms that the contract allows for a lost connection.
        cell.advanceMs(250);
        QVERIFY(standsStill(cell));
        QVERIFY2(!window.session().state().canMove(), "control was taken again automatically");
        const Pose at = cell.truth().tcpPose;
        cell.advanceMs(500);
        QVERIFY(distanceMm(at, cell.truth().tcpPose) < 0.05);
    }

    void unreachableAddressSuggestsASolution() {
        app::MainWindow window(settings());
        QStringList errors;
        const test::Listening listening =
            test::onMessage(window.session().journal(), &window, [&](Severity severity, const QString& text) {
                if (severity == Severity::Error) {
                    errors << text;
                }
            });
        window.connectRobot({"Nobody", "127.0.0.254", 0, false});
        QTRY_VERIFY_WITH_TIMEOUT(!errors.isEmpty(), 20'000);
        QVERIFY2(errors.first().contains("127.0.0.254"), qPrintable(errors.first()));
        QVERIFY2(errors.first().contains("Services"), qPrintable(errors.first()));
    }
};

QTEST_MAIN(TestMainWindow)
#include "tst_main_window.moc"
