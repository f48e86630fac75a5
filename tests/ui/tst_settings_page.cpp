// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is chosen on the settings page holds at once, is there again at the next start, and cannot be made
// dangerous by a file: only a hand raises the speed cap, and then the header says so.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "app/main_window.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"

using namespace tiller;
using namespace tiller::test;
using app::Preferences;

namespace {

struct Bench {
    VirtualClock clock;
    QTemporaryDir folder;
    QString file = folder.filePath("settings.ini");
    app::MainWindow window{app::Settings(file), clock};
    VirtualCell cell{clock, window.session()};

    Bench() {
        window.resize(1280, 720);
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            qFatal("the window did not become active");
        }
    }
    app::SettingsPage* open() {
        QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
        return window.findChild<app::SettingsPage*>();
    }
};

/// As a hand does: focus, arrow.
void choose(QWidget& page, const QString& name, Qt::Key arrow) {
    auto* box = page.findChild<QComboBox*>(name);
    QVERIFY(box != nullptr);
    box->setFocus(Qt::TabFocusReason);
    QTest::keyClick(box, arrow);
}

void keepPicture(QWidget& widget, const QString& name) {
    const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
    if (!to.isEmpty()) {
        QVERIFY(widget.grab().save(QStringLiteral("%1/%2.png").arg(to, name)));
    }
}

}  // namespace

class TestSettingsPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        applyTheme(*qApp, Theme::light());
        applyDensity(*qApp, Density::Mouse);
        applyNotation(*qApp, {});
    }

    void everyChoiceHoldsAtOnceAndIsRemembered() {
        Bench bench;
        app::SettingsPage* page = bench.open();
        QVERIFY(page != nullptr);
        keepPicture(*page, "settings-look");
        const auto* close = page->findChild<QPushButton*>("settingsClose");
        QVERIFY(close->height() < 48);
        choose(*page, "settings.theme", Qt::Key_Down);
        QVERIFY(Theme::current().isDark());
        choose(*page, "settings.density", Qt::Key_Down);
        QCOMPARE(currentDensity(), Density::Touch);
        choose(*page, "settings.lengths", Qt::Key_Down);
        choose(*page, "settings.rotations", Qt::Key_Down);
        const Notation wanted{LengthUnit::Inches, RotationNotation::RotationVector};
        QVERIFY(Notation::current() == wanted);
        QCOMPARE(format::length(0.254), QStringLiteral("10.000 in"));
        QCOMPARE(format::rotation({0, 3.14159265, 0})[1], QStringLiteral("3.1416"));
        QCOMPARE(bench.window.findChild<QTableView*>("log.table")->verticalHeader()->defaultSectionSize(),
                 44);
        QTRY_VERIFY(close->height() >= 48);

        const app::Settings again(bench.file);
        QCOMPARE(again.theme(), QStringLiteral("dark"));
        QCOMPARE(again.preferences().density, Density::Touch);
        QVERIFY(again.preferences().notation == wanted);
        applyDensity(*qApp, Density::Mouse);
        applyNotation(*qApp, {});
        VirtualClock clock;
        const app::MainWindow next(again, clock);
        QCOMPARE(currentDensity(), Density::Touch);
        QVERIFY(Notation::current() == wanted);
    }

    void aRaisedCapIsOnTheHeaderAndEndsWithTheProgram() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        auto* banner = bench.window.findChild<QLabel*>("capBanner");
        QVERIFY(!banner->isVisible());
        app::SettingsPage* page = bench.open();
        auto* cap = page->findChild<QDoubleSpinBox*>("settings.speedCap");
        cap->setFocus();
        cap->selectAll();
        QTest::keyClicks(cap, "500");
        QCOMPARE(page->preferences().speedCap, Preferences::kOrdinaryCap);  // not before it is finished
        QTest::keyClick(cap, Qt::Key_Return);
        QCOMPARE(page->preferences().speedCap, 0.5);
        QVERIFY(page->findChild<QLabel*>("settings.speedCapNote")->text().contains("enabling device"));
        keepPicture(*page, "settings-cap");
        page->close();
        QCOMPARE(bench.window.session().limits().tcpSpeed, 0.5);
        QVERIFY(banner->isVisible());
        QVERIFY2(banner->text().contains("500"), qPrintable(banner->text()));
        QCoreApplication::processEvents();
        keepPicture(bench.window, "cap-banner");
        QCOMPARE(app::Settings(bench.file).preferences().speedCap, Preferences::kOrdinaryCap);
    }

    void aLoweredCapStays() {
        QTemporaryDir folder;
        app::Settings settings(folder.filePath("settings.ini"));
        Preferences preferences;
        preferences.speedCap = 0.1;
        settings.setPreferences(preferences);
        VirtualClock clock;
        app::MainWindow window(settings, clock);
        QCOMPARE(window.session().limits().tcpSpeed, 0.1);
    }

    void whateverTheFileSaysTheValuesAreSane_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QVERIFY2(banner->isVisible(), "at once");
        QTest::newRow("cap raised") << "motion/speedCap"
                                    << "0.9";
        QTest::newRow("cap no number") << "motion/speedCap"
                                       << "nan";
        QTest::newRow("cap negative") << "motion/speedCap"
                                      << "-1";
        QTest::newRow("cap words") << "motion/speedCap"
                                   << "fast";
        QTest::newRow("density") << "look/density"
                                 << "huge";
        QTest::newRow("lengths") << "look/lengths"
                                 << "furlong";
        QTest::newRow("rotations") << "look/rotations"
                                   << "17";
    }
    void whateverTheFileSaysTheValuesAreSane() {
        QFETCH(QString, key);
        QFETCH(QString, value);
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
    void aLoweredCapStopsTheJogAndHoldsForTheNextPress() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        bench.window.jogColumn().setSpeedClass(3);  // 100 mm/s
        auto* key = bench.window.findChild<HoldButton*>("jog.Z+");
        press(*key);
        bench.cell.advanceMs(500);
        QVERIFY2(tcpSpeed(bench.cell) > 0.09, qPrintable(QString::number(tcpSpeed(bench.cell))));
        Preferences lower;
        lower.speedCap = 0.020;
        // As the page does; the page itself would stop the arm by opening.
        bench.window.applyPreferences(lower);
        bench.cell.advanceMs(200);
        QVERIFY2(standsStill(bench.cell), "the key is still held");
        QVERIFY(!key->isHolding());
        bench.cell.advanceMs(300);
        QVERIFY2(standsStill(bench.cell), "a stopped jog needs a new press");
        release(*key);
        press(*key);
        bench.cell.advanceMs(500);
        QVERIFY(!standsStill(bench.cell));
        QVERIFY2(tcpSpeed(bench.cell) < 0.021, qPrintable(QString::number(tcpSpeed(bench.cell))));
        release(*key);
        bench.cell.advanceMs(200);
    }

        QSettings(file, QSettings::IniFormat).setValue(key, value);
        const Preferences read = app::readPreferences(file);
        QVERIFY(read.speedCap >= Preferences::kLowestCap && read.speedCap <= Preferences::kOrdinaryCap);
        QVERIFY(static_cast<int>(read.density) >= 0 && static_cast<int>(read.density) <= 2);
        QVERIFY(static_cast<int>(read.notation.length) <= 1);
        QVERIFY(static_cast<int>(read.notation.rotation) <= 1);
    }

    void aKeyIsChangedTakenAwayAndNeverGivenTwice() {
        Bench bench;
        app::SettingsPage* page = bench.open();
        page->findChild<QTabBar*>()->setCurrentIndex(1);
        keepPicture(*page, "settings-keys");
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::Key_F1)));
        QVERIFY2(page->hint().contains("Help"), qPrintable(page->hint()));
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::Key_Space)));
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::Key_Escape)));
        // As a hand does, in the field of the command.
        auto* field = page->findChild<QWidget*>("settings.key.app.palette");
        QVERIFY(field != nullptr);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_P, Qt::ControlModifier);
        QTRY_COMPARE(page->preferences().shortcuts.value("app.palette"), QKeySequence(Qt::CTRL | Qt::Key_P));
        page->close();
        QTRY_VERIFY(bench.window.findChild<app::SettingsPage*>() == nullptr);
        bench.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        QTest::keyClick(&bench.window, Qt::Key_K, Qt::ControlModifier);
        QVERIFY(bench.window.findChild<app::CommandPalette*>() == nullptr);
        QTest::keyClick(&bench.window, Qt::Key_P, Qt::ControlModifier);
        QVERIFY(bench.window.findChild<app::CommandPalette*>() != nullptr);
        QCOMPARE(app::Settings(bench.file).preferences().shortcuts.value("app.palette"),
                 QKeySequence(Qt::CTRL | Qt::Key_P));
        QVERIFY(bench.window.actions().helpText().contains("Ctrl+P"));
    }

    void theWindowClosesWithThePageStillOpen() {
        Bench bench;
        app::SettingsPage* page = bench.open();
        page->findChild<QTabBar*>()->setCurrentIndex(1);
        page->findChild<QWidget*>("settings.key.app.help")->setFocus();
    }

    void allKeysGoBackAtOnce() {
        Bench bench;
        app::SettingsPage* page = bench.open();
        QVERIFY(page->setShortcut("app.help", {}));
        QVERIFY(bench.window.actions().find("app.help")->shortcut().isEmpty());
        QTest::mouseClick(page->findChild<QPushButton*>("settings.shortcutDefaults"), Qt::LeftButton);
        QCOMPARE(bench.window.actions().find("app.help")->shortcut(), QKeySequence(Qt::Key_F1));
        QVERIFY(app::Settings(bench.file).preferences().shortcuts.isEmpty());
    }
};

QTEST_MAIN(TestSettingsPage)
#include "tst_settings_page.moc"
