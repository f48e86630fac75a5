// SPDX-License-Identifier: GPL-3.0-or-later
//
// F1 opens the manual at the page for the focus widget, also in dialogs, and stops any motion. Without a
// manual, the help explains how to get it. The tests use the manual in the build tree. Tests that need it are
// skipped if it was not built.

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>

#include "app/action_table.h"
#include "app/help_page.h"
#include "app/manual.h"
#include "app/settings_page.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/status/preflight_page.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

QString manual() {
    return QStringLiteral(TILLER_MANUAL);
}
bool hasManual() {
    return QFile::exists(manual() + "/index.html");
}

struct Bench : WindowBench {
    Bench() { show(QSize(1600, 900)); }
    app::HelpPage* help() {
        const auto pages = window.findChildren<app::HelpPage*>();
        return pages.isEmpty() || !pages.last()->isVisible() ? nullptr : pages.last();
    }
    QTextBrowser* shown() {
        return help() == nullptr ? nullptr : help()->findChild<QTextBrowser*>("help.manual");
    }
    /// Returns the name of the displayed page, as in the table.
    QString page() {
        const QTextBrowser* browser = shown();
        if (browser == nullptr) {
            return QStringLiteral("no help is shown");
        }
        const QUrl source = browser->source();
        const QString path = source.toLocalFile().remove(manual() + '/');
        return source.hasFragment() ? path + '#' + source.fragment() : path;
    }
    QDialog* open(const char* id) {
        window.actions().find(QLatin1String(id))->trigger();
        QCoreApplication::processEvents();
        return qobject_cast<QDialog*>(QApplication::activeWindow());
    }
};

/// Presses F1 in the focus widget.
void pressF1() {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr ? focus : QApplication::activeWindow(), Qt::Key_F1);
    QCoreApplication::processEvents();
}

}  // namespace

#define NEEDS_MANUAL()                                            \
    if (!hasManual()) {                                           \
        QSKIP("the manual is not built: install python3-sphinx"); \
    }

class TestHelp : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { qputenv("XDG_DATA_DIRS", QByteArray(TILLER_MANUAL "/../..")); }

    void everyHelpContextHasAPage() {
        NEEDS_MANUAL();
        app::HelpPage help(20, {}, manual());
        help.resize(820, 300);
        help.show();
        auto* browser = help.findChild<QTextBrowser*>("help.manual");
        QVERIFY(app::manualPlaces().size() > 10);
        for (const app::ManualPlace& place : app::manualPlaces()) {
            const QString file = place.page.section('#', 0, 0);
            QVERIFY2(QFile::exists(manual() + '/' + file), qPrintable(place.page));
            help.showManual(QStringLiteral("index.html"));
            help.showManual(place.page);
            QCoreApplication::processEvents();
            QVERIFY2(browser->toPlainText().size() > 200, qPrintable(place.page));
            QVERIFY2(!place.page.contains('#') || browser->verticalScrollBar()->value() > 0,
                     qPrintable(place.page + ": section not found"));
        }
    }

    void everyHelpContextNamesAWidget() {
        Bench bench;
        for (const char* id :
             {"robot.connect", "app.settings", "app.report", "jog.devices", "project.sample"}) {
            QAction* action = bench.window.actions().find(QLatin1String(id));
            QVERIFY2(action != nullptr, id);
            action->trigger();
            QCoreApplication::processEvents();
        }
        bench.window.showPreflight({QStringLiteral("Nobody"), QStringLiteral("127.0.0.254"), 0, false});
        // The first two appear only after a robot problem or when a file is imported. The dialogs are tested
        // in everyDialogHasItsPage.
        const QStringList elsewhere{
            "recoveryPage",   "importSettings",    "waypoint.actions", "waypoint.properties",
            "waypoint.shift", "waypoint.history",  "pattern",          "programDialog",
            "commandPalette", "perspectiveDialog", "perspectiveDelete"};
        for (const app::ManualPlace& place : app::manualPlaces()) {
            QVERIFY2(
                elsewhere.contains(place.widget) || bench.window.findChild<QWidget*>(place.widget) != nullptr,
                qPrintable("there is no " + place.widget));
        }
    }

    // The dialog of a command must have a specific page instead of the table of contents. Commands that move,
    // end or close something, and native dialogs, are not run.
    void everyDialogHasItsPage() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.window.frames().teachFromTcp();
        bench.cell.advanceMs(300);
        bench.window.waypoints().selectRow(0);
        const QStringList left{"app.quit",
                               "app.help",
                               "app.exportSettings",
                               "app.importSettings",
                               "log.action.export",
                               "plots.action.export",
                               "project.new",
                               "project.open",
                               "project.saveAs",
                               "waypoint.action.import",
                               "waypoint.action.export"};
        QMap<QString, QString> pages;
        QString now;
        // Some dialogs have their own event loop.
        QTimer look;
        const auto closeWhatIsOpen = [&] {
            QList<QPointer<QDialog>> open;
            for (QWidget* top : QApplication::topLevelWidgets()) {
                open.append(qobject_cast<QDialog*>(top));
            }
            for (const QPointer<QDialog>& dialog : open) {
                if (dialog != nullptr && dialog->isVisible()) {
                    if (!dialog->inherits("QFileDialog")) {
                        pages.insert(dialog->objectName(), app::manualPageOf(dialog));
                    }
                    dialog->reject();
                }
            }
        };
        connect(&look, &QTimer::timeout, this, closeWhatIsOpen);
        look.start(20);
        const QList<QAction*> all = bench.window.actions().all();
        for (QAction* action : all) {
            // An ellipsis in the text means that the command opens a dialog.
            const bool asks =
                action->text().contains(QStringLiteral("…")) ||
                QStringList{"robot.connect", "app.settings", "app.palette", "power.recover"}.contains(
                    action->objectName());
            if (!asks || left.contains(action->objectName()) ||
                action->objectName().startsWith(QLatin1String("project.recent"))) {
                continue;
            }
            action->setEnabled(true);
            action->trigger();
            QCoreApplication::processEvents();
            closeWhatIsOpen();
        }
        for (const char* question :
             {"waypoint.actions", "waypoint.properties", "waypoint.shift", "waypoint.history", "pattern",
              "programDialog", "commandPalette", "perspectiveDialog", "perspectiveDelete"}) {
            QVERIFY2(pages.contains(QLatin1String(question)), question);
        }
        const QStringList without = pages.keys(QStringLiteral("index.html"));
        QVERIFY2(without.isEmpty(), qPrintable(without.join(QStringLiteral(", "))));
    }

    void picturesExistAndFitThePage() {
        NEEDS_MANUAL();
        app::HelpPage help(20, {}, manual());
        help.show();
        auto* browser = help.findChild<QTextBrowser*>("help.manual");
        int pictures = 0;
        for (const QString& file : QDir(manual() + "/window").entryList({"*.html"})) {
            help.showManual("window/" + file);
            QCoreApplication::processEvents();
            QVERIFY2(browser->horizontalScrollBar()->maximum() == 0,
                     qPrintable(file + " is wider than the page"));
            for (QTextBlock block = browser->document()->begin(); block.isValid(); block = block.next()) {
                for (auto part = block.begin(); !part.atEnd(); ++part) {
                    const QTextImageFormat image = part.fragment().charFormat().toImageFormat();
                    if (!image.isValid()) {
                        continue;
                    }
                    const QUrl place = browser->source().resolved(QUrl(image.name()));
                    QVERIFY2(!QImage(place.toLocalFile()).isNull(), qPrintable(file + ": " + image.name()));
                    QVERIFY2(block.text().trimmed().size() == 1,
                             qPrintable(file + ": image on the same line as " + block.text()));
                    ++pictures;
                }
            }
        }
        QVERIFY(pictures >= 12);
    }

    void f1ShowsThePageOfTheFocusedWidget_data() {
        QTest::addColumn<QString>("tab");
        QTest::addColumn<QString>("widget");
        QTest::addColumn<QString>("page");
        QTest::newRow("view") << ""
                              << "scene"
                              << "window/view.html";
        QTest::newRow("plots") << ""
                               << "plots.view"
                               << "window/plots.html";
        QTest::newRow("waypoints") << "waypoints"
                                   << "waypoint.table"
                                   << "window/waypoints.html";
        QTest::newRow("going through") << "waypoints"
                                       << "waypoint.routeScope"
                                       << "window/going_through.html";
        QTest::newRow("frames") << "frames"
                                << "frame.table"
                                << "window/frames.html";
        QTest::newRow("inputs") << "io"
                                << "io.search"
                                << "window/io.html";
        QTest::newRow("gripper") << "gripper"
                                 << "gripper.kind"
                                 << "window/io.html#gripper";
        QTest::newRow("log") << "log"
                             << "log.search"
                             << "window/log.html";
        QTest::newRow("the tabs themselves") << "tools"
                                             << "tabs"
                                             << "window/tools.html";
    }
    void f1ShowsThePageOfTheFocusedWidget() {
        NEEDS_MANUAL();
        QFETCH(QString, tab);
        QFETCH(QString, widget);
        QFETCH(QString, page);
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.window.frames().teachFromTcp();
        bench.cell.advanceMs(300);
        if (!tab.isEmpty()) {
            bench.window.showTab(tab);
        }
        auto& focus = bench.find<QWidget>(widget.toLatin1().constData());
        focus.setFocus();
        QVERIFY(focus.hasFocus());
        pressF1();
        QCOMPARE(bench.page(), page);
        // F1 inside the help window does not change the page.
        pressF1();
        QCOMPARE(bench.page(), page);
        QCOMPARE(bench.window.findChildren<app::HelpPage*>().size(), 1);
    }

    void aNewHelpPageReplacesTheOpenOne() {
        NEEDS_MANUAL();
        Bench bench;
        bench.window.showTab("log");
        bench.find<QWidget>("log.search").setFocus();
        pressF1();
        QCOMPARE(bench.page(), QStringLiteral("window/log.html"));
        bench.window.activateWindow();
        bench.find<QWidget>("scene").setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QWidget>("scene").hasFocus(), 60'000);
        pressF1();
        QCOMPARE(bench.page(), QStringLiteral("window/view.html"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.window.findChildren<app::HelpPage*>().size(), 1, 60'000);
    }

    void f1WorksInDialogs() {
        NEEDS_MANUAL();
        Bench bench;
        QDialog* settings = bench.open("app.settings");
        QVERIFY(settings != nullptr && settings->isVisible());
        pressF1();
        QCOMPARE(bench.page(), QStringLiteral("window/settings.html"));
        // The help window can be used while the dialog is open.
        QVERIFY(QTest::qWaitForWindowActive(bench.help()));
        QTest::mouseClick(bench.help()->findChild<QPushButton*>("help.contents"), Qt::LeftButton);
        QCOMPARE(bench.page(), QStringLiteral("index.html"));
        QTest::keyClick(bench.help(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(bench.help() == nullptr, 60'000);
        QVERIFY(settings->isVisible());
        settings->close();
    }

    void theConnectionCheckHasItsHelpPage() {
        NEEDS_MANUAL();
        Bench bench;
        bench.window.showPreflight({QStringLiteral("Nobody"), QStringLiteral("127.0.0.254"), 0, false});
        auto* checks = bench.window.findChild<PreflightPage*>();
        checks->activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(checks->isActiveWindow(), 60'000);
        pressF1();
        QCOMPARE(bench.page(), QStringLiteral("window/connecting.html#before-you-connect"));
    }

    void customKeyWorksInDialogsToo() {
        NEEDS_MANUAL();
        Bench bench;
        app::Preferences preferences;
        preferences.shortcuts["app.help"] = QKeySequence(Qt::CTRL | Qt::Key_H);
        bench.window.applyPreferences(preferences);
        QDialog* settings = bench.open("app.settings");
        pressF1();
        QVERIFY(bench.help() == nullptr);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_H, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(bench.page(), QStringLiteral("window/settings.html"), 60'000);
        settings->close();
    }

    void theShortcutFieldConsumesTheKey() {
        Bench bench;
        auto* settings = qobject_cast<app::SettingsPage*>(bench.open("app.settings"));
        QVERIFY(settings != nullptr);
        auto* pages = settings->findChild<QTabWidget*>("settingsPages");
        pages->setCurrentIndex(pages->count() - 1);
        auto* field = settings->findChild<QWidget*>("settings.key.app.palette");
        QVERIFY(field != nullptr);
        field->setFocus();
        QVERIFY(QApplication::focusWidget() != nullptr);
        pressF1();
        QVERIFY(bench.help() == nullptr);
        settings->close();
    }

    void stopEndsTheCurrentMotion() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        auto& key = bench.find<HoldToRunButton>("jog.Z+");
        press(key);
        QVERIFY(bench.cell.advanceUntil([&] { return tcpSpeed(bench.cell) > 0.01; }, 2000));
        QTest::keyClick(&bench.window, Qt::Key_F1);
        QVERIFY(bench.help() != nullptr);
        QVERIFY(bench.cell.advanceUntil([&] { return standsStill(bench.cell); }, 2000));
        release(key);
    }

    void linksAndBackNavigateBetweenPages() {
        NEEDS_MANUAL();
        Bench bench;
        bench.find<QWidget>("scene").setFocus();
        bench.window.actions().find("app.help")->trigger();
        auto* browser = bench.shown();
        auto* back = bench.help()->findChild<QPushButton*>("help.back");
        bench.help()->showManual("window/header.html");
        browser->setFocus();
        QTest::keyClick(browser, Qt::Key_Tab);  // moves the focus to the first link
        QTest::keyClick(browser, Qt::Key_Return);
        QCOMPARE(bench.page(), QStringLiteral("window/recovery.html"));
        QVERIFY(back->isEnabled());
        QTest::mouseClick(back, Qt::LeftButton);
        QCOMPARE(bench.page(), QStringLiteral("window/header.html"));
    }

    void missingManualShowsHowToGetIt() {
        qputenv("XDG_DATA_DIRS", "/nowhere");
        Bench bench;
        bench.find<QWidget>("scene").setFocus();
        pressF1();
        QVERIFY(bench.shown() != nullptr);
        QVERIFY2(bench.shown()->toPlainText().contains("python3-sphinx"),
                 qPrintable(bench.shown()->toPlainText()));
        QVERIFY(!bench.help()->findChild<QPushButton*>("help.contents")->isEnabled());
        // Built-in information is available even without the manual.
        QVERIFY(bench.help()->findChild<QTextBrowser*>("helpText")->toPlainText().contains("emergency stop"));
    }

    void helpPagesFollowTheThemeOfTheWindow() {
        NEEDS_MANUAL();
        Bench bench;
        bench.find<QWidget>("scene").setFocus();
        for (const char* theme : {"light", "dark"}) {
            bench.window.setTheme(QLatin1String(theme));
            bench.window.activateWindow();
            bench.find<QWidget>("scene").setFocus();
            QTRY_VERIFY_WITH_TIMEOUT(bench.find<QWidget>("scene").hasFocus(), 60'000);
            pressF1();
            bench.help()->showManual("window/plots.html");
            QCoreApplication::processEvents();
            QVERIFY2(clipped(*bench.help()).isEmpty(), qPrintable(clipped(*bench.help()).join('\n')));
            const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
            if (!to.isEmpty()) {
                QVERIFY(bench.help()->grab().save(
                    QStringLiteral("%1/help-%2.png").arg(to, QLatin1String(theme))));
                bench.help()->showManual("simulator.html");
                QVERIFY(bench.help()->grab().save(
                    QStringLiteral("%1/help-first-%2.png").arg(to, QLatin1String(theme))));
            }
        }
        bench.window.setTheme("light");
    }
};

QTEST_MAIN(TestHelp)
#include "tst_help.moc"
