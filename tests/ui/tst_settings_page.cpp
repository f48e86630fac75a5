// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings take effect immediately and are restored at the next start. A settings file cannot contain
// dangerous settings: only the user can raise the speed cap, and the header then shows it.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <optional>
#include <utility>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "app/preference_table.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "tests/support/pictures.h"
#include "tests/support/test_pad.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/apply_notation.h"
#include "widgets/common/theme.h"
#include "widgets/jog/device_jog.h"
#include "widgets/jog/device_trainer.h"
#include "widgets/jog/jog_selectors.h"

using namespace tiller;
using namespace tiller::test;
using app::Preferences;

namespace {

struct Bench : WindowBench {
    Bench() { show(QSize(1280, 720)); }
    app::SettingsPage* open() {
        QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
        return window.findChild<app::SettingsPage*>();
    }
};

/// Selects a value by keyboard: sets the focus, then presses an arrow key.
void choose(QWidget& page, const QString& name, Qt::Key arrow) {
    auto* box = page.findChild<QComboBox*>(name);
    QVERIFY(box != nullptr);
    box->setFocus(Qt::TabFocusReason);
    QTest::keyClick(box, arrow);
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

    void everyRowOfTheTableHasAField() {
        Bench bench;
        const app::SettingsPage* page = bench.open();
        QVERIFY(page != nullptr);
        for (const app::PreferenceRow& row : app::preferenceRows()) {
            const QString group = row.key.section('/', 0, 0);
            const QString name = row.key == QLatin1String("recording/fields") ? QStringLiteral("signals")
                                                                              : row.key.section('/', 1);
            const auto* field = page->findChild<QWidget*>(
                (group == QLatin1String("recording") ? "settings.recording." : "settings.") + name);
            QVERIFY2(field != nullptr, qPrintable(row.key));
            const QString text = app::SettingsPage::tr(row.name);
            if (const auto* box = qobject_cast<const QCheckBox*>(field)) {
                QCOMPARE(box->text(), text);
            } else if (row.editor != app::PreferenceRow::Editor::Custom) {
                QCOMPARE(field->accessibleName(), text);
            }
        }
    }

    void everyChoiceAppliesAtOnceAndIsSaved() {
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
        QTRY_VERIFY_WITH_TIMEOUT(close->height() >= 48, 60'000);

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

    void aRaisedCapIsShownInTheHeaderAndIsNotSaved() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        auto* banner = bench.window.findChild<QLabel*>("capBanner");
        QVERIFY(!banner->isVisible());
        app::SettingsPage* page = bench.open();
        auto* cap = page->findChild<QDoubleSpinBox*>("settings.speedCap");
        cap->setFocus();
        cap->selectAll();
        QTest::keyClicks(cap, "500");
        // The value does not change before editing is finished.
        QCOMPARE(page->preferences().speedCap, Preferences::kOrdinaryCap);
        QTest::keyClick(cap, Qt::Key_Return);
        QCOMPARE(page->preferences().speedCap, 0.5);
        QVERIFY(page->findChild<QLabel*>("settings.speedCapNote")->text().contains("enabling device"));
        keepPicture(*page, "settings-cap");
        QVERIFY2(banner->isVisible(), "the banner is not shown immediately");
        page->close();
        QCOMPARE(bench.window.session().limits().tcpSpeed, 0.5);
        QVERIFY(banner->isVisible());
        QVERIFY2(banner->text().contains("500"), qPrintable(banner->text()));
        QCoreApplication::processEvents();
        keepPicture(bench.window, "cap-banner");
        QCOMPARE(app::Settings(bench.file).preferences().speedCap, Preferences::kOrdinaryCap);
    }

    void loweredCapStopsTheJogAndAppliesToTheNext() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        bench.window.jogColumn().selectors().setSpeedClass(3);  // 100 mm/s
        auto* key = bench.window.findChild<HoldToRunButton*>("jog.Z+");
        press(*key);
        bench.cell.advanceMs(500);
        QVERIFY2(tcpSpeed(bench.cell) > 0.09, qPrintable(QString::number(tcpSpeed(bench.cell))));
        Preferences lower;
        lower.speedCap = 0.020;
        // Apply the preferences without the page, because opening the page would stop the arm.
        bench.window.applyPreferences(lower);
        bench.cell.advanceMs(200);
        QVERIFY2(standsStill(bench.cell), "the lower speed cap did not stop the jog");
        QVERIFY(!key->isHolding());
        bench.cell.advanceMs(300);
        QVERIFY2(standsStill(bench.cell), "the stopped jog resumed without a new press");
        release(*key);
        press(*key);
        bench.cell.advanceMs(500);
        QVERIFY(!standsStill(bench.cell));
        QVERIFY2(tcpSpeed(bench.cell) < 0.021, qPrintable(QString::number(tcpSpeed(bench.cell))));
        release(*key);
        bench.cell.advanceMs(200);
    }

    void maximumHoldTimeAppliesImmediately() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        app::SettingsPage* page = bench.open();
        auto* longest = page->findChild<QDoubleSpinBox*>("settings.longestHold");
        QCOMPARE(longest->value(), 20.0);
        longest->setFocus();
        longest->selectAll();
        QTest::keyClicks(longest, "6");
        QTest::keyClick(longest, Qt::Key_Return);
        QCOMPARE(page->preferences().longestHold, 6);
        QVERIFY2(page->findChild<QLabel*>("settings.holdNote")->text().contains("Key-state check"),
                 "the note does not state that the key-state check is unavailable");
        page->close();
        QCOMPARE(app::Settings(bench.file).preferences().longestHold, 6);
        QVERIFY(bench.window.findChild<QWidget*>("lastStopChip")->toolTip().contains("Key-state check"));
        auto* key = bench.window.findChild<HoldToRunButton*>("jog.Z+");
        bench.window.jogColumn().selectors().setSpeedClass(1);
        // Process the last events of the closed page before the key is pressed.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTest::qWait(50);
        bench.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.window));
        press(*key);
        bench.cell.advanceMs(5900);
        QVERIFY(!standsStill(bench.cell));
        bench.cell.advanceMs(400);
        QVERIFY(standsStill(bench.cell));
        QVERIFY(!key->isHolding());
        bench.cell.advanceMs(300);
        QCOMPARE(bench.window.session().state().lastStop.cause, control::StopCause::HeldTooLong);
        release(*key);
    }

    void aLoweredCapIsSaved() {
        QTemporaryDir folder;
        app::Settings settings(folder.filePath("settings.ini"));
        Preferences preferences;
        preferences.speedCap = 0.1;
        settings.setPreferences(preferences);
        VirtualClock clock;
        app::MainWindow window(settings, clock);
        QCOMPARE(window.session().limits().tcpSpeed, 0.1);
    }

    void invalidValuesInTheFileAreCorrected_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::newRow("cap raised") << "motion/speedCap"
                                    << "0.9";
        QTest::newRow("cap no number") << "motion/speedCap"
                                       << "nan";
        QTest::newRow("cap negative") << "motion/speedCap"
                                      << "-1";
        QTest::newRow("cap words") << "motion/speedCap"
                                   << "fast";
        QTest::newRow("hold for ever") << "motion/longestHold"
                                       << "1e9";
        QTest::newRow("hold no number") << "motion/longestHold"
                                        << "long";
        QTest::newRow("density") << "look/density"
                                 << "huge";
        QTest::newRow("lengths") << "look/lengths"
                                 << "furlong";
        QTest::newRow("dead zone") << "devices/gamepad/deadZone"
                                   << "nan";
        QTest::newRow("curve") << "devices/spaceMouse/exponent"
                               << "-3";
        QTest::newRow("a key that stops") << "shortcuts/app.help"
                                          << "Space";
        QTest::newRow("another that stops") << "shortcuts/app.help"
                                            << "Esc";
        QTest::newRow("a key that stops, then another") << "shortcuts/app.help"
                                                        << "Space, X";
        QTest::newRow("another, then one that stops") << "shortcuts/app.help"
                                                      << "X, Esc";
        QTest::newRow("a key that stops, with Ctrl") << "shortcuts/app.help"
                                                     << "Ctrl+Space";
        QTest::newRow("a key that stops, with Shift") << "shortcuts/app.help"
                                                      << "Shift+Esc";
        QTest::newRow("a key that stops, in the middle") << "shortcuts/app.help"
                                                         << "Ctrl+K, Alt+Space, X";
        QTest::newRow("rotations") << "look/rotations"
                                   << "17";
    }
    void invalidValuesInTheFileAreCorrected() {
        QFETCH(QString, key);
        QFETCH(QString, value);
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        QSettings(file, QSettings::IniFormat).setValue(key, value);
        const Preferences read = app::readPreferences(app::SettingsView(file));
        QVERIFY(read.speedCap >= Preferences::kLowestCap && read.speedCap <= Preferences::kOrdinaryCap);
        QVERIFY(read.longestHold >= Preferences::kShortestLongestHold &&
                read.longestHold <= Preferences::kMaxHoldLimit);
        QVERIFY(static_cast<int>(read.density) >= 0 && static_cast<int>(read.density) <= 2);
        QVERIFY(static_cast<int>(read.notation.length) <= 1);
        for (const DeviceTuning& tuning : read.devices) {
            QVERIFY(tuning == tuning.sane());
            QVERIFY(tuning.exponent >= 1);
        }
        QVERIFY(static_cast<int>(read.notation.rotation) <= 1);
        QVERIFY2(read.shortcuts.isEmpty(), "Space or Esc was accepted as a shortcut");
    }

    void aShortcutIsChangedRemovedAndNeverAssignedTwice() {
        Bench bench;
        app::SettingsPage* page = bench.open();
        page->findChild<QTabBar*>()->setCurrentIndex(2);
        keepPicture(*page, "settings-keys");
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::Key_F1)));
        QVERIFY2(page->hint().contains("Help"), qPrintable(page->hint()));
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::Key_Space)));
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::Key_Escape)));
        QVERIFY(!page->setShortcut("app.palette", QKeySequence(Qt::CTRL | Qt::Key_Space)));
        // Enter the shortcut by keyboard in the field of the command.
        auto* field = page->findChild<QWidget*>("settings.key.app.palette");
        QVERIFY(field != nullptr);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_P, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(page->preferences().shortcuts.value("app.palette"),
                                  QKeySequence(Qt::CTRL | Qt::Key_P), 60'000);
        page->close();
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::SettingsPage*>() == nullptr, 60'000);
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

    void aDeviceIsTunedEnabledAndTestedOnThePage() {
        Bench bench;
        bench.window.devices().addSource(std::make_unique<TestPad>());
        app::SettingsPage* page = bench.open();
        page->findChild<QTabBar*>()->setCurrentIndex(1);
        keepPicture(*page, "settings-devices");
        auto* zone = page->findChild<QDoubleSpinBox*>("settings.gamepad.deadZone");
        QCOMPARE(zone->value(), 8.0);
        zone->setFocus();
        zone->selectAll();
        QTest::keyClicks(zone, "20");
        QTest::keyClick(zone, Qt::Key_Return);
        const InputDevice& pad = *bench.window.devices().devices().front();
        QCOMPARE(bench.window.devices().shape(pad).deadZone, 0.2);
        QCOMPARE(bench.window.devices().shape(pad).exponent, 2.2);
        auto* dominant = page->findChild<QCheckBox*>("settings.gamepad.dominant");
        dominant->setFocus();
        QTest::keyClick(dominant, Qt::Key_Space);
        QVERIFY(bench.window.devices().shape(pad).dominantAxis);
        QVERIFY(app::Settings(bench.file).preferences().devices.value(kGamepadKind) ==
                (DeviceTuning{0.2, 2.2, true}));

        QVERIFY2(bench.window.devices().used() == nullptr, "a device was selected automatically");
        choose(*page, "settings.device", Qt::Key_Down);
        QVERIFY(bench.window.devices().used() == &pad);
        choose(*page, "settings.device", Qt::Key_Up);
        QVERIFY(bench.window.devices().used() == nullptr);

        QTest::mouseClick(page->findChild<QPushButton*>("settings.trainer"), Qt::LeftButton);
        auto* trainer = page->findChild<DeviceTrainer*>();
        QVERIFY(trainer != nullptr && trainer->isVisible());
        // Settings made in the test page are shown here and also saved.
        trainer->findChild<QCheckBox*>("device.dominant")->click();
        QVERIFY(!dominant->isChecked());
        QVERIFY(!app::Settings(bench.file).preferences().devices.value(kGamepadKind).dominantAxis);
        page->close();
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::SettingsPage*>() == nullptr, 60'000);

        VirtualClock clock;
        app::MainWindow next(app::Settings(bench.file), clock);
        next.devices().addSource(std::make_unique<TestPad>());
        QCOMPARE(next.devices().shape(*next.devices().devices().front()).deadZone, 0.2);
        QVERIFY2(next.devices().used() == nullptr, "a device was selected automatically after the start");
    }

    void jogColumnValuesCanBeEnteredByCommand() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const auto enter = [&bench](const char* id, double value) {
            bench.window.actions().find(QLatin1String(id))->trigger();
            auto* field = bench.window.findChild<QInputDialog*>("jogNumber");
            QVERIFY2(field != nullptr, id);
            field->setDoubleValue(value);
            QTest::keyClick(field, Qt::Key_Return);
            QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QInputDialog*>("jogNumber") == nullptr, 60'000);
        };
        const JogSelection& selection = bench.window.jogColumn().selection();
        enter("jog.speed.other", 33);
        QVERIFY(selection.speed && std::abs(selection.speed->tcp - 0.033) < 1e-9);
        enter("jog.step.other", 2.5);
        QVERIFY(selection.step && std::abs(selection.step->length - 0.0025) < 1e-9);
        enter("jog.contact.other", 25);
        QCOMPARE(selection.contactForce, 25.0);
        QCOMPARE(selection.motion, MotionChoice::UntilContact);
    }

    void theWindowClosesWithThePageStillOpen() {
        auto bench = std::make_unique<Bench>();
        const QPointer<app::SettingsPage> page = bench->open();
        page->findChild<QTabBar*>()->setCurrentIndex(3);
        auto* key = page->findChild<QWidget*>("settings.key.app.help");
        key->setFocus();
        QVERIFY(page->isVisible() && key->isVisible());
        const QKeySequence before = bench->window.actions().find("app.help")->shortcut();
        // The field loses the focus while the window is destroyed. This must not count as an edit, and must
        // not crash.
        bench->window.close();
        QVERIFY(!bench->window.isVisible());
        QCOMPARE(bench->window.actions().find("app.help")->shortcut(), before);
        QVERIFY(app::Settings(bench->file).preferences().shortcuts.isEmpty());
        bench.reset();
        QVERIFY2(page.isNull(), "the page still exists after its window was destroyed");
    }

    void allShortcutsCanBeResetTogether() {
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
