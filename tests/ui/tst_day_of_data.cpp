// SPDX-License-Identifier: GPL-3.0-or-later
//
// A day of data through all components that store data: plots, stop records and the log. All of them have a
// limit, so the memory in use at the end of the day equals that of the morning. The test needs no robot and
// little time, because it generates the samples itself.

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/main_window.h"
#include "resources/resources.h"
#include "tests/support/sample_stream.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kDay = 24 * 3600;     // [s]
constexpr int kMorning = 8 * 3600;  // all components have their final size at this time [s]
constexpr double kGrowth = 1.05;
/// Sample rate [Hz]. The default fills every history by the morning. TILLER_SAMPLE_RATE=500 selects the real
/// rate.
constexpr int kRate = 50;

/// Resident memory of this process [MB].
double residentMb() {
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly)) {
        return 0;
    }
    for (const QByteArray& line : status.readAll().split('\n')) {
        if (line.startsWith("VmRSS:")) {
            return line.simplified().split(' ').value(1).toDouble() / 1024;
        }
    }
    return 0;
}

}  // namespace

class TestDayOfData : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void memoryUseStaysConstantOverADay() {
        if (residentMb() == 0) {
            QSKIP("this system does not report the memory usage of a process");
        }
        bool given = false;
        const int asked = qEnvironmentVariableIntValue("TILLER_SAMPLE_RATE", &given);
        const int rate = given && asked > 0 ? asked : kRate;
        const QTemporaryDir folder;
        app::MainWindow window{app::Settings(folder.filePath("settings.ini"))};
        window.resize(1920, 1080);
        RobotSession& session = window.session();
        Q_EMIT session.linkBegan();
        SampleStream stream;
        stream.layout = std::make_shared<const receive::SampleLayout>(std::vector<std::string>{
            "timestamp", "actual_q", "actual_TCP_force", "actual_current", "target_current",
            "actual_TCP_speed", "robot_mode", "safety_mode", "standard_analog_input0"});
        SessionState state;
        state.link = LinkState::Live;
        state.robotMode = RobotMode::Running;
        state.safetyMode = SafetyMode::Normal;
        std::uint64_t sequence = 0;
        double atStart = residentMb();
        double inTheMorning = 0;
        for (int second = 0; second < kDay; ++second) {
            for (int i = 0; i < rate; ++i) {
                const double time = second + static_cast<double>(i) / rate;
                receive::Sample& sample = stream.add(time, ++sequence);
                stream.set(sample, "actual_TCP_force_2", 5 * std::sin(time));
                stream.set(sample, "actual_current_1", std::cos(time));
                stream.set(sample, "safety_mode", static_cast<double>(SafetyMode::Normal));
            }
            stream.frame([&](const SampleBatch& batch) { Q_EMIT session.samplesReceived(batch); });
            state.sequence = sequence;
            state.robotTime = second;
            state.q[0] = std::sin(second * 0.01);
            Q_EMIT session.stateChanged(state);
            if (second % 10 == 0) {
                session.journal().add(Severity::Info, QStringLiteral("It is %1 s now").arg(second));
            }
            if (second % 600 == 0) {
                QCoreApplication::processEvents();
            }
            if (second == kMorning) {
                inTheMorning = residentMb();
            }
        }
        const double inTheEvening = residentMb();
        const QString figures = QStringLiteral("%1 MB at the start, %2 MB after 8 h, %3 MB after 24 h")
                                    .arg(atStart, 0, 'f', 0)
                                    .arg(inTheMorning, 0, 'f', 0)
                                    .arg(inTheEvening, 0, 'f', 0);
        qInfo("%s", qPrintable(figures));
        QVERIFY2(inTheEvening <= inTheMorning * kGrowth, qPrintable(figures));
    }
};

QTEST_MAIN(TestDayOfData)
#include "tst_day_of_data.moc"
