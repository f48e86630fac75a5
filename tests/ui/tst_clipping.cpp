// SPDX-License-Identifier: GPL-3.0-or-later
//
// No text is clipped in any dialog or page of the window, on the smallest screen, in both densities. The test
// is repeated at 150 and 200 %, in every language, and in a pseudo language (see CMakeLists.txt).

#include <QDialog>
#include <QDockWidget>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <optional>

#include "app/action_table.h"
#include "app/connect_dialog.h"
#include "app/language.h"
#include "resources/resources.h"
#include "robot/station/program/step_kind.h"
#include "tests/support/pseudo_translator.h"
#include "tests/support/test_pad.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/density.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/jog/device_jog.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/program/step_tree.h"
#include "widgets/project/undoable_document.h"
#include "widgets/status/header_bar.h"
#include "widgets/status/preflight_page.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr QSize kSmallest{1280, 720};
constexpr QSize kSmallestWindow{1264, 672};  // without title bar and borders

struct Bench : WindowBench {
    /// Uses the button size named by the data row: "mouse" or "touch".
    Bench() {
        show(kSmallest);
        app::Preferences preferences;
        const QByteArray row = QTest::currentDataTag();
        preferences.density = row == "touch" ? Density::Touch : Density::Mouse;
        window.applyPreferences(preferences);
    }
    /// Triggers the command and returns the dialog that it opens.
    QDialog* open(const char* id) {
        QAction* action = window.actions().find(QLatin1String(id));
        action->setEnabled(true);
        action->trigger();
        QCoreApplication::processEvents();
        for (QWidget* top : QApplication::topLevelWidgets()) {
            if (auto* dialog = qobject_cast<QDialog*>(top); dialog != nullptr && dialog->isVisible()) {
                return dialog;
            }
        }
        return nullptr;
    }
};

/// A gamepad with a long name and all sticks deflected.
std::unique_ptr<TestPad> longPad() {
    DeviceReading pushed;
    pushed.axes << 0.7, -0.7, 0.7, 0.7, -0.7, 0.7;
    return std::make_unique<TestPad>(QStringLiteral("8BitDo Ultimate Wireless Controller"),
                                     QStringLiteral("Left stick: X and Y. Right stick: Z and rotation. Hold "
                                                    "the right bumper to rotate with both sticks."),
                                     pushed);
}

void keepPicture(QWidget& widget, const QString& name) {
    const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
    if (!to.isEmpty()) {
        QVERIFY(widget.grab().save(QStringLiteral("%1/clipping-%2.png").arg(to, name)));
    }
}

}  // namespace

class TestClipping : public QObject {
    Q_OBJECT

private:
    PseudoTranslator pseudo_;
    std::optional<app::LanguageTexts> texts_;

    static QString densityName() {
        return currentDensity() == Density::Touch ? QStringLiteral("touch") : QStringLiteral("mouse");
    }
    static void look(QWidget& window, const QString& name) {
        // Layouts are updated in later iterations of the event loop after the texts have been set.
        QTest::qWait(50);
        keepPicture(window, name + '-' + densityName());
        const QStringList found = stillClipped(window);
        QVERIFY2(found.isEmpty(), qPrintable(name + ":\n" + found.join('\n')));
        QVERIFY2(window.width() <= kSmallest.width() && window.height() <= kSmallest.height() - 40,
                 qPrintable(QStringLiteral("%1 is %2 x %3: larger than the smallest screen")
                                .arg(name)
                                .arg(window.width())
                                .arg(window.height())));
    }
    static void lookAtWindow(Bench& bench, const char* what) {
        bench.cell.advanceMs(50);
        QTest::qWait(50);
        keepPicture(bench.window, QStringLiteral("window-%1-%2").arg(what, densityName()));
        bench.window.resize(kSmallestWindow);
        QTest::qWait(50);
        const auto placeOf = [&bench](const char* name) {
            const auto* dock = bench.window.findChild<QDockWidget*>(QLatin1String(name));
            return QRect(dock->mapTo(&bench.window, QPoint(0, 0)), dock->size());
        };
        const QRect tabs = placeOf("tabsDock");
        const QRect plots = placeOf("plotsDock");
        QVERIFY2(!tabs.intersects(plots) && plots.bottom() < bench.window.height(),
                 qPrintable(QStringLiteral("%1: not enough space for all").arg(QLatin1String(what))));
        bench.window.resize(kSmallest);
        QTest::qWait(50);
        const QStringList found = stillClipped(bench.window);
        QVERIFY2(found.isEmpty(), qPrintable(QLatin1String(what) + ":\n" + found.join('\n')));
    }
    static void densities() {
        QTest::addColumn<bool>("named");
        QTest::newRow("mouse") << true;
        QTest::newRow("touch") << true;
    }

private Q_SLOTS:
    void initTestCase() {
        initResources();
        // A language code, "pseudo" for texts longer than in any language, or "mirrored" for a right-to-left
        // layout.
        const QString language = qEnvironmentVariable("TILLER_LANGUAGE");
        if (language == "pseudo" || language == "mirrored") {
            QCoreApplication::installTranslator(&pseudo_);
            QGuiApplication::setLayoutDirection(language == "pseudo" ? Qt::LeftToRight : Qt::RightToLeft);
        } else if (!language.isEmpty()) {
            texts_.emplace(language);
            QCOMPARE(texts_->code(), language);
        }
    }
    void init() {
        applyTheme(*qApp, qEnvironmentVariable("TILLER_THEME") == "dark" ? Theme::dark() : Theme::light());
    }
    void cleanupTestCase() { applyDensity(*qApp, Density::Mouse); }

    void theCheckDetectsClippedText() {
        QWidget window;
        auto* label = new QLabel(QStringLiteral("A sentence that needs more room than this"), &window);
        label->setGeometry(0, 0, 60, 20);
        auto* button = new QPushButton(QStringLiteral("A key with many words"), &window);
        button->setGeometry(0, 30, 60, 40);
        auto* outside = new QLabel(QStringLiteral("x"), &window);
        outside->setGeometry(290, 80, 40, 20);
        window.resize(300, 200);
        window.show();
        QCOMPARE(clipped(window).size(), 3);
        label->setToolTip(label->text());
        button->resize(button->sizeHint());
        outside->move(200, 80);
        QVERIFY2(clipped(window).isEmpty(), qPrintable(clipped(window).join('\n')));
    }

    void noPageOfTheWindowIsCutOff_data() { densities(); }
    void noPageOfTheWindowIsCutOff() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.cell.advanceMs(300);
        bench.window.frames().teachFromTcp();
        for (const char* tab : {"waypoints", "program", "frames", "io", "log"}) {
            bench.window.showTab(tab);
            lookAtWindow(bench, tab);
        }
        // Select a step with a problem. It shows every field of a move.
        bench.window.showTab("program");
        project::ProgramList programs;
        project::ProgramStep move = program::newStep(*program::findStepKind("moveL"));
        programs.append({QUuid::createUuid(), "program", {}, {move}, {}, {}});
        bench.window.document().changePrograms(programs, "add");
        bench.find<StepTree>("program.tree").selectIds({move.id});
        bench.find<SegmentedControl>("program.side").setCurrentIndex(1);
        lookAtWindow(bench, "program-step");
        bench.window.actions().find("frame.action.touchUp")->trigger();
        lookAtWindow(bench, "frames-question");
        bench.window.actions().find("frame.action.threePoints")->trigger();
        lookAtWindow(bench, "frames-teaching");
    }

    void noDialogIsCutOff_data() { densities(); }
    void noDialogIsCutOff() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        for (const char* id : {"app.palette", "app.help", "control.load", "jog.devices", "jog.step.other",
                               "jog.speed.other", "jog.contact.other"}) {
            QDialog* dialog = bench.open(id);
            QVERIFY2(dialog != nullptr, id);
            look(*dialog, QLatin1String(id));
            dialog->close();
            QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() == nullptr, 60'000);
        }
        bench.window.devices().addSource(longPad());
        QDialog* trainer = bench.open("jog.devices");
        bench.window.devices().poll();
        QTest::qWait(100);
        look(*trainer, "trainer");
        trainer->close();
    }

    void noSettingIsCutOff_data() { densities(); }
    void noSettingIsCutOff() {
        Bench bench;
        bench.window.devices().addSource(longPad());
        QDialog* page = bench.open("app.settings");
        QVERIFY(page != nullptr);
        auto* pages = page->findChild<QTabWidget*>("settingsPages");
        for (int i = 0; i < pages->count(); ++i) {
            pages->setCurrentIndex(i);
            look(*page, QStringLiteral("settings-%1").arg(i));
        }
        pages->setCurrentIndex(0);
        auto* cap = page->findChild<QAbstractSpinBox*>("settings.speedCap");
        cap->selectAll();
        QTest::keyClicks(cap, "1000");
        QTest::keyClick(cap, Qt::Key_Return);
        look(*page, "settings-cap");
        page->close();
    }

    void noConnectionOptionIsCutOff_data() { densities(); }
    void noConnectionOptionIsCutOff() {
        Bench bench;
        QDialog* first = bench.open("robot.connect");
        look(*first, "first-run");
        first->close();
        for (int i = 0; i < 8; ++i) {
            const QString host = QStringLiteral("192.168.100.%1").arg(100 + i);
            app::Settings(bench.file)
                .rememberRobot({QStringLiteral("UR10e of the second line"), host, 0, false});
        }
        QDialog* later = bench.open("robot.connect");
        later->findChild<QLineEdit*>("robotHost")->setText(QStringLiteral("300.1"));
        look(*later, "connect");
        later->close();
        // A robot with many problems results in the longest page.
        bench.window.showPreflight({QStringLiteral("Nobody"), QStringLiteral("127.0.0.254"), 0, false});
        auto* page = bench.window.findChild<PreflightPage*>();
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 60'000);
        look(*page, "preflight");
        page->close();
    }

    // Uses a screen with a height of 720 pixels and the sizes for mouse operation.
    void theMenuOfTheWaypointsIsOneColumn() {
        if (qApp->primaryScreen()->size().height() < kSmallest.height()) {
            QSKIP("the screen of the offscreen platform is too small at this scale factor");
        }
        applyDensity(*qApp, Density::Mouse);
        WindowBench bench;
        bench.show(kSmallest);
        auto& menu = bench.find<QMenu>("waypoint.menu");
        menu.popup(QPoint(0, 0));
        keepPicture(menu, QStringLiteral("waypoint-menu"));
        for (QAction* action : menu.actions()) {
            const QRect place = menu.actionGeometry(action);
            QVERIFY2(place.left() == menu.actionGeometry(menu.actions().first()).left() &&
                         place.bottom() < kSmallest.height() - 40,
                     qPrintable(action->text()));
        }
        menu.close();
    }

    // Names and values of the joints share a row.
    void jointNamesDoNotOverlapTheValues() {
        applyDensity(*qApp, Density::Mouse);
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.resize(1920, 1040);
        bench.cell.advanceMs(100);
        auto& rows = bench.find<JointRows>("jointRows");
        rows.setJoints(JointPositions(-6.28, -6.28, -6.28, -6.28, -6.28, -6.28), false, true, false);
        QTest::qWait(150);
        keepPicture(bench.window, QStringLiteral("joint-rows"));
        for (const JointRow* row : rows.rows()) {
            QVERIFY2(row->isNameApart(), qPrintable(row->accessibleName()));
        }
    }

    // The button for the next step, in every state.
    void noNextStepIsCutOff_data() { densities(); }
    void noNextStepIsCutOff() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        auto& header = bench.find<HeaderBar>("headerBar");
        const auto& key = bench.find<QPushButton>("nextStepButton");
        SessionState running = bench.window.session().state();
        const auto like = [&running](RobotMode robot, SafetyMode safety) {
            SessionState state = running;
            state.robotMode = robot;
            state.safetyMode = safety;
            return state;
        };
        const std::pair<NextStep, SessionState> steps[] = {
            {NextStep::Connect, SessionState()},
            {NextStep::PowerOn, like(RobotMode::PowerOff, SafetyMode::Normal)},
            {NextStep::ReleaseBrakes, like(RobotMode::Idle, SafetyMode::Normal)},
            {NextStep::TakeControl, running},
            {NextStep::Recover, like(RobotMode::Running, SafetyMode::ProtectiveStop)}};
        for (const auto& [step, state] : steps) {
            header.applyState(state);
            QCOMPARE(header.shownStep(), step);
            const QString name = QStringLiteral("step-%1").arg(static_cast<int>(step));
            keepPicture(header, name + '-' + densityName());
            QVERIFY(key.isVisible());
            const QStringList found = stillClipped(bench.window);
            QVERIFY2(found.isEmpty(), qPrintable(name + ":\n" + found.join('\n')));
        }
    }

    void noRecoveryStepIsCutOff_data() { densities(); }
    void noRecoveryStepIsCutOff() {
        const std::pair<const char*, void (*)(simulator::Simulator&)> stops[] = {
            {"protective", [](simulator::Simulator& robot) { robot.protectiveStop(); }},
            {"emergency", [](simulator::Simulator& robot) { robot.emergencyStop(true); }},
            {"fault", [](simulator::Simulator& robot) { robot.fault(); }}};
        for (const auto& [name, stop] : stops) {
            Bench bench;
            QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
            bench.cell.advanceMs(200);
            stop(bench.cell.robot);
            bench.cell.advanceMs(300);
            QDialog* page = bench.open("power.recover");
            QVERIFY2(page != nullptr, name);
            bench.cell.advanceMs(100);
            look(*page, QStringLiteral("recovery-") + QLatin1String(name));
            page->close();
        }
    }
};

QTEST_MAIN(TestClipping)
#include "tst_clipping.moc"
