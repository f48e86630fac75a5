// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels are moved, closed, floated, saved by name, and restored after a restart. In all perspectives, the
// stop controls keep their positions. Hold-to-run motions end when the arrangement changes.

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <memory>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "app/dock_stage.h"
#include "app/panel_dock.h"
#include "app/perspectives.h"
#include "resources/resources.h"
#include "tests/support/event_spy.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/density.h"
#include "widgets/common/theme.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;
using app::LastArrangement;
using app::PanelDock;

namespace {

constexpr int kReleaseToStandstillMs = 100;

PanelDock& dockOf(app::MainWindow& window, const char* name) {
    auto* dock = window.findChild<PanelDock*>(QString::fromLatin1(name));
    if (dock == nullptr) {
        qFatal("there is no %s", name);
    }
    return *dock;
}

void run(app::MainWindow& window, const char* id) {
    QAction* action = window.actions().find(QString::fromLatin1(id));
    if (action == nullptr) {
        qFatal("there is no command %s", id);
    }
    action->trigger();
    // Panels are floated and docked in the next iteration of the event loop.
    QCoreApplication::processEvents();
}

/// Position of a dock in the window.
QRect placeOf(app::MainWindow& window, const char* name) {
    const PanelDock& dock = dockOf(window, name);
    return {dock.mapTo(&window, QPoint(0, 0)), dock.size()};
}

bool standsAsInTeach(app::MainWindow& window) {
    for (const char* name : {"viewDock", "tabsDock", "plotsDock"}) {
        if (!dockOf(window, name).isVisible() || dockOf(window, name).isFloating()) {
            return false;
        }
    }
    const QRect view = placeOf(window, "viewDock");
    const QRect tabs = placeOf(window, "tabsDock");
    const QRect plots = placeOf(window, "plotsDock");
    return view.right() < tabs.left() && view.bottom() < plots.top() && tabs.bottom() < plots.top();
}

/// Selects the perspective with its shortcut. Activates the window first, as a window manager would.
void chooseTeach(app::MainWindow& window) {
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, Qt::Key_F6, Qt::ShiftModifier);
}

/// Checks the parts of the window that move and stop the arm. Returns the missing parts.
QStringList missing(app::MainWindow& window) {
    QStringList problems;
    const auto look = [&](const QWidget* widget, const QString& what) {
        const QRect place =
            widget == nullptr ? QRect() : QRect(widget->mapTo(&window, QPoint(0, 0)), widget->size());
        const bool covered = qobject_cast<const QAbstractButton*>(widget) != nullptr &&
                             widget->visibleRegion().boundingRect().size() != widget->size();
        if (widget == nullptr || !widget->isVisible() || !window.rect().contains(place) || covered) {
            problems << what;
        }
    };
    look(window.findChild<QWidget*>("stopButton"), QStringLiteral("STOP"));
    look(window.findChild<LimiterLine*>(), QStringLiteral("the limiter line"));
    look(&window.jogColumn(), QStringLiteral("the jog column"));
    look(window.findChild<QWidget*>("statusLine"), QStringLiteral("the status line"));
    const QVector<HoldToRunButton*> keys = window.jogColumn().holdKeys();
    for (const HoldToRunButton* key : keys) {
        if (key->isVisible()) {
            look(key, key->objectName());
        }
    }
    const auto* stop = window.findChild<QAbstractButton*>("stopButton");
    if (stop != nullptr && !stop->isEnabled()) {
        problems << QStringLiteral("STOP is greyed");
    }
    return problems;
}

/// Creates a settings file with a changed layout in which the plots float and the view is closed.
void leaveChanged(const QString& file) {
    VirtualClock clock;
    app::MainWindow window(app::Settings(file), clock);
    window.resize(1280, 720);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    run(window, "view.float.plotsDock");
    run(window, "view.toggle.viewDock");
    QCoreApplication::processEvents();
    window.close();
}

}  // namespace

class TestPerspectives : public QObject {
    Q_OBJECT

private:
    /// Enters a name in the dialog.
    static void answer(WindowBench& bench, const QString& name) {
        auto* dialog = bench.window.findChild<QDialog*>("perspectiveDialog");
        QVERIFY(dialog != nullptr && dialog->isVisible());
        auto* field = dialog->findChild<QLineEdit*>("perspectiveName");
        field->selectAll();
        QTest::keyClicks(field, name);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QDialog*>("perspectiveDialog") == nullptr, 60'000);
    }
    static QString shown(const WindowBench& bench) {
        return bench.window.findChild<QToolButton*>("perspectiveKey")->text();
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() { applyTheme(*qApp, Theme::light()); }
    void cleanup() { applyDensity(*qApp, Density::Mouse); }

    void everyPerspectiveShowsTheStopButtonsWithoutTruncation_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("touch");
        for (const auto& [name, key] :
             {std::pair{"teach", Qt::Key_F6}, {"monitor", Qt::Key_F7}, {"plots", Qt::Key_F8}}) {
            for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
                for (const bool touch : {false, true}) {
                    QTest::addRow("%s-%d-%s", name, size.width(), touch ? "touch" : "mouse")
                        << int(key) << size << touch;
                }
            }
        }
    }
    void everyPerspectiveShowsTheStopButtonsWithoutTruncation() {
        QFETCH(int, key);
        QFETCH(QSize, size);
        QFETCH(bool, touch);
        WindowBench bench;
        bench.show(size);
        app::Preferences preferences;
        preferences.density = touch ? Density::Touch : Density::Mouse;
        bench.window.applyPreferences(preferences);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        QTest::keyClick(&bench.window, Qt::Key(key), Qt::ShiftModifier);
        bench.cell.advanceMs(100);
        QTest::qWait(50);
        keepPicture(bench.window, QStringLiteral("perspective-") + QTest::currentDataTag());
        QCOMPARE(bench.window.size(), size);
        QVERIFY2(missing(bench.window).isEmpty(), qPrintable(missing(bench.window).join(", ")));
        const auto& area = bench.find<QScrollArea>("stageArea");
        QTRY_VERIFY_WITH_TIMEOUT(
            !area.horizontalScrollBar()->isVisible() && !area.verticalScrollBar()->isVisible(), 60'000);
        const QStringList found = stillClipped(bench.window);
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
    }

    void aPerspectiveIsSelectedByKeyPaletteAndMenu() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(bench.window), 60'000);
        QVERIFY(shown(bench).startsWith("Teach"));
        QTest::keyClick(&bench.window, Qt::Key_F7, Qt::ShiftModifier);
        QVERIFY(shown(bench).startsWith("Monitor"));
        auto& tabs = bench.find<QTabBar>("tabs");
        QCOMPARE(tabs.tabData(tabs.currentIndex()).toString(), QStringLiteral("io"));
        QTRY_VERIFY2_WITH_TIMEOUT(
            placeOf(bench.window, "tabsDock").right() < placeOf(bench.window, "viewDock").left(),
            "inputs and outputs are not on the left", 60'000);

        QTest::keyClick(&bench.window, Qt::Key_K, Qt::ControlModifier);
        auto* palette = bench.window.findChild<app::CommandPalette*>();
        QVERIFY(palette != nullptr);
        QTest::keyClicks(palette->findChild<QLineEdit*>("paletteWords"), "Perspective Plots");
        QVERIFY(!palette->listed().isEmpty());
        QCOMPARE(palette->listed().first()->objectName(), QString("perspective.plots"));
        QTest::keyClick(palette->findChild<QLineEdit*>("paletteWords"), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!dockOf(bench.window, "viewDock").isVisible(), 60'000);
        QVERIFY(!dockOf(bench.window, "tabsDock").isVisible());
        QVERIFY(dockOf(bench.window, "plotsDock").isVisible());
        QVERIFY(shown(bench).startsWith("Plots"));

        QMenu* menu = bench.find<QToolButton>("perspectiveKey").menu();
        QVERIFY(menu != nullptr);
        QAction* teach = bench.window.actions().find("perspective.teach");
        QVERIFY(menu->actions().contains(teach));
        QVERIFY(bench.window.actions().find("perspective.plots")->isChecked());
        teach->trigger();
        QVERIFY(teach->isChecked() && !bench.window.actions().find("perspective.plots")->isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(bench.window), 60'000);
        // After the window is resized, the proportions remain.
        bench.window.resize(1920, 1080);
        constexpr int kWanted = 1080 * 36 / 100;
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(placeOf(bench.window, "plotsDock").height() - kWanted) <= 12,
                                 60'000);
    }

    void savedPerspectiveIsRestoredAfterARestart() {
        auto bench = std::make_unique<WindowBench>();
        bench->show(QSize(1280, 720));
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        QVERIFY(!bench->window.actions().find("perspective.save")->isEnabled());
        QVERIFY(!bench->window.actions().find("perspective.delete")->isEnabled());
        run(bench->window, "panel.plotsDock.top");
        bench->window.showTab("log");
        QTRY_VERIFY_WITH_TIMEOUT(
            placeOf(bench->window, "plotsDock").bottom() < placeOf(bench->window, "viewDock").top(), 60'000);
        run(bench->window, "perspective.saveAs");
        answer(*bench, "Inspection");
        QVERIFY(shown(*bench).startsWith("Inspection"));

        chooseTeach(bench->window);
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(bench->window), 60'000);
        run(bench->window, "perspective.saved.1");
        QTRY_VERIFY_WITH_TIMEOUT(
            placeOf(bench->window, "plotsDock").bottom() < placeOf(bench->window, "viewDock").top(), 60'000);
        auto& tabs = bench->find<QTabBar>("tabs");
        QCOMPARE(tabs.tabData(tabs.currentIndex()).toString(), QStringLiteral("log"));
        bench->window.close();
        QVERIFY(QFile::copy(bench->file, file));
        bench.reset();

        VirtualClock clock;
        app::MainWindow next(app::Settings(file), clock);
        next.resize(1280, 720);
        next.show();
        QVERIFY(QTest::qWaitForWindowExposed(&next));
        QCOMPARE(next.perspectives().current().name, QStringLiteral("Inspection"));
        QTRY_VERIFY_WITH_TIMEOUT(placeOf(next, "plotsDock").bottom() < placeOf(next, "viewDock").top(),
                                 60'000);
        QVERIFY(missing(next).isEmpty());
    }

    void namesAreCheckedRenamedAndDeleted() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        run(bench.window, "perspective.saveAs");
        auto* dialog = bench.window.findChild<QDialog*>("perspectiveDialog");
        QVERIFY(dialog != nullptr);
        auto* field = dialog->findChild<QLineEdit*>("perspectiveName");
        auto* save = dialog->findChild<QPushButton*>("perspectiveSave");
        const auto* hint = dialog->findChild<QLabel*>("perspectiveHint");
        for (const char* wrong :
             {"", "   ", "teach", "Plots", "A name that is a good deal longer than forty"}) {
            field->selectAll();
            field->del();
            QTest::keyClicks(field, wrong);
            QVERIFY2(!save->isEnabled() && !hint->text().isEmpty(), wrong);
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY2(dialog->isVisible(), wrong);
        }
        QVERIFY2(clipped(*dialog).isEmpty(), qPrintable(clipped(*dialog).join('\n')));
        keepPicture(*dialog, "perspective-name");
        answer(bench, "Cell 7");
        QCOMPARE(bench.window.perspectives().current().name, QStringLiteral("Cell 7"));

        bench.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        run(bench.window, "perspective.rename");
        answer(bench, "Cell 8");
        QCOMPARE(bench.window.perspectives().current().name, QStringLiteral("Cell 8"));
        QCOMPARE(bench.window.actions().find("perspective.saved.1")->text(),
                 QStringLiteral("Perspective Cell 8"));
        QCOMPARE(app::Settings(bench.file).perspectives().size(), 1);

        run(bench.window, "perspective.delete");
        auto* question = bench.window.findChild<QMessageBox*>("perspectiveDelete");
        QVERIFY(question != nullptr);
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QMessageBox*>("perspectiveDelete") == nullptr,
                                 60'000);
        QCOMPARE(app::Settings(bench.file).perspectives().size(), 1);
        run(bench.window, "perspective.delete");
        question = bench.window.findChild<QMessageBox*>("perspectiveDelete");
        QTest::mouseClick(question->findChild<QPushButton*>("perspectiveDeleteYes"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QMessageBox*>("perspectiveDelete") == nullptr,
                                 60'000);
        QVERIFY(app::Settings(bench.file).perspectives().isEmpty());
        QVERIFY(bench.window.actions().find("perspective.saved.1") == nullptr);
        QVERIFY(bench.window.perspectives().current().builtIn);
        QVERIFY(!bench.window.actions().find("perspective.rename")->isEnabled());
    }

    void savedPerspectiveKeepsItsKey() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        bench.window.perspectives().saveAs("Mine");
        app::Preferences preferences;
        preferences.shortcuts["perspective.saved.1"] = QKeySequence(Qt::Key_F12);
        bench.window.applyPreferences(preferences);
        bench.window.perspectives().rename("saved.1", "Ours");
        chooseTeach(bench.window);
        QCOMPARE(bench.window.perspectives().current().id, QStringLiteral("teach"));
        QTest::keyClick(&bench.window, Qt::Key_F12);
        QCOMPARE(bench.window.perspectives().current().name, QStringLiteral("Ours"));
    }

    void noTwoCommandsShareTheirKeys() {
        WindowBench bench;
        for (const QAction* one : bench.window.actions().all()) {
            for (const QAction* other : bench.window.actions().all()) {
                const bool perspective = one->objectName().startsWith("perspective.");
                QVERIFY2(!perspective || one == other || one->shortcut().isEmpty() ||
                             one->shortcut() != other->shortcut(),
                         qPrintable(one->objectName() + " and " + other->objectName()));
            }
        }
    }

    void changedLayoutSurvivesARestartAndCanBeReset() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        leaveChanged(file);
        QCOMPARE(app::Settings(file).arrangement().found, LastArrangement::Found::Usable);
        VirtualClock clock;
        app::MainWindow window(app::Settings(file), clock);
        window.resize(1280, 720);
        QVERIFY2(!dockOf(window, "plotsDock").isVisible(), "the panel is shown before the window");
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(dockOf(window, "plotsDock").isFloating() && dockOf(window, "plotsDock").isVisible());
        QVERIFY(!dockOf(window, "viewDock").isVisible());
        QVERIFY(window.perspectives().isChanged());
        QVERIFY2(missing(window).isEmpty(), qPrintable(missing(window).join(", ")));
        run(window, "view.reset");
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(window), 60'000);
        window.close();
        for (const char* name : {"viewDock", "tabsDock", "plotsDock"}) {
            QVERIFY2(!dockOf(window, name).isVisible(), name);
        }
    }

    void aDamagedLayoutFallsBackToTeach_data() {
        QTest::addColumn<QString>("how");
        for (const char* how : {"bit", "cut", "words", "empty", "older"}) {
            QTest::newRow(how) << QString::fromLatin1(how);
        }
    }
    void aDamagedLayoutFallsBackToTeach() {
        QFETCH(QString, how);
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        leaveChanged(file);
        {
            QSettings settings(file, QSettings::IniFormat);
            QByteArray panels = settings.value("arrangement/panels").toByteArray();
            QVERIFY(panels.size() > 40);
            panels[panels.size() / 2] = static_cast<char>(panels[panels.size() / 2] ^ 0x10);
            settings.setValue("arrangement/panels", how == "bit"     ? panels
                                                    : how == "cut"   ? panels.left(30)
                                                    : how == "words" ? QByteArray("as it was")
                                                                     : QByteArray());
            if (how == "older") {
                settings.remove("arrangement");
                settings.setValue("window/state", QByteArray("of an earlier version"));
                settings.setValue("window/version", 1);
            }
        }
        VirtualClock clock;
        app::MainWindow window(app::Settings(file), clock);
        QStringList warnings;
        const test::Listening listening =
            test::onMessage(window.session().journal(), &window, [&](Severity severity, const QString& text) {
                if (severity == Severity::Warning) {
                    warnings << text;
                }
            });
        window.resize(1280, 720);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(window), 60'000);
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings.first().contains("Teach"), qPrintable(warnings.first()));
        QVERIFY(missing(window).isEmpty());
        // The damage is reported only once, because layouts saved from now on are valid.
        window.close();
        QCOMPARE(app::Settings(file).arrangement().found, LastArrangement::Found::Usable);
    }

    void everyFlippedBitOfALayoutIsDetected() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        leaveChanged(file);
        QByteArray panels;
        {
            const QSettings settings(file, QSettings::IniFormat);
            panels = settings.value("arrangement/panels").toByteArray();
        }
        for (qsizetype i = 0; i < panels.size(); ++i) {
            QByteArray damaged = panels;
            damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
            QSettings(file, QSettings::IniFormat).setValue("arrangement/panels", damaged);
            QCOMPARE(app::readArrangement(app::SettingsView(file)).found, LastArrangement::Found::Damaged);
        }
    }

    void aDamagedPerspectiveIsRefusedWithItsName() {
        WindowBench bench;
        app::SavedPerspective saved;
        saved.number = 1;
        saved.name = "Broken";
        saved.panels = "whatever";
        app::Settings(bench.file).setPerspectives({saved});
        QSettings(bench.file, QSettings::IniFormat)
            .setValue("perspectives/1/panels", QByteArray("no layout"));
        VirtualClock clock;
        app::MainWindow window(app::Settings(bench.file), clock);
        QStringList warnings;
        const test::Listening listening =
            test::onMessage(window.session().journal(), &window, [&](Severity severity, const QString& text) {
                if (severity == Severity::Warning) {
                    warnings << text;
                }
            });
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        run(window, "perspective.saved.1");
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings.first().contains("Broken"), qPrintable(warnings.first()));
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(window), 60'000);
        QCOMPARE(window.perspectives().current().id, QStringLiteral("teach"));
        QVERIFY2(window.perspectives().all().size() == 4,
                 "the damaged perspective was removed from the list");
    }

    void everyPanelIsClosedFloatedAndRestored_data() {
        QTest::addColumn<QByteArray>("dock");
        for (const char* name : {"viewDock", "tabsDock", "plotsDock"}) {
            QTest::newRow(name) << QByteArray(name);
        }
    }
    void everyPanelIsClosedFloatedAndRestored() {
        QFETCH(QByteArray, dock);
        WindowBench bench;
        bench.show(QSize(1280, 720));
        PanelDock& panel = dockOf(bench.window, dock);
        run(bench.window, "view.toggle." + dock);
        QVERIFY(!panel.isVisible());
        QVERIFY(missing(bench.window).isEmpty());
        run(bench.window, "view.toggle." + dock);
        QVERIFY(panel.isVisible());

        run(bench.window, "view.float." + dock);
        QVERIFY(panel.isFloating() && panel.isVisible());
        // Floating panels of two robots must not look alike, so the robot is at the left and in full.
        panel.setRobot(QStringLiteral("Left cell (192.168.100.101)"));
        QTest::qWait(50);
        const auto& robot = *panel.findChild<QLabel*>("dock.robot." + QString(dock));
        QCOMPARE(robot.text(), QStringLiteral("Left cell (192.168.100.101)"));
        QVERIFY(robot.isVisible() && robot.x() < 20 && robot.width() >= robot.sizeHint().width());
        QVERIFY2(clipped(panel).isEmpty(), qPrintable(clipped(panel).join('\n')));
        keepPicture(panel, QStringLiteral("floating-") + dock);
        QTest::mouseClick(bench.window.findChild<QToolButton*>("dock.back." + QString(dock)), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.isFloating() && panel.isVisible(), 60'000);

        run(bench.window, "view.float." + dock);
        QTest::mouseClick(bench.window.findChild<QToolButton*>("dock.close." + QString(dock)),
                          Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.isVisible(), 60'000);
        // The command that floats a panel also shows it, and selecting the perspective docks it again.
        run(bench.window, "view.toggle." + dock);
        QVERIFY(panel.isVisible());
        chooseTeach(bench.window);
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(bench.window), 60'000);
    }

    // Content that does not have enough space scrolls. The jog buttons keep their size.
    void noArrangementShrinksTheJogColumn() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        const QSize before = bench.window.jogColumn().size();
        for (const char* dock : {"plotsDock", "tabsDock", "viewDock"}) {
            for (const char* side : {"left", "right", "top", "bottom"}) {
                const QByteArray id = QByteArray("panel.") + dock + '.' + side;
                run(bench.window, id);
                QTest::qWait(30);
                QCOMPARE(bench.window.size(), QSize(1280, 720));
                QVERIFY2(bench.window.jogColumn().size() == before, id);
                QVERIFY2(missing(bench.window).isEmpty(), qPrintable(missing(bench.window).join(", ")));
            }
        }
        const auto& area = bench.find<QScrollArea>("stageArea");
        chooseTeach(bench.window);
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(bench.window), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(
            !area.horizontalScrollBar()->isVisible() && !area.verticalScrollBar()->isVisible(), 60'000);
        run(bench.window, "panel.plotsDock.left");
        QTRY_VERIFY_WITH_TIMEOUT(area.horizontalScrollBar()->isVisible(), 60'000);
        QVERIFY(bench.window.jogColumn().size() == before);
    }

    void aTabOfAClosedPanelIsShownByItsCommand() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QTest::keyClick(&bench.window, Qt::Key_F8, Qt::ShiftModifier);
        QVERIFY(!dockOf(bench.window, "tabsDock").isVisible());
        run(bench.window, "view.log");
        QVERIFY(dockOf(bench.window, "tabsDock").isVisible());
        auto& tabs = bench.find<QTabBar>("tabs");
        QCOMPARE(tabs.tabData(tabs.currentIndex()).toString(), QStringLiteral("log"));
    }

    void aPanelIsDraggedAwayAndDropped_data() {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("by its title bar") << false;
        QTest::newRow("by its key") << true;
    }
    void aPanelIsDraggedAwayAndDropped() {
        QFETCH(bool, byKey);
        WindowBench bench;
        bench.show(QSize(2400, 1200));
        PanelDock& plots = dockOf(bench.window, "plotsDock");
        auto& key = bench.find<QToolButton>("dock.menu.plotsDock");
        const QPoint from = byKey ? key.mapTo(&bench.window, key.rect().center())
                                  : plots.mapTo(&bench.window, QPoint(30, 16));
        QWindow* screen = bench.window.windowHandle();
        QTest::mousePress(screen, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 10; ++i) {
            QTest::mouseMove(screen, from + QPoint(3 * i, -6 * i));
            QTest::qWait(10);
        }
        QVERIFY(plots.isFloating());
        QVERIFY2(!bench.find<QMenu>("menu.plotsDock").isVisible(), "a drag opened the menu");
        const QPoint to = dockOf(bench.window, "viewDock").mapTo(&bench.window, QPoint(300, 40));
        for (int i = 0; i < 20; ++i) {
            QTest::mouseMove(screen, to + QPoint(i, 0));
            QTest::qWait(10);
        }
        QTest::mouseRelease(screen, Qt::LeftButton, {}, to + QPoint(19, 0));
        QTRY_VERIFY_WITH_TIMEOUT(!plots.isFloating(), 60'000);
        // The panel is next to the view or above it, instead of below it.
        QTRY_VERIFY_WITH_TIMEOUT(
            placeOf(bench.window, "plotsDock").top() <= placeOf(bench.window, "viewDock").top(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(
            !placeOf(bench.window, "plotsDock").intersects(placeOf(bench.window, "viewDock")), 60'000);
        QVERIFY(bench.window.perspectives().isChanged());
        QVERIFY(missing(bench.window).isEmpty());
    }

    void panelWithHeldMotionKeysCannotBeClosed() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        auto& jog = bench.find<QDockWidget>("jogDock");
        QVERIFY(!jog.close());
        QVERIFY(jog.isVisible());
        QCOMPARE(jog.features(), QDockWidget::DockWidgetFeatures(QDockWidget::NoDockWidgetFeatures));
        for (const QDockWidget* dock : bench.window.findChildren<QDockWidget*>()) {
            QVERIFY2(!dock->isAncestorOf(bench.window.findChild<QWidget*>("stopButton")),
                     qPrintable(dock->objectName()));
        }
        for (const QAction* action : bench.window.actions().all()) {
            QVERIFY2(!action->objectName().contains("jogDock"), qPrintable(action->objectName()));
        }
        // With every panel closed, jog and stop buttons are still available.
        for (const char* id : {"view.toggle.viewDock", "view.toggle.tabsDock", "view.toggle.plotsDock"}) {
            run(bench.window, id);
        }
        QTest::qWait(50);
        QVERIFY2(missing(bench.window).isEmpty(), qPrintable(missing(bench.window).join(", ")));
        keepPicture(bench.window, "perspective-empty");
    }

    void aHeldKeyEndsWhenThePanelsChange_data() {
        QTest::addColumn<QByteArray>("command");
        for (const char* id :
             {"perspective.monitor", "perspective.teach", "perspective.saveAs", "view.float.plotsDock",
              "view.toggle.viewDock", "panel.tabsDock.left", "view.reset"}) {
            QTest::newRow(id) << QByteArray(id);
        }
    }
    void aHeldKeyEndsWhenThePanelsChange() {
        QFETCH(QByteArray, command);
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        auto& key = bench.find<HoldToRunButton>("jog.Z+");
        press(key);
        bench.cell.advanceMs(300);
        QVERIFY(!standsStill(bench.cell));
        run(bench.window, command);
        QVERIFY(!key.isHolding());
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        // The input is still held, and the motion must not resume.
        bench.cell.advanceMs(500);
        QVERIFY(standsStill(bench.cell));
        release(key);
    }

    void holdEndsWhenAnotherPanelIsRaised_data() {
        QTest::addColumn<bool>("byCommand");
        QTest::newRow("by its tab") << false;
        QTest::newRow("by its command") << true;
    }
    // Raising a tabbed panel moves no panel and does not change the page in it, but must end the hold.
    void holdEndsWhenAnotherPanelIsRaised() {
        QFETCH(bool, byCommand);
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        bench.window.showTab("waypoints");
        PanelDock& front = dockOf(bench.window, "viewDock");
        PanelDock& behind = dockOf(bench.window, "tabsDock");
        bench.find<app::DockStage>("stage").tabifyDockWidget(&front, &behind);
        front.raise();
        QTRY_VERIFY_WITH_TIMEOUT(!front.visibleRegion().isEmpty() && behind.visibleRegion().isEmpty(),
                                 60'000);
        auto& key = bench.find<HoldToRunButton>("jog.Z+");
        press(key);
        bench.cell.advanceMs(300);
        QVERIFY(!standsStill(bench.cell));
        if (byCommand) {
            run(bench.window, "view.waypoints");
        } else {
            behind.raise();
        }
        QVERIFY(!key.isHolding());
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        bench.cell.advanceMs(500);
        QVERIFY(standsStill(bench.cell));
        release(key);
        QTRY_VERIFY_WITH_TIMEOUT(front.visibleRegion().isEmpty() && !behind.visibleRegion().isEmpty(),
                                 60'000);
    }

    void spaceAndEscStopFromAFloatingPanel_data() {
        QTest::addColumn<int>("key");
        QTest::newRow("Space") << int(Qt::Key_Space);
        QTest::newRow("Esc") << int(Qt::Key_Escape);
    }
    // A stick moves the arm while the operator looks at a panel on another screen.
    void spaceAndEscStopFromAFloatingPanel() {
        QFETCH(int, key);
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        run(bench.window, "view.float.tabsDock");
        PanelDock& panel = dockOf(bench.window, "tabsDock");
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::activeWindow(), &panel, 60'000);
        tiltStick(bench);
        bench.cell.advanceMs(300);
        QVERIFY2(!standsStill(bench.cell), "the stick does not move the arm");
        auto* table = bench.window.waypoints().findChild<QTableView*>();
        QVERIFY(table != nullptr && panel.isAncestorOf(table));
        QTest::keyClick(table, Qt::Key(key));
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        bench.cell.advanceMs(500);
        QVERIFY2(standsStill(bench.cell), "the arm moves before the stick was neutral");
        QVERIFY(panel.isVisible());
    }

    // The notice and the view are destroyed together with their panels, in any order.
    void theWindowClosesWithAQuestionInAFloatingPanel() {
        auto bench = std::make_unique<WindowBench>();
        bench->show(QSize(1280, 720));
        QVERIFY2(bench->cell.bringUp(), qPrintable(bench->cell.what()));
        bench->window.waypoints().teach();
        run(bench->window, "view.float.tabsDock");
        bench->window.waypoints().touchUp();
        QVERIFY(bench->window.waypoints().touchUpGhost());
        QVERIFY(dockOf(bench->window, "tabsDock").isFloating());
        bench.reset();
    }

    void leavingAFloatingPanelStops() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        run(bench.window, "view.float.plotsDock");
        PanelDock& panel = dockOf(bench.window, "plotsDock");
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        tiltStick(bench);
        bench.cell.advanceMs(300);
        QVERIFY(!standsStill(bench.cell));
        bench.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        bench.cell.advanceMs(500);
        QVERIFY(standsStill(bench.cell));
    }

    void theKeyboardIsDisarmedWhenAFloatingPanelGetsTheFocus() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        run(bench.window, "view.float.plotsDock");
        bench.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        run(bench.window, "jog.keyboard");
        QVERIFY(bench.window.findChild<QWidget*>("armedFrame") != nullptr);
        PanelDock& panel = dockOf(bench.window, "plotsDock");
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        QTRY_VERIFY2_WITH_TIMEOUT(bench.window.findChild<QWidget*>("armedFrame") == nullptr, "disarmed",
                                  60'000);
        QTest::keyPress(&panel, Qt::Key_Up);
        bench.cell.advanceMs(200);
        QVERIFY(standsStill(bench.cell));
        QTest::keyRelease(&panel, Qt::Key_Up);
        // The shortcuts of the window also work in the panel.
        QTest::keyClick(&panel, Qt::Key_F6, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(standsAsInTeach(bench.window), 60'000);
    }

private:
    /// Simulates a stick that is neutral for 100 ms and then pushed upwards.
    static void tiltStick(WindowBench& bench) {
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys(), &bench.window.jogColumn().axisJog());
        const auto hold = [&bench, pump = bench.cell.everyRefresh](double up) {
            bench.cell.everyRefresh = [&bench, pump, up] {
                Deflection stick;
                stick.deadMan = true;
                stick.axes[2] = up;
                bench.window.jogColumn().axisJog().setInput(stick);
                pump();
            };
        };
        hold(0);
        bench.cell.advanceMs(100);
        hold(1);
    }
};

QTEST_MAIN(TestPerspectives)
#include "tst_perspectives.moc"
