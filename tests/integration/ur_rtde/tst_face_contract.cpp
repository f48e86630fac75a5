// SPDX-License-Identifier: MIT
// The stop contract of the ur_rtde interface: every way of moving the arm, in a process of its own that does
// not look at what calls return, and everything that must end it. The arm stands within 250 ms of the robot's
// own time, and nothing but a new command moves it again. Where the process itself is killed or stopped, or
// the cable cut, in real time; otherwise in virtual time.
//
//     tst_face_contract --assume NAME=VALUE    with another reading of what a real controller does
//     tst_face_contract --all                  with each of them, one after the other
#include <ur_rtde/dashboard_client.h>

#include <QProcess>
#include <QTest>
#include <csignal>

#include "robot/rtde/connection.h"
#include "tests/integration/ur_rtde/face_cell.h"

using namespace tiller;

namespace {

constexpr double kContractMs = 250;
constexpr double kLooksOnFor = 0.6;  // [s] of the robot, in which nothing may move again

/// What the robot tells everybody, package by package.
class Watcher {
public:
    explicit Watcher(const simulator::Controller& robot) {
        rtde::ConnectionOptions options;
        options.host = robot.listenAddress();
        options.request.outputs = {"timestamp", "actual_TCP_speed", "actual_qd", "output_int_register_0"};
        auto opened = rtde::Connection::open(options, Deadline::after(std::chrono::seconds(20)));
        if (!opened) {
            qFatal("%s", qPrintable(opened.error().toString()));
        }
        connection_ = std::move(*opened);
        values_.resize(connection_->outputs().size());
    }

    bool look() {
        if (connection_->readPackage(values_, std::chrono::seconds(20)) != rtde::Connection::Read::Package) {
            return false;
        }
        time = values_[0];
        speed = Eigen::Vector3d(values_[1], values_[2], values_[3]).norm();
        const auto turning = std::minmax_element(values_.begin() + 7, values_.begin() + 13);
        stands = speed < 0.001 && std::max(-*turning.first, *turning.second) < 0.002;
        lastMoved = stands ? lastMoved : time;
        if (values_[13] != heard_) {
            heard_ = values_[13];
            heardAt = time;
        }
        return true;
    }
    /// Looks on until then [s].
    bool lookUntil(double end) {
        while (time < end) {
            if (!look()) {
                return false;
            }
        }
        return true;
    }

    double time = 0;   ///< of the robot [s]
    double speed = 0;  ///< of the TCP [m/s]
    bool stands = true;
    double lastMoved = 0;  ///< [s]
    double heardAt = 0;    ///< when the control program last heard of its client [s]

private:
    std::unique_ptr<rtde::Connection> connection_;
    std::vector<double> values_;
    double heard_ = 0;
};

/// The process that moves the arm.
class Mover {
public:
    Mover(const std::string& host, const QString& way) {
        process_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process_.start(QStringLiteral(FACE_MOVER), {QString::fromStdString(host), way});
    }
    ~Mover() {
        if (process_.state() != QProcess::NotRunning) {
            signal(SIGCONT);
            process_.closeWriteChannel();
            if (!process_.waitForFinished(20'000)) {
                process_.kill();
                process_.waitForFinished(20'000);
            }
        }
    }
    bool hasBegun() {
        process_.waitForReadyRead(1);
        return process_.readAll().contains("moving");
    }
    /// Tells it what to do. Time may have to go on until it is done.
    void tell(const char* line) {
        process_.write(QByteArray(line) + "\n"), process_.waitForBytesWritten(20'000);
    }
    bool isDone() {
        process_.waitForReadyRead(1);
        return process_.readAll().contains("done");
    }
    void signal(int number) const { ::kill(static_cast<pid_t>(process_.processId()), number); }
    void kill() {
        process_.kill();
        process_.waitForFinished(20'000);
    }
    bool isRunning() const { return process_.state() != QProcess::NotRunning; }  // or just starting

private:
    QProcess process_;
};

struct Way {
    const char* name;
    double fast;    ///< the speed of the TCP at which it is ended [m/s]
    bool hand;      ///< somebody pushes
    bool finishes;  ///< a deliberate disconnect leaves it alone
};

constexpr Way kWays[] = {
    {"moveJ", 0.05, false, true},
    {"moveJ_IK", 0.03, false, true},
    {"moveL", 0.05, false, true},
    {"moveL_FK", 0.05, false, true},
    {"path", 0.05, false, true},
    {"speedJ", 0.05, false, false},
    {"speedJ once", 0.05, false, false},
    {"speedL", 0.05, false, false},
    {"servoJ", 0.05, false, false},
    {"servoL", 0.04, false, false},
    {"servoC", 0.05, false, false},
    {"jog", 0.05, false, false},
    {"jog in the tool's frame", 0.05, false, false},
    {"move until contact", 0.05, false, false},
    {"force mode", 0.02, false, false},
    // The hand goes on pushing: an arm that stands has left freedrive.
    {"freedrive", 0.03, true, false},
    {"teach mode", 0.03, true, false},
};

constexpr const char* kEnds[] = {"release",        "disconnect",  "kill -9",        "SIGSTOP",
                                 "cut cable",      "silent link", "debugger pause", "protective stop",
                                 "safeguard stop", "pause"};

// Servo targets of the mover follow its own clock.
bool isInRealTime(const QByteArray& end, const QByteArray& way) {
    return end == "kill -9" || end == "SIGSTOP" || end == "cut cable" || end == "debugger pause" ||
           way == "servoJ" || way == "servoL";
}

QStringList assumed;  ///< for every row
bool runsAll = false;

simulator::Assumptions assumptionsOf(const QString& more) {
    simulator::Assumptions assumptions;
    QStringList words = assumed;
    if (!more.isEmpty()) {
        words.append(more);
    }
    for (const QString& word : words) {
        if (const auto taken = simulator::assume(assumptions, word); !taken) {
            qFatal("%s", qPrintable(taken.error().toString()));
        }
    }
    return assumptions;
}

}  // namespace

class TestFaceContract : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whateverEndsItTheArmStands_data() {
        QTest::addColumn<int>("way");
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<QString>("assumption");
        QStringList assumptions{QString()};
        for (const auto& info : simulator::assumptionTable()) {
            for (const QString& reading : runsAll ? info.readings.mid(1) : QStringList()) {
                assumptions.append(info.name + '=' + reading);
            }
        }
        for (const QString& assumption : assumptions) {
            for (const char* end : kEnds) {
                for (int way = 0; way < static_cast<int>(std::size(kWays)); ++way) {
                    const QString name = QStringLiteral("%1, %2").arg(QLatin1String(end), kWays[way].name);
                    QTest::newRow(qPrintable(assumption.isEmpty() ? name : assumption + ", " + name))
                        << way << QByteArray(end) << assumption;
                }
            }
        }
    }
    void whateverEndsItTheArmStands() {
        QFETCH(int, way);
        QFETCH(QByteArray, end);
        QFETCH(QString, assumption);
        const Way& moving = kWays[way];
        test::FaceCell cell([&](simulator::ControllerOptions& options) {
            options.time = isInRealTime(end, moving.name) ? simulator::Time::Real : simulator::Time::Virtual;
            options.assumptions = assumptionsOf(assumption);
            options.startJoints = JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        });
        Watcher watcher(cell.robot);
        QVERIFY(watcher.look());
        Mover mover(cell.host(), QString::fromLatin1(moving.name));
        while (!mover.hasBegun()) {
            QVERIFY(mover.isRunning());
            QVERIFY(watcher.look());
        }
        const double begin = watcher.time;
        constexpr double kPatience = 60;  // [s] of robot time
        while (watcher.speed < moving.fast) {
            QVERIFY(watcher.look());
            QVERIFY2(watcher.time - begin < kPatience, "the arm never moved");
            // Not before: who is pushed when freedrive begins gets a protective stop.
            if (moving.hand && watcher.time > begin + 0.2) {
                cell.robot.pressHand({{0, 0, 12}, {0, 0, 0}});
            }
        }
        ur_rtde::DashboardClient pendant(cell.host());
        pendant.connect();

        const double endedAt = cell.robot.truth().timestamp;
        const auto during = [&](const std::function<bool()>& isOver) {
            while (!isOver()) {
                QVERIFY(watcher.look());
            }
        };
        if (end == "release" || end == "disconnect") {
            mover.tell(end.constData());
            during([&] { return mover.isDone(); });
        } else if (end == "kill -9") {
            mover.kill();
        } else if (end == "SIGSTOP" || end == "debugger pause") {
            mover.signal(SIGSTOP);
        } else if (end == "cut cable") {
            QVERIFY(cell.robot.inject("link lost").ok());
        } else if (end == "silent link") {
            cell.robot.silence(true);
        } else if (end == "protective stop") {
            cell.robot.protectiveStop();
        } else if (end == "safeguard stop") {
            cell.robot.safeguardStop(true);
        } else if (end == "pause") {
            pendant.pause();
        }
        if (end == "disconnect" && moving.finishes) {
            QVERIFY(watcher.lookUntil(endedAt + 0.5));
            QVERIFY2(!watcher.stands, "a move is left to come to its end");
            cell.robot.pressHand({});
            return;
        }
        if (end == "cut cable" || end == "silent link") {
            // Nobody hears the robot either: it is asked how it went.
            const bool stood = cell.until([&](const simulator::Truth& truth) {
                return truth.qd.values.cwiseAbs().maxCoeff() < 2e-3 || truth.timestamp > endedAt + 2;
            });
            const double stoodAt = cell.robot.truth().timestamp;
            const double ms = (stoodAt - endedAt) * 1000;
            qInfo("%s: %.0f ms", QTest::currentDataTag(), ms);
            QVERIFY(stood);
            // Looked at from outside the robot's thread, a period or so late.
            QVERIFY2(ms <= kContractMs, qPrintable(QString::number(ms)));
            QVERIFY(cell.pass(0.3));
            if (end == "cut cable") {
                QVERIFY(cell.robot.inject("link back").ok());
            } else {
                cell.robot.silence(false);
            }
            const auto q = cell.robot.truth().q;
            QVERIFY(cell.pass(kLooksOnFor));
            QVERIFY((cell.robot.truth().q.values - q.values).norm() < 1e-3);
            cell.robot.pressHand({});
            return;
        }
        QVERIFY(watcher.lookUntil(endedAt + 0.7));
        // On a busy machine a signal may take its time: what counts then is the last the robot heard.
        const bool isSilent = end == "kill -9" || end == "SIGSTOP" || end == "debugger pause";
        const double from = isSilent ? std::max(endedAt, std::min(watcher.heardAt, endedAt + 0.5)) : endedAt;
        const double ms = (watcher.lastMoved - from) * 1000;
        qInfo("%s: %.0f ms", QTest::currentDataTag(), ms);
        QVERIFY(watcher.stands);
        if (end != "release") {  // a release brakes as gently as it is told
            QVERIFY2(ms <= kContractMs, qPrintable(QString::number(ms)));
        }

        // And nothing of it comes back.
        if (end == "debugger pause") {
            mover.signal(SIGCONT);
        } else if (end == "protective stop") {
            QVERIFY(cell.pass(6));
            pendant.unlockProtectiveStop();
        } else if (end == "safeguard stop") {
            cell.robot.safeguardStop(false);
        } else if (end == "pause") {
            QVERIFY(cell.pass(0.2));
            pendant.play();
        }
        QVERIFY(watcher.look());
        const double back = cell.robot.truth().timestamp;
        QVERIFY(watcher.lookUntil(back));
        const double before = watcher.lastMoved;
        QVERIFY(watcher.lookUntil(back + kLooksOnFor));
        cell.robot.pressHand({});
        QVERIFY2(watcher.lastMoved == before,
                 qPrintable(QStringLiteral("it moved again, %1 s later").arg(watcher.lastMoved - back)));
    }
};

int main(int argc, char** argv) {
    std::vector<char*> rest;
    for (int i = 0; i < argc; ++i) {
        if (qstrcmp(argv[i], "--all") == 0) {
            runsAll = true;
        } else if (qstrcmp(argv[i], "--assume") == 0 && i + 1 < argc) {
            assumed.append(QString::fromLocal8Bit(argv[++i]));
        } else {
            rest.push_back(argv[i]);
        }
    }
    int count = static_cast<int>(rest.size());
    QCoreApplication app(count, rest.data());
    TestFaceContract test;
    return QTest::qExec(&test, count, rest.data());
}
#include "tst_face_contract.moc"
