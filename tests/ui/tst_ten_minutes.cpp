// SPDX-License-Identifier: GPL-3.0-or-later
//
// A recording while the window is in use (jogging, resizing, zooming, scrubbing), in real time at 500 Hz. The
// file must contain every packet in order. If the connection drops one packet in a hundred, the file must
// contain every gap with its length.
//
// TILLER_RECORD_SECONDS  duration of each row, 10 by default. Set it to 600 for the ten minutes in the name
// of the test. Qt Test limits a row to five minutes unless QTEST_FUNCTION_TIMEOUT [ms] is set.

#include <QDeadlineTimer>
#include <QDir>
#include <QFileInfo>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "app/main_window.h"
#include "resources/resources.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/simulator/simulator.h"
#include "tests/support/virtual_cell.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_view.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kWaitTimeoutMs = 120'000;
constexpr double kPeriod = 0.002;  // [s]
constexpr int kSeconds = 10;

simulator::SimulatorOptions inRealTime() {
    simulator::SimulatorOptions options = VirtualCell::options();
    options.time = simulator::Time::Real;
    return options;
}

struct Bench {
    QTemporaryDir folder;
    simulator::Simulator robot{inRealTime()};
    app::MainWindow window{app::Settings(folder.filePath("settings.ini"))};
    std::mt19937 random{19};
    int jogs = 0;

    ~Bench() { window.session().disconnectFromRobot(); }

    const SessionState& state() { return window.session().state(); }
    template <class Widget>
    Widget& find(const char* name) {
        return *window.findChild<Widget*>(QString::fromLatin1(name));
    }
    int between(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); }

    bool bringUp() {
        window.show();
        window.activateWindow();
        if (!robot.start().ok()) {
            return false;
        }
        window.session().connectTo({QStringLiteral("Simulated UR5e"), robot.listenAddress(), 0, true});
        if (!QTest::qWaitFor([this] { return state().link == LinkState::Live; }, kWaitTimeoutMs)) {
            return false;
        }
        window.session().takeControl();
        return QTest::qWaitFor([this] { return state().canMove(); }, kWaitTimeoutMs);
    }
    void jog() {
        auto& key = find<HoldToRunButton>(between(0, 1) == 0 ? "jog.X+" : "jog.X-");
        press(key);
        const bool moved = QTest::qWaitFor([this] { return state().moving; }, 400);
        jogs += moved ? 1 : 0;
        QTest::qWait(between(50, 300));
        release(key);
    }
    void resize() { window.resize(between(1280, 1920), between(720, 1080)); }
    void scrub() {
        auto& view = find<PlotView>("plots.view");
        QWidget* const viewport = view.viewport();
        const QPoint at(between(100, std::max(101, viewport->width() - 60)), 60);
        switch (between(0, 3)) {
            case 0: {
                QWheelEvent event(at, viewport->mapToGlobal(at), {}, {0, 120 * between(-4, 4)}, Qt::NoButton,
                                  Qt::NoModifier, Qt::NoScrollPhase, false);
                QApplication::sendEvent(viewport, &event);
                break;
            }
            case 1:
                QTest::mousePress(viewport, Qt::MiddleButton, {}, at);
                QTest::mouseMove(viewport, at + QPoint(between(20, 300), 0));
                QTest::mouseRelease(viewport, Qt::MiddleButton, {}, at);
                break;
            case 2:  // moves cursor A; view, inputs and log follow
                QTest::mouseClick(viewport, Qt::LeftButton, {}, at);
                break;
            default:
                view.setFocus();
                QTest::keyClick(&view, between(0, 1) == 0 ? Qt::Key_F : Qt::Key_End);
                break;
        }
    }
};

}  // namespace

class TestTenMinutes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void everyPacketIsInTheFile_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<double>("drop");  // [%]
        QTest::newRow("mcap, a sound link") << "mcap" << 0.0;
        QTest::newRow("mcap, one packet in a hundred dropped") << "mcap" << 1.0;
        QTest::newRow("csv, one packet in a hundred dropped") << "csv" << 1.0;
    }
    void everyPacketIsInTheFile() {
        QFETCH(QString, format);
        QFETCH(double, drop);
        bool given = false;
        const int asked = qEnvironmentVariableIntValue("TILLER_RECORD_SECONDS", &given);
        const double seconds = given && asked > 0 ? asked : kSeconds;
        const QString path = QStringLiteral("all.") + format;
        QString file;
        double recorded = 0;  // robot time [s]
        std::uint64_t reported = 0;
        {
            Bench bench;
            QVERIFY2(bench.bringUp(), qPrintable(bench.state().linkReason + bench.state().controlReason));
            file = bench.folder.filePath(path);
            bench.folder.setAutoRemove(false);
            bench.find<PlotDock>("plots").setRecordingChoice(
                {.folder = bench.folder.path(), .pattern = "all", .format = format});
            QVERIFY(bench.robot.inject(QStringLiteral("drop %1").arg(drop)).ok());
            auto& key = bench.find<QToolButton>("plots.record");
            QTest::mouseClick(&key, Qt::LeftButton);
            QVERIFY(QTest::qWaitFor([&] { return bench.state().recording.rows > 0; }, kWaitTimeoutMs));
            const double begin = bench.state().robotTime;
            // A busy machine may refuse the first jogs because of late data. In this case, the recording
            // takes longer.
            const QDeadlineTimer hangs(kWaitTimeoutMs);
            while (recorded < seconds || (bench.jogs == 0 && !hangs.hasExpired())) {
                QVERIFY2(bench.state().recording.active, qPrintable(bench.state().recording.error));
                bench.jog();
                bench.resize();
                bench.scrub();
                QTest::qWait(bench.between(1, 60));
                recorded = bench.state().robotTime - begin;
            }
            QVERIFY2(bench.jogs > 0, "the arm was not jogged during the recording");
            QTest::mouseClick(&key, Qt::LeftButton);
            QVERIFY(QTest::qWaitFor([&] { return !bench.state().recording.active; }, kWaitTimeoutMs));
            QVERIFY2(bench.state().recording.error.isEmpty(), qPrintable(bench.state().recording.error));
            reported = bench.state().recording.lost;
            qInfo("%.1f s recorded, %d jogs", recorded, bench.jogs);
        }
        const auto remove = qScopeGuard([&] { QDir(QFileInfo(file).path()).removeRecursively(); });

        const auto opened = recording::openRecording(file);
        QVERIFY2(opened.ok(), qPrintable(opened.error().toString()));
        const recording::Recording& all = **opened;
        QVERIFY2(all.problems().isEmpty(), qPrintable(all.problems().join('\n')));
        const std::vector<double> stamps =
            all.read(std::vector{all.indexOf("timestamp").value()}, {0, all.rows()}).value().front();
        std::map<std::uint64_t, std::uint64_t> gaps;  // number of missing packets before a row
        for (const recording::RecordedGap& gap : all.gaps()) {
            gaps[gap.row] = gap.packets;
        }
        std::uint64_t missing = 0;
        std::uint64_t marked = 0;
        for (std::size_t row = 1; row < stamps.size(); ++row) {
            // Compute the number of packets from the controller's clock, which advances by one period per
            // packet.
            const auto packets = std::llround((stamps[row] - stamps[row - 1]) / kPeriod);
            QVERIFY2(packets >= 1, qPrintable(QStringLiteral("row %1 is out of order").arg(row)));
            const auto lost = static_cast<std::uint64_t>(packets - 1);
            QCOMPARE(gaps.contains(row) ? gaps[row] : 0, lost);
            missing += lost;
            marked += lost > 0 ? 1 : 0;
        }
        QVERIFY(stamps.back() - stamps.front() >= recorded - 1);
        QCOMPARE(reported, missing);
        QCOMPARE(gaps.size(), static_cast<std::size_t>(marked));
        const double share = static_cast<double>(missing) / static_cast<double>(stamps.size() + missing);
        qInfo("%zu rows, %.1f s, %llu packets missing (%.2f %%) in %zu gaps", stamps.size(),
              stamps.back() - stamps.front(), static_cast<unsigned long long>(missing), share * 100,
              gaps.size());
        if (drop == 0) {
            QCOMPARE(missing, std::uint64_t{0});
        } else {
            QVERIFY(share > 0.3 * drop / 100 && share < 3 * drop / 100);
        }
    }
};

QTEST_MAIN(TestTenMinutes)
#include "tst_ten_minutes.moc"
