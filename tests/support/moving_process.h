// SPDX-License-Identifier: MIT
#pragma once

// For tests that end the process that moves the arm. Provides this process, and observes the arm with another
// client. All times are robot times, so that a slow computer does not look like a slow stop.

#include <QProcess>
#include <QTest>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "robot/control/detail/registers.h"
#include "robot/rtde/connection.h"
#include "robot/simulator/simulator.h"
#include "tests/support/suspended_process.h"

namespace tiller::test {

/// RTDE data of the robot, package by package.
class ArmWatcher {
public:
    /// registers  register range used by the moving process
    ArmWatcher(const simulator::Simulator& robot, control::RegisterRange registers) {
        rtde::ConnectionOptions options;
        options.host = robot.listenAddress();
        options.port = robot.ports().rtde;
        const int first = control::firstRegister(registers);
        const auto echo = [first](int at) { return "output_int_register_" + std::to_string(first + at); };
        options.request.outputs = {"timestamp", "actual_TCP_speed", "actual_qd", echo(0),
                                   echo(2),     "actual_TCP_pose"};
        auto opened = rtde::Connection::open(options, Deadline::after(kTestTimeout));
        if (!opened) {
            qFatal("%s", qPrintable(opened.error().toString()));
        }
        connection_ = std::move(*opened);
        values_.resize(connection_->outputs().size());
    }

    /// Reads the next package. Returns false if none arrived.
    bool look() {
        if (connection_->readPackage(values_, kTestTimeout) != rtde::Connection::Read::Package) {
            return false;
        }
        time = values_[0];
        speed = Eigen::Vector3d(values_[1], values_[2], values_[3]).norm();
        const auto turning = std::minmax_element(values_.begin() + 7, values_.begin() + 13);
        stands = speed < 0.001 && std::max(-*turning.first, *turning.second) < 0.002;
        lastMoved = stands ? lastMoved : time;
        position = {values_[15], values_[16], values_[17]};
        // A negative value is the time without a client since the last state.
        if (values_[14] >= 0) {
            state = static_cast<control::ScriptState>(static_cast<std::int32_t>(values_[14]));
        }
        if (values_[13] != heard_) {
            heard_ = values_[13];
            heardAt = time;
            heardIn = state;
        }
        return true;
    }
    /// Reads packages until this time [s].
    bool lookUntil(double end) {
        while (time < end) {
            if (!look()) {
                return false;
            }
        }
        return true;
    }

    double time = 0;                                     ///< robot time [s]
    double speed = 0;                                    ///< of the TCP [m/s]
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the TCP [m]
    bool stands = true;
    double lastMoved = 0;  ///< robot time of the last package with motion [s]
    double heardAt = 0;    ///< robot time of the last heartbeat that the control program received [s]
    control::ScriptState state = control::ScriptState::Ready;
    control::ScriptState heardIn = control::ScriptState::Ready;  ///< state of the script at `heardAt`

private:
    static constexpr std::chrono::seconds kTestTimeout{20};
    std::unique_ptr<rtde::Connection> connection_;
    std::vector<double> values_;
    double heard_ = 0;
};

/// For use without any data connection. Observes the robot itself until the time `until` [s]. Returns how
/// long the arm moved after `since` or after the last package that the robot received, whichever is later
/// [s].
inline double movesOn(const simulator::Simulator& robot, double since, double until) {
    double moved = since;
    std::uint64_t heard = robot.inputPackages();
    for (simulator::SimulatedState now = robot.truth(); now.timestamp < until; now = robot.truth()) {
        if (robot.inputPackages() != heard) {
            heard = robot.inputPackages();
            since = now.timestamp;
        }
        const bool stands = now.tcpSpeed.linear.norm() < 0.001 && now.qd.values.cwiseAbs().maxCoeff() < 0.002;
        moved = stands ? moved : now.timestamp;
        QTest::qSleep(1);
    }
    return std::max(moved - since, 0.0);
}

/// A process that moves the arm. The destructor kills it if it is still running.
class MovingProcess {
public:
    MovingProcess(const QString& program, const QStringList& arguments) {
        process_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process_.start(program, arguments);
        if (!process_.waitForStarted(kWaitTimeoutMs)) {
            qFatal("%s: %s", qPrintable(program), qPrintable(process_.errorString()));
        }
    }
    ~MovingProcess() { kill(); }

    /// Sends one line to the standard input of the process. Time may have to advance before the line has an
    /// effect.
    void tell(const char* line) {
        process_.write(QByteArray(line) + "\n");
        process_.waitForBytesWritten(kWaitTimeoutMs);
    }
    /// True if the process has printed these words since the last call.
    bool hasSaid(const QByteArray& words) {
        // Do not wait for output, because the caller must continue to read RTDE packages. Otherwise, the
        // robot would disconnect the observer.
        process_.waitForReadyRead(0);
        return process_.readAll().contains(words);
    }
    void suspend() const { setSuspended(process_.processId(), true); }
    void resume() const { setSuspended(process_.processId(), false); }
    /// Kills the process, even if it is suspended. The process cannot react.
    void kill() {
        process_.kill();
        process_.waitForFinished(kWaitTimeoutMs);
    }
    bool isRunning() const { return process_.state() == QProcess::Running; }

private:
    static constexpr int kWaitTimeoutMs = 20'000;
    QProcess process_;
};

}  // namespace tiller::test
