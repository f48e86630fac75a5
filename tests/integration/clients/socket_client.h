// SPDX-License-Identifier: MIT
#pragma once

// A client that behaves like Universal Robots' C++ client library 2.14, as seen in its network traffic: it
// pauses RTDE before it sends the input recipe, reads the primary interface package by package, sends its
// script after "stop program", and runs three servers to which the script connects. It runs in virtual time,
// one period per step.

#include <QTcpServer>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "tests/integration/clients/socket_script.h"
#include "tests/support/stepped_client.h"

namespace tiller::test {

/// Data received from the primary interface.
struct PrimaryNews {
    bool version = false;
    bool configuration = false;
    bool kinematics = false;
    bool running = false;  ///< from robot mode data: true if a program is running
    bool paused = false;
    bool protectiveStopped = false;
    int robotMode = -1;
    std::vector<QByteArray> texts;
    std::vector<QByteArray> keys;        ///< title and text of key messages
    std::vector<QByteArray> exceptions;  ///< texts of runtime exceptions
    std::vector<qint32> errorCodes;
    std::vector<int> errorLevels;
    std::vector<int> safetyModes;
    QByteArray malformed;  ///< first package that violates the protocol
};

class SocketClient : public SteppedClient {
public:
    enum Mode {
        kStopped = -2,
        kIdle = 0,
        kServoJ = 1,
        kSpeedJ,
        kForward,
        kSpeedL,
        kPose,
        kFreedrive,
        kToolContact,
        kTorque
    };
    /// The fields of an RTDE package that the tests need.
    struct Data {
        double timestamp = 0;
        Six actualQ{};
        Six targetQ{};
        Six actualPose{};
        Six force{};
        Six tcpOffset{};
        quint32 runtime = 0;
        double payload = 0;
        int toolVoltage = 0;
    };

    explicit SocketClient(VirtualRobot& robot) : SteppedClient(robot) {}

    /// Connects RTDE, the primary interface, the three servers and the script. Where the library would throw,
    /// returns false with the step in `trouble`.
    bool connect(const QByteArray& ending = {});
    /// Sends a complete program on the primary socket.
    void sendScript(const QByteArray& text);

    /// Sends eight integers on the reverse socket: timeout [ms], six values multiplied by one million, and
    /// the mode.
    bool write(const Six& values, Mode mode, int timeoutMs = 200);
    bool writeRaw(const std::array<qint32, 6>& values, Mode mode, int timeoutMs = 200);
    /// A point of a trajectory: 21 integers on the trajectory socket.
    struct Point {
        Six target{};
        Six second{};                   ///< via, velocities, near joints
        std::array<double, 6> third{};  ///< accelerations, or velocity, acceleration, flag
        double duration = 0;
        double blend = 0;  ///< [m]; for a spline: 1 cubic, 2 quintic
        int type = 0;
    };
    bool writePoint(const Point& point);
    /// Announces and sends a trajectory with these points.
    bool startTrajectory(const std::vector<Point>& points);
    /// Returns the result sent by the script; empty if it did not arrive in time. 0 success, 1 cancelled, 2
    /// failure.
    std::optional<int> trajectoryResult(double seconds);
    /// Sends 28 integers on the command socket. The values are scaled.
    /// rawFirst  true: the first value is not scaled
    bool writeCommand(int command, const std::vector<double>& values, bool rawFirst = false);
    std::optional<int> commandReply(double seconds);
    bool isReverseConnected();

    void step(int ticks = 1) override;
    const Data& data() const { return data_; }
    const PrimaryNews& news() const { return news_; }
    PrimaryNews& news() { return news_; }

private:
    struct Server {
        QTcpServer server;
        std::unique_ptr<QTcpSocket> peer;
        QByteArray received;
        bool listen() { return server.listen(QHostAddress::LocalHost, 0); }
        void service();
    };
    bool connectRtde();
    bool deliver(Server& server, const QByteArray& bytes);
    std::optional<int> answer(Server& server, double seconds);
    void readPrimary();
    void readPackage(const QByteArray& package);
    void readState(const QByteArray& package);
    void readMessage(const QByteArray& package);

    std::unique_ptr<RawRtde> rtde_;
    std::unique_ptr<QTcpSocket> primary_;
    QByteArray primaryBytes_;
    Server reverse_;
    Server trajectory_;
    Server command_;
    std::vector<int> order_;  // order in which the script connected
    Data data_;
    PrimaryNews news_;
};

}  // namespace tiller::test
