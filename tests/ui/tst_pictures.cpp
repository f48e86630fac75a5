// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates screenshots for review, for the README and for the manual (packaging/manual/make_pictures): every
// arm in two poses, every tab, teaching of a pattern and of actions, and every part of the window. They are
// written to the folder TILLER_PICTURES. Without this variable, the test does nothing.

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "app/action_table.h"
#include "resources/resources.h"
#include "robot/core/robot_model.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_view.h"
#include "widgets/status/preflight_page.h"
#include "widgets/waypoints/waypoint_dialogs.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kPageWidth = 720;  // width of the manual in the help window [px]
constexpr double kRight = 1.5707963267948966;
struct Stance {
    const char* name;
    JointPositions q;
};
const Stance kStances[] = {{"working", {-0.5, -1.9, -1.9, -0.9, kRight, 0}},
                           {"reaching", {0.7, -0.9, -0.7, -1.5, kRight, 0.4}}};

}  // namespace

class TestPictures : public QObject {
    Q_OBJECT

private:
    QDir folder_;
    std::unique_ptr<WindowBench> bench_;

    app::MainWindow& window() { return bench_->window; }
    void keep(QWidget& widget, const QString& name) { keep(widget.grab().toImage(), name); }
    /// Saves an image. Fails if nothing was drawn, i.e. if the image has a single colour.
    void keep(const QImage& image, const QString& name) {
        const QRgb first = image.pixel(0, 0);
        bool drawn = false;
        for (int y = 0; y < image.height() && !drawn; y += 3) {
            for (int x = 0; x < image.width() && !drawn; x += 3) {
                drawn = image.pixel(x, y) != first;
            }
        }
        QVERIFY2(drawn, qPrintable(name));
        QVERIFY2(image.save(folder_.filePath(name + QStringLiteral(".png"))), qPrintable(name));
    }
    /// Saves the window in both themes and both standard sizes.
    void keepWindow(const QString& name) {
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
            window().resize(size);
            for (const char* theme : {"dark", "light"}) {
                window().setTheme(QLatin1String(theme));
                bench_->cell.advanceMs(200);
                QTest::qWait(50);
                keep(window(),
                     QStringLiteral("%1-%2-%3").arg(name).arg(size.width()).arg(QLatin1String(theme)));
            }
        }
    }
    /// Saves an image for the manual. An image that is wider than a page is scaled down.
    void keepForManual(const QImage& image, const char* name) {
        keep(image.width() > kPageWidth ? image.scaledToWidth(kPageWidth, Qt::SmoothTransformation) : image,
             QStringLiteral("manual-") + QLatin1String(name));
    }
    void keepForManual(QWidget& widget, const char* name) { keepForManual(widget.grab().toImage(), name); }
    /// Splits a line that is wider than a page into two rows.
    static QImage inTwoRows(const QImage& line) {
        const int half = (line.width() + 1) / 2;
        QImage rows(half, 2 * line.height() + 8, QImage::Format_RGB32);
        rows.fill(Qt::white);
        QPainter painter(&rows);
        painter.drawImage(0, 0, line, 0, 0, half);
        painter.drawImage(0, line.height() + 8, line, half, 0, half);
        return rows;
    }
    void jog(const char* key, int ms) {
        auto& button = bench_->find<HoldToRunButton>(key);
        driveKeys(bench_->cell, {&button});
        press(button);
        bench_->cell.advanceMs(ms);
        release(button);
        bench_->cell.advanceMs(400);
    }
    /// Triggers the command and returns the dialog that it opens, after its layout.
    QDialog& opened(const char* id, const char* name) {
        window().actions().find(QLatin1String(id))->trigger();
        QTest::qWait(100);
        bench_->cell.advanceMs(100);
        auto* dialog = window().findChild<QDialog*>(QLatin1String(name));
        if (dialog == nullptr) {
            qFatal("%s opens no %s", id, name);
        }
        return *dialog;
    }
    void selectRows(const QList<int>& rows) {
        auto* table = window().findChild<QAbstractItemView*>("waypoint.table");
        for (const int row : rows) {
            table->selectionModel()->select(
                table->model()->index(row, 0),
                QItemSelectionModel::Rows | (row == rows.first() ? QItemSelectionModel::ClearAndSelect
                                                                 : QItemSelectionModel::Select));
        }
    }
    void teachTray() {
        const SessionState& state = window().session().state();
        const RobotModel& model = robotModel(state.model);
        std::vector<project::Waypoint> points;
        const struct {
            const char* name;
            double x;
            double y;
            double z;
        } places[] = {{"tray, first place", -0.45, -0.25, 0.2},
                      {"tray, end of row", -0.45, -0.05, 0.2},
                      {"tray, last row", -0.30, -0.25, 0.2},
                      {"above the tray", -0.38, -0.15, 0.35},
                      {"drop", -0.2, -0.42, 0.25}};
        for (const auto& place : places) {
            project::Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QString::fromLatin1(place.name);
            const Pose pose(place.x, place.y, place.z, 2 * kRight, 0, 0);
            const auto q = kinematics::inverseNearest(model.dh, pose, state.tcpOffset, state.q);
            QVERIFY(q.has_value());
            points.push_back(
                *project::taughtAt(point, *q, pose, state.tcpOffset, window().document().frames()));
        }
        project::WaypointAction close;
        close.kind = project::WaypointAction::Kind::CloseGripper;
        project::WaypointAction part;
        part.kind = project::WaypointAction::Kind::WaitForInput;
        part.pin = 2;
        part.seconds = 10;
        project::WaypointAction lamp;
        lamp.kind = project::WaypointAction::Kind::SetOutput;
        lamp.pin = 3;
        points[4].actions = {part, close, lamp};
        window().document().insertWaypoints(0, points, "taught");
    }
    /// Runs `use` while the dialog with this name is open; the dialog has its own event loop.
    void inDialog(const char* name, const std::function<void()>& open,
                  const std::function<void(QDialog&)>& use) {
        bool used = false;
        QTimer::singleShot(200, &window(), [&] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
                used = dialog->objectName() == QLatin1String(name);
                use(*dialog);
                dialog->reject();
            }
        });
        open();
        QVERIFY2(used, name);
    }

private Q_SLOTS:
    void initTestCase() {
        const QString folder = qEnvironmentVariable("TILLER_PICTURES");
        if (folder.isEmpty()) {
            QSKIP("TILLER_PICTURES is not set to a folder");
        }
        folder_ = QDir(folder);
        QVERIFY2(folder_.mkpath(QStringLiteral(".")), qPrintable(folder));
        initResources();
    }

    void everyArmIsDrawnInTwoPoses() {
        for (const bool dark : {false, true}) {
            applyTheme(*qApp, dark ? Theme::dark() : Theme::light());
            for (const RobotModel& model : robotModels()) {
                for (const Stance& stance : kStances) {
                    SceneView view;
                    view.resize(960, 720);
                    view.setModel(model);
                    view.setTcpOffset(Pose(0, 0, 0.12, 0, 0, 0));
                    view.setSurroundings({.around = {}, .unplaced = {}, .toolRadius = 0.03});
                    view.setJoints(stance.q);
                    view.setStale(false);
                    keep(view, QStringLiteral("arm-%1-%2-%3")
                                   .arg(QString::fromLatin1(model.name).toLower(), QLatin1String(stance.name),
                                        dark ? QStringLiteral("dark") : QStringLiteral("light")));
                }
            }
        }
    }

    void everyTabAndThePatternDialogAreDrawn() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show(QSize(1280, 720));
        QVERIFY2(bench_->cell.bringUp(), qPrintable(bench_->cell.what()));
        bench_->cell.advanceMs(200);
        teachTray();
        for (const char* tab : {"waypoints", "program", "frames", "tools", "io", "gripper", "log"}) {
            window().showTab(QLatin1String(tab));
            keepWindow(QStringLiteral("tab-%1").arg(QLatin1String(tab)));
        }
        window().showTab("waypoints");
        selectRows({0, 1, 2});
        inDialog(
            "pattern", [this] { window().waypoints().dialogs().pattern(); },
            [this](QDialog& dialog) { keep(dialog, QStringLiteral("pattern")); });
        window().waypoints().selectRow(4);
        inDialog(
            "waypoint.actions", [this] { window().waypoints().dialogs().actions(); },
            [this](QDialog& dialog) { keep(dialog, QStringLiteral("actions")); });
        window().waypoints().touchUp();
        bench_->cell.advanceMs(100);
        keepWindow(QStringLiteral("touch-up"));
        bench_.reset();
    }

    void everyManualPictureIsDrawn() {
        applyTheme(*qApp, Theme::light());
        bench_ = std::make_unique<WindowBench>();
        bench_->show(QSize(1280, 720));
        keepForManual(opened("robot.connect", "connectDialog"), "connect");
        window().findChild<QDialog*>("connectDialog")->close();
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QVERIFY2(bench_->cell.bringUp(), qPrintable(bench_->cell.what()));
        bench_->cell.advanceMs(200);
        teachTray();
        window().actions().find("plots.action.span.10")->trigger();
        for (const char* key : {"jog.Z+", "jog.Y-", "jog.Z-", "jog.Rz+"}) {
            jog(key, 1500);
        }
        window().waypoints().selectRow(3);
        bench_->cell.advanceMs(200);
        keepForManual(window(), "window");
        keepForManual(inTwoRows(bench_->find<QWidget>("headerBar").grab().toImage()), "header");
        keepForManual(bench_->find<QWidget>("jogColumn"), "jog");
        // The images of single panels may be larger.
        window().resize(1560, 980);
        bench_->cell.advanceMs(200);
        QTest::qWait(100);
        keepForManual(bench_->find<QWidget>("viewDock"), "view");
        window().showTab("tools");
        bench_->find<QPushButton>("tcp.fromRobot").click();
        for (const char* tab : {"waypoints", "tools", "io", "log"}) {
            window().showTab(QLatin1String(tab));
            bench_->cell.advanceMs(200);
            keepForManual(bench_->find<QWidget>("tabsDock"), tab);
        }
        window().showTab("frames");
        window().actions().find("frame.action.threePoints")->trigger();
        bench_->cell.advanceMs(200);
        keepForManual(bench_->find<QWidget>("tabsDock"), "frames");
        window().showTab("waypoints");
        selectRows({0, 1, 2});
        inDialog(
            "pattern", [this] { window().waypoints().dialogs().pattern(); },
            [this](QDialog& dialog) { keepForManual(dialog, "pattern"); });
        window().waypoints().selectRow(4);
        inDialog(
            "waypoint.actions", [this] { window().waypoints().dialogs().actions(); },
            [this](QDialog& dialog) { keepForManual(dialog, "actions"); });

        QDialog& palette = opened("app.palette", "commandPalette");
        QTest::keyClicks(palette.findChild<QLineEdit*>("paletteWords"), "wayp");
        keepForManual(palette, "commands");
        palette.close();
        QDialog& settings = opened("app.settings", "settingsPage");
        settings.resize(kPageWidth, 600);
        QTest::qWait(50);
        keepForManual(settings, "settings");
        settings.close();
        auto& plots = bench_->find<QDockWidget>("plotsDock");
        plots.setFloating(true);
        plots.resize(kPageWidth, 420);
        bench_->cell.advanceMs(300);
        QTest::qWait(50);
        keepForManual(bench_->find<QWidget>("plots"), "plots");
        plots.setFloating(false);

        bench_->cell.robot.protectiveStop();
        bench_->cell.advanceMs(6000);
        keepForManual(opened("power.recover", "recoveryPage"), "recovery");
        window().findChild<QDialog*>("recoveryPage")->close();
        window().showPreflight({QStringLiteral("UR5e"), QStringLiteral("127.0.0.254"), 0, false});
        auto* checks = window().findChild<PreflightPage*>();
        QTRY_VERIFY_WITH_TIMEOUT(checks->isFinished(), 60'000);
        QTest::qWait(200);
        checks->resize(kPageWidth, checks->height());
        QTest::qWait(50);
        keepForManual(*checks, "preflight");
        checks->close();
        bench_.reset();
    }
};

QTEST_MAIN(TestPictures)
#include "tst_pictures.moc"
