// SPDX-License-Identifier: MIT
#pragma once

// Common parts of the tests of the socket client. For each test function, there is a robot and a client whose
// script is running.

#include <QTest>
#include <cmath>

#include "tests/integration/clients/socket_client.h"

namespace tiller::test {

inline constexpr double kDt = 0.002;
inline const Six kStart{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

inline double largest(const Six& a, const Six& b) {
    double worst = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return worst;
}

inline Six plus(Six six, std::size_t index, double by) {
    six[index] += by;
    return six;
}

inline SocketClient::Point jointPoint(const Six& q, double a = 1.4, double v = 1.05, double t = 0,
                                      double r = 0) {
    SocketClient::Point p;
    p.target = q;
    p.third = {v, a, 0, 0, 0, 0};
    p.duration = t;
    p.blend = r;
    return p;
}

inline SocketClient::Point toolPoint(int type, const Six& pose, double r = 0) {
    SocketClient::Point p = jointPoint(pose, 1.2, 0.25, 0, r);
    p.type = type;
    return p;
}

class SocketClientTest : public QObject {
    Q_OBJECT

protected:
    using Client = SocketClient;
    using Point = SocketClient::Point;

    std::unique_ptr<VirtualRobot> robot_;
    std::unique_ptr<Client> client_;

    Six pose() const { return client_->data().actualPose; }
    bool moving() const { return robot_->controller.truth().qd.values.norm() > 3e-3; }
    bool keepIdle(int ticks = 1) {
        for (int n = 0; n < ticks; ++n) {
            if (!client_->writeRaw({}, Client::kIdle, 1000)) {
                return false;
            }
            client_->step();
        }
        return true;
    }

private Q_SLOTS:
    void init() {
        auto options = VirtualRobot::options();
        options.software = {5, 25, 0, 1254000};  // from 5.23 on the script uses direct_torque
        robot_ = std::make_unique<VirtualRobot>(options);
        client_ = std::make_unique<Client>(*robot_);
        QVERIFY2(client_->connect("\twrite_output_integer_register(5, 77)\n\tsleep(0.1)"), client_->trouble);
        QCOMPARE(client_->data().runtime, 2U);
        QVERIFY(client_->until([this] { return !client_->news().keys.empty(); }, 1));
        QCOMPARE(client_->news().keys.back(), QByteArray("PROGRAM_XXX_STARTED socket_control"));
    }
    void cleanup() {
        QCOMPARE(client_->news().malformed, QByteArray());
        client_.reset();
        robot_.reset();
    }
};

}  // namespace tiller::test
