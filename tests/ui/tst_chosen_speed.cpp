// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selected TCP speed limits all hold-to-run motions: joint jogs, joint steps, Home, Align and Back. The
// speed of the simulated arm is measured in virtual time at the TCP and, for joint motions, at the elbow.

#include <QTest>
#include <deque>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/joint_rows.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr double kDeg = 3.14159265358979323846 / 180;
/// Averaging time [ms]. The speed of a single control period has a noise of 0.3 mm/s, also at standstill.
/// With averaging, the noise of the joint sensors is 0.2 mm/s at the tip of a stretched arm.
constexpr int kWindowMs = 100;
constexpr double kRelative = 1.005;
constexpr double kAbsolute = 2e-4;  // [m/s]

struct Posture {
    const char* name;
    JointPositions q;
};
const Posture kPostures[] = {
    {"bent", JointPositions(-90 * kDeg, -100 * kDeg, -110 * kDeg, -60 * kDeg, 90 * kDeg, 0)},
    {"stretched", JointPositions(20 * kDeg, -30 * kDeg, 25 * kDeg, 10 * kDeg, 80 * kDeg, 30 * kDeg)},
    {"folded", JointPositions(0, -90 * kDeg, 155 * kDeg, -57 * kDeg, 70 * kDeg, 0)},
};

}  // namespace

class TestChosenSpeed : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;
    double tcp_ = 0;    ///< maximum so far [m/s]
    double elbow_ = 0;  ///< maximum so far [m/s]

    VirtualCell& cell() { return bench_->cell; }
    HoldToRunButton& key(const QString& name) { return bench_->find<HoldToRunButton>(qPrintable(name)); }

    void bringUp(const JointPositions& q, int speedClass) {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.startJoints = q;
        bench_ = std::make_unique<WindowBench>(options);
        bench_->show();
        if (!cell().bringUp()) {
            qFatal("%s", qPrintable(cell().what()));
        }
        driveKeys(cell(), bench_->window.jogColumn().holdKeys(), &bench_->window.jogColumn().axisJog());
        bench_->window.jogColumn().selectors().setSpeedClass(speedClass);
        cell().advanceMs(40);
    }
    struct Place {
        Eigen::Vector3d tcp;
        Eigen::Vector3d elbow;
    };
    std::deque<Place> places_;  ///< one position per control period within the averaging time

    void measure() {
        const simulator::SimulatedState truth = cell().truth();
        const auto frames = kinematics::linkFrames(robotModel(RobotModelId::UR5e).dh, truth.q);
        places_.push_back({frames[6].translation(), frames[2].translation()});
        if (places_.size() > kWindowMs / 2) {
            constexpr double kSeconds = kWindowMs / 1000.0;
            tcp_ = std::max(tcp_, (places_.back().tcp - places_.front().tcp).norm() / kSeconds);
            elbow_ = std::max(elbow_, (places_.back().elbow - places_.front().elbow).norm() / kSeconds);
            places_.pop_front();
        }
    }
    /// Holds the button for this time, and measures until 400 ms after the release, when the arm has stopped.
    void hold(const QString& name, int ms) {
        tcp_ = elbow_ = 0;
        places_.clear();
        press(key(name));
        for (int t = 0; t < ms; t += 2) {
            cell().advanceMs(2);
            measure();
        }
        release(key(name));
        for (int t = 0; t < 400; t += 2) {
            cell().advanceMs(2);
            measure();
        }
    }
    static double chosen(int speedClass) { return speedClasses()[static_cast<std::size_t>(speedClass)].tcp; }
    bool isBelow(double speed, int speedClass) const {
        return speed <= chosen(speedClass) * kRelative + kAbsolute;
    }
    QString measured(const QString& what, int speedClass) const {
        return QStringLiteral("%1: chosen %2 mm/s, TCP %3, elbow %4")
            .arg(what)
            .arg(1e3 * chosen(speedClass))
            .arg(1e3 * tcp_, 0, 'f', 2)
            .arg(1e3 * elbow_, 0, 'f', 2);
    }
    static void addRows() {
        QTest::addColumn<JointPositions>("q");
        QTest::addColumn<int>("speedClass");
        for (const Posture& posture : kPostures) {
            for (int speedClass = 0; speedClass < kSpeedClassCount; ++speedClass) {
                QTest::addRow("%s, %g mm/s", posture.name, 1e3 * chosen(speedClass))
                    << posture.q << speedClass;
            }
        }
    }

private Q_SLOTS:
    void cleanup() { bench_.reset(); }

    void jointJogsKeepTheTcpBelowTheChosenSpeed_data() { addRows(); }
    void jointJogsKeepTheTcpBelowTheChosenSpeed() {
        QFETCH(JointPositions, q);
        QFETCH(int, speedClass);
        bringUp(q, speedClass);
        double fastest = 0;
        for (int joint = 0; joint < kJointCount; ++joint) {
            for (const char* direction : {"plus", "minus"}) {
                const QString name = QStringLiteral("joint.%1.%2").arg(joint).arg(QLatin1String(direction));
                hold(name, 500);
                QVERIFY2(isBelow(tcp_, speedClass) && isBelow(elbow_, speedClass),
                         qPrintable(measured(name, speedClass)));
                fastest = std::max({fastest, tcp_, elbow_});
            }
        }
        // The limit is reached, because base and shoulder cause the largest speeds of TCP and elbow.
        QVERIFY2(fastest > 0.95 * chosen(speedClass), qPrintable(QString::number(1e3 * fastest)));
    }

    void jointStepsKeepTheTcpBelowTheChosenSpeed_data() { addRows(); }
    void jointStepsKeepTheTcpBelowTheChosenSpeed() {
        QFETCH(JointPositions, q);
        QFETCH(int, speedClass);
        bringUp(q, speedClass);
        bench_->window.jogColumn().selectors().setFreeStep({0.01, 2 * kDeg});
        cell().advanceMs(40);
        for (int joint = 0; joint < kJointCount; ++joint) {
            const QString name = QStringLiteral("joint.%1.plus").arg(joint);
            hold(name, 600);
            // A short step continues to its end.
            cell().advanceUntil([this] { return !bench_->window.session().state().motionActive; }, 60'000);
            cell().advanceMs(100);
            QVERIFY2(isBelow(tcp_, speedClass) && isBelow(elbow_, speedClass),
                     qPrintable(measured(name, speedClass)));
        }
    }

    void goToKeysKeepTheTcpBelowTheChosenSpeed_data() { addRows(); }
    void goToKeysKeepTheTcpBelowTheChosenSpeed() {
        QFETCH(JointPositions, q);
        QFETCH(int, speedClass);
        bringUp(q, speedClass);
        for (const char* name : {"joint.0.plus", "joint.1.minus", "homeKey", "alignKey", "backKey"}) {
            const bool turns = QLatin1String(name) == QLatin1String("alignKey");
            hold(QString::fromLatin1(name), 1500);
            QVERIFY2(isBelow(tcp_, speedClass), qPrintable(measured(name, speedClass)));
            QVERIFY2(turns || isBelow(elbow_, speedClass), qPrintable(measured(name, speedClass)));
        }
    }

    void theRowsShowTheSpeedOfTheirKeys() {
        const JointPositions q = kPostures[1].q;
        bringUp(q, 0);
        for (const JointRow* row : bench_->window.findChildren<JointRow*>()) {
            const QString name = QStringLiteral("joint.%1.plus").arg(row->joint());
            const double shown = row->speedText().section(QLatin1Char(' '), 0, 0).toDouble() * kDeg;
            QVERIFY2(shown > 0, qPrintable(row->speedText()));
            double fastest = 0;
            press(key(name));
            for (int t = 0; t < 500; t += 2) {
                cell().advanceMs(2);
                fastest = std::max(fastest, std::abs(cell().truth().qd[row->joint()]));
            }
            release(key(name));
            QVERIFY(timeToStandstill(cell()) >= 0);
            QVERIFY2(
                std::abs(fastest - shown) < 0.05 * shown + 0.005 * kDeg,
                qPrintable(
                    QStringLiteral("%1 shown, %2 °/s measured").arg(row->speedText()).arg(fastest / kDeg)));
        }
    }
};

QTEST_MAIN(TestChosenSpeed)
#include "tst_chosen_speed.moc"
