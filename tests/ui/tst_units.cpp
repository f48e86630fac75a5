// SPDX-License-Identifier: GPL-3.0-or-later
//
// The units selected in the settings apply to all parts of the window that display or accept a length.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTest>

#include "app/action_table.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/apply_notation.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/state_chip.h"
#include "widgets/frames/frame_details.h"
#include "widgets/frames/frame_model.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/pose_view.h"
#include "widgets/jog/travel_watch.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/project/undoable_document.h"
#include "widgets/status/preflight_page.h"
#include "widgets/status/recovery_page.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct Bench : WindowBench {
    Bench() { show(QSize(1600, 900)); }
    /// Selects an entry by keyboard, in the list on the settings page.
    void choose(const char* list, Qt::Key arrow) {
        QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
        auto* page = window.findChild<app::SettingsPage*>();
        auto* box = page->findChild<QComboBox*>(QLatin1String(list));
        box->setFocus(Qt::TabFocusReason);
        QTest::keyClick(box, arrow);
        page->close();
        QTRY_VERIFY_WITH_TIMEOUT(window.findChild<app::SettingsPage*>() == nullptr, 60'000);
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        cell.advanceMs(100);
    }
};

/// The texts of a widget, including those for screen readers.
QStringList wordsOf(const QWidget& widget) {
    QStringList words = {widget.toolTip(), widget.accessibleName(), widget.accessibleDescription()};
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        words << label->text();
    }
    if (const auto* label = qobject_cast<const ElidedLabel*>(&widget)) {
        words << label->fullText();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        words << button->text();
    }
    if (const auto* box = qobject_cast<const QDoubleSpinBox*>(&widget)) {
        words << box->text();
    }
    if (const auto* chip = qobject_cast<const StateChip*>(&widget)) {
        words << chip->text();
    }
    if (const auto* table = qobject_cast<const QTableView*>(&widget)) {
        // Existing log entries do not change.
        const QAbstractItemModel* model = table->objectName() == "log.table" ? nullptr : table->model();
        for (int column = 0; model != nullptr && column < model->columnCount(); ++column) {
            words << model->headerData(column, Qt::Horizontal).toString();
            for (int row = 0; row < model->rowCount(); ++row) {
                words << model->index(row, column).data().toString();
            }
        }
    }
    return words;
}

const QRegularExpression kMillimetres(QStringLiteral(R"(\bmm\b)"));
/// Matches "in" only after a number or at the end of a column header, because "in" is also an English word.
const QRegularExpression kInches(QStringLiteral(R"(\d\s?in(/s)?(?![a-z/])|^(Blend|Origin|TCP) in$)"));

/// Returns all texts that match, with their widgets. Excludes plots, log entries and the last message.
QStringList figuresIn(const QRegularExpression& figure, const QWidget& root) {
    const auto* plots = root.findChild<PlotDock*>();
    QStringList found;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        // Messages with a time do not change, like log entries.
        if (plots != nullptr &&
            (widget == plots || plots->isAncestorOf(widget) || widget->objectName() == "lastMessage")) {
            continue;
        }
        for (const QString& words : wordsOf(*widget)) {
            if (words.contains(figure)) {
                found << QStringLiteral("%1 \"%2\": %3")
                             .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                                  words);
            }
        }
    }
    return found;
}

/// Names of widgets that display a length.
constexpr const char* kPlaces[] = {
    "lastStopChip", "jogMotion.1",     "jogMotion.3",         "jogSpeed.0",
    "jogSpeed.4",   "waypoint.table",  "waypoint.details.x",  "waypoint.details.facts",
    "frame.table",  "frame.details.x", "frame.details.facts", "jog.Z+"};

/// Returns the names of the widgets in the list that do not show the unit.
QStringList placesWithout(const QRegularExpression& figure, const QWidget& root) {
    const QStringList found = figuresIn(figure, root);
    QStringList places;
    for (const char* place : kPlaces) {
        const QString quoted = QStringLiteral("\"%1\"").arg(QLatin1String(place));
        if (found.filter(quoted).isEmpty()) {
            places << quoted;
        }
    }
    return places;
}

}  // namespace

class TestUnits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() { applyNotation(*qApp, {}); }
    void cleanupTestCase() { applyNotation(*qApp, {}); }

    void everyWidgetFollowsTheUnitSetting() {
        Bench bench;
        app::MainWindow& window = bench.window;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        driveKeys(bench.cell, window.jogColumn().holdKeys());
        window.waypoints().teach();
        WaypointModel& waypoints = window.waypoints().model();
        QVERIFY(waypoints.setData(waypoints.index(0, WaypointModel::Move), "L", Qt::EditRole));
        QVERIFY(waypoints.setData(waypoints.index(0, WaypointModel::Blend), "5", Qt::EditRole));
        window.frames().teachFromTcp();
        auto* key = window.findChild<HoldToRunButton*>("jog.X+");
        press(*key);
        bench.cell.advanceMs(400);
        release(*key);
        bench.cell.advanceMs(800);
        for (int look = 0; look < 24; ++look) {
            window.jogColumn().travel().look();
        }

        // After an update of the panels, all lengths in millimetres must have changed to inches.
        QTRY_VERIFY2_WITH_TIMEOUT(
            placesWithout(kMillimetres, window).isEmpty(),
            qPrintable(placesWithout(kMillimetres, window).join(' ') + " shows no length"), 60'000);
        QVERIFY(figuresIn(kInches, window).isEmpty());

        bench.choose("settings.lengths", Qt::Key_Down);
        QCOMPARE(Notation::current().length, LengthUnit::Inches);
        for (int look = 0; look < 24; ++look) {
            window.jogColumn().travel().look();
        }
        QTRY_VERIFY2_WITH_TIMEOUT(figuresIn(kMillimetres, window).isEmpty(),
                                  qPrintable(figuresIn(kMillimetres, window).join('\n')), 60'000);
        QTRY_VERIFY2_WITH_TIMEOUT(placesWithout(kInches, window).isEmpty(),
                                  qPrintable(placesWithout(kInches, window).join(' ') + " has no inches"),
                                  60'000);
        keepPicture(window, "units-inches");
        // This value is painted and not a text of the widget, so it is checked by name.
        QTRY_VERIFY_WITH_TIMEOUT(window.findChild<LimiterLine*>()->quietText().endsWith(" in"), 60'000);
        auto* pose = window.findChild<PoseView*>();
        const double x = window.session().state().tcpPose.position.x();
        QCOMPARE(pose->positionText(0), format::lengthNumber(x, 2, true));
        QCOMPARE(waypoints.index(0, WaypointModel::Speed).data().toString(), QStringLiteral("9.84 in/s"));
        for (const QAction* action : window.actions().all()) {
            QVERIFY2(!action->text().contains(kMillimetres), qPrintable(action->text()));
        }
        QCOMPARE(window.actions().find("jog.speed.2")->text(), QStringLiteral("Jog speed 1.97 in/s"));

        bench.choose("settings.lengths", Qt::Key_Up);
        for (int look = 0; look < 24; ++look) {
            window.jogColumn().travel().look();
        }
        QTRY_VERIFY2_WITH_TIMEOUT(figuresIn(kInches, window).isEmpty(),
                                  qPrintable(figuresIn(kInches, window).join('\n')), 60'000);
        QCOMPARE(window.actions().find("jog.speed.2")->text(), QStringLiteral("Jog speed 50 mm/s"));
    }

    // Labels, tables and fields use the typographic minus sign. Copied numbers use a hyphen.
    void everyMinusSignIsTheSameCharacter() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.window.frames().teachFromTcp();
        bench.cell.advanceMs(200);
        const QRegularExpression hyphen(QStringLiteral(R"((?<![\w./:-])-\s?\d)"));
        const QRegularExpression minus(QStringLiteral("−\\d"));
        QVERIFY(QStringLiteral("X -12.5").contains(hyphen) && !QStringLiteral("2-100 %").contains(hyphen));
        // The arm is at negative X and Y. Fields and tables display these values.
        for (const char* place : {"\"waypoint.details.x\"", "\"frame.details.x\"", "\"frame.table\""}) {
            QTRY_VERIFY2_WITH_TIMEOUT(!figuresIn(minus, bench.window).filter(QLatin1String(place)).isEmpty(),
                                      place, 60'000);
        }
        QTRY_VERIFY2_WITH_TIMEOUT(figuresIn(hyphen, bench.window).isEmpty(),
                                  qPrintable(figuresIn(hyphen, bench.window).join('\n')), 60'000);
        const auto* pose = bench.window.findChild<PoseView*>();
        QVERIFY2(pose->positionText(0).startsWith(QChar(0x2212)), qPrintable(pose->positionText(0)));
        for (const JogKey* key : bench.window.findChildren<JogKey*>()) {
            QVERIFY2(!key->text().contains(QLatin1Char('-')), qPrintable(key->text()));
        }
    }

    void typedValuesUseTheUnit() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        WaypointModel& model = bench.window.waypoints().model();
        QVERIFY(model.setData(model.index(0, WaypointModel::Move), "L", Qt::EditRole));
        bench.choose("settings.lengths", Qt::Key_Down);
        QVERIFY(model.setData(model.index(0, WaypointModel::Speed), "10", Qt::EditRole));
        QVERIFY(std::abs(bench.window.document().waypoints().at(0).toolSpeed - 0.254) < 1e-12);
        QVERIFY(model.setData(model.index(0, WaypointModel::Blend), "0.5 in", Qt::EditRole));
        QVERIFY(std::abs(bench.window.document().waypoints().at(0).blend - 0.0127) < 1e-12);
        QSignalSpy refused(&model, &WaypointModel::editRefused);
        QVERIFY(!model.setData(model.index(0, WaypointModel::Speed), "50", Qt::EditRole));
        QVERIFY2(refused[0][0].toString().contains("39.37 in/s"), qPrintable(refused[0][0].toString()));
        // Values that were not edited keep their digits. Opening and closing the editor is not an edit.
        const int steps = bench.window.document().undoStack().count();
        const QString shown = model.index(0, WaypointModel::Speed).data(Qt::EditRole).toString();
        QVERIFY(model.setData(model.index(0, WaypointModel::Speed), shown, Qt::EditRole));
        QCOMPARE(bench.window.document().undoStack().count(), steps);
    }

    void pagesFollowTheUnitSetting() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.protectiveStop();
        bench.cell.advanceMs(300);
        bench.window.actions().find("power.recover")->trigger();
        auto* recovery = bench.window.findChild<RecoveryPage*>();
        QVERIFY(recovery != nullptr);
        QVERIFY(recovery->findChild<QLabel*>("recoveryWhere")->text().contains("mm"));
        auto* speed = recovery->findChild<StopPlot*>("recoveryPlot2");
        QVERIFY(speed->peakText().endsWith("mm/s"));
        applyNotation(*qApp, {LengthUnit::Inches, RotationNotation::RollPitchYaw});
        QVERIFY2(figuresIn(kMillimetres, *recovery).isEmpty(),
                 qPrintable(figuresIn(kMillimetres, *recovery).join('\n')));
        QVERIFY(speed->peakText().endsWith("in/s"));

        app::SettingsPage page(app::Preferences(), "light", bench.window.actions(), bench.window.devices());
        QCOMPARE(page.findChild<QDoubleSpinBox*>("settings.speedCap")->text(), QStringLiteral("9.84 in/s"));
        QCOMPARE(page.preferences().speedCap, app::Preferences::kOrdinaryCap);
        PreflightPage preflight(doctor::patientAt("127.0.0.254", 0));
        QVERIFY(preflight.findChild<QLabel*>("safetyNote")->text().contains("1.97 in/s"));
        applyNotation(*qApp, {});
        QCOMPARE(page.findChild<QDoubleSpinBox*>("settings.speedCap")->text(), QStringLiteral("250 mm/s"));
        QVERIFY(preflight.findChild<QLabel*>("safetyNote")->text().contains("50 mm/s"));
        QVERIFY(recovery->findChild<QLabel*>("recoveryWhere")->text().contains("mm"));
    }
};

QTEST_MAIN(TestUnits)
#include "tst_units.moc"
