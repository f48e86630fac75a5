// SPDX-License-Identifier: MIT
// The queue of a robot's service delivers results in the caller's thread and never blocks. Also tests the
// selection of the service: the dashboard server if available, otherwise the Robot API.
#include <QTest>

#include "robot/dashboard/service_worker.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;
using std::chrono::milliseconds;
using test::RawPeer;

namespace {

const QByteArray kGreeting = "Connected: Universal Robots Dashboard Server\n";
const QString kHost = QStringLiteral("127.0.0.1");

/// A dashboard server that accepts every power-on command.
RawPeer::Script agreeing() {
    return [](RawPeer::Link& link) {
        link.send(kGreeting);
        while (!link.isOver() && !link.readLine().isNull()) {
            link.send("Powering on\n");
        }
    };
}

/// A Robot API that only returns this version.
RawPeer::Script describing(const QByteArray& version) {
    return [version](RawPeer::Link& link) {
        while (link.readLine().trimmed().size() > 0) {
        }
        const QByteArray body = "{\"info\":{\"version\":\"" + version + "\"}}";
        link.send("HTTP/1.1 200 OK\r\nContent-Length: " + QByteArray::number(body.size()) + "\r\n\r\n" +
                  body);
    };
}

ServiceAddress at(int dashboard, int robotApi) {
    return {kHost, dashboard, robotApi};
}

Deadline testTimeout() {
    return Deadline::after(std::chrono::seconds(60));
}

}  // namespace

class TestServiceWorker : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theDashboardIsPreferred() {
        RawPeer dashboard(agreeing());
        RawPeer api(describing("3.1.4"));
        const auto service = openService(at(dashboard.port(), api.port()), testTimeout());
        QVERIFY2(service.ok(), qPrintable(service.error().toString()));
        QCOMPARE((*service)->kind(), ServiceKind::Dashboard);
        QCOMPARE(api.clients(), 0);
    }

    void theRobotApiIsUsedWithoutADashboard() {
        RawPeer api(describing("3.1.4"));
        const auto service = openService(at(RawPeer::deadPort(), api.port()), testTimeout());
        QVERIFY2(service.ok(), qPrintable(service.error().toString()));
        QCOMPARE((*service)->kind(), ServiceKind::RobotApi);
    }

    void anUnrelatedWebServerIsNotARobotApi() {
        RawPeer web([](RawPeer::Link& link) {
            while (link.readLine().trimmed().size() > 0) {
            }
            link.send("HTTP/1.1 200 OK\r\nContent-Length: 13\r\n\r\n<html></html>");
        });
        const auto service = openService(at(RawPeer::deadPort(), web.port()), testTimeout());
        QCOMPARE(service.error().code, ErrorCode::ConnectionRefused);
    }

    void theDashboardIsReportedWhenNeitherResponds() {
        const int port = RawPeer::deadPort();
        const auto service = openService(at(port, RawPeer::deadPort()), testTimeout());
        QCOMPARE(service.error().code, ErrorCode::ConnectionRefused);
        QVERIFY2(service.error().context.contains(QString::number(port)),
                 qPrintable(service.error().context));
    }

    void onlyTheDashboardClosesPopups() {
        QVERIFY(offers(ServiceKind::Dashboard, RobotCommand::ClosePopups));
        QVERIFY(!offers(ServiceKind::RobotApi, RobotCommand::ClosePopups));
        QVERIFY(offers(ServiceKind::RobotApi, RobotCommand::Play));
        RawPeer api(describing("3.1.4"));
        const auto service = openService(at(RawPeer::deadPort(), api.port()), testTimeout());
        QVERIFY(service.ok());
        QCOMPARE((*service)->perform(RobotCommand::ClosePopups, testTimeout()).error().code,
                 ErrorCode::VersionUnsupported);
    }

    void resultsAreDeliveredInTheCallersThread() {
        RawPeer peer(agreeing());
        ServiceWorker worker(at(peer.port(), RawPeer::deadPort()));
        worker.start();
        bool done = false;
        const QThread* deliveredIn = nullptr;
        worker.post([](auto& s, auto& d) { return s.perform(RobotCommand::PowerOn, d); }, this,
                    [&](const Result<void>& result) {
                        deliveredIn = QThread::currentThread();
                        done = result.ok();
                    });
        QTRY_VERIFY_WITH_TIMEOUT(done, 60'000);
        QCOMPARE(deliveredIn, thread());
    }

    void reconnectsAfterTheServerDisconnected() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(kGreeting);
            link.readLine();
            link.send("Powering on\n");
        });  // the peer disconnects after each reply
        ServiceWorker worker(at(peer.port(), RawPeer::deadPort()));
        worker.start();
        for (int round = 1; round <= 3; ++round) {
            bool answered = false;
            bool ok = false;
            worker.post([](auto& s, auto& d) { return s.perform(RobotCommand::PowerOn, d); }, this,
                        [&](const Result<void>& result) {
                            answered = true;
                            ok = result.ok();
                        });
            QTRY_VERIFY_WITH_TIMEOUT(answered, 60'000);
            // The disconnection may occur while the command is sent. The next command then succeeds.
            QVERIFY(ok || round > 1);
        }
        QVERIFY(peer.clients() >= 2);
    }

    void detectsTheServiceAgainAfterItDisappeared() {
        auto api = std::make_unique<RawPeer>(describing("3.1.4"));
        const int apiPort = api->port();
        ServiceWorker worker(at(RawPeer::deadPort(), apiPort));
        worker.start();
        std::optional<Result<void>> answer;
        const auto ask = [&] {
            answer.reset();
            worker.post([](auto& s, auto& d) { return s.perform(RobotCommand::PowerOn, d); }, this,
                        [&](const Result<void>& result) { answer = result; });
            return QTest::qWaitFor([&] { return answer.has_value(); }, 20'000);
        };
        QVERIFY(ask());
        QVERIFY(answer->ok());
        api.reset();
        QVERIFY(ask());
        QCOMPARE(answer->error().code, ErrorCode::ConnectionRefused);
        QVERIFY2(answer->error().context.contains(QString::number(apiPort)),
                 "the command was not sent to the Robot API");
        QVERIFY(ask());
        QVERIFY2(!answer->error().context.contains(QString::number(apiPort)),
                 "the service was not selected again after the failure");
    }

    void reportsWhyItCouldNotConnect() {
        ServiceWorker worker(at(RawPeer::deadPort(), RawPeer::deadPort()));
        worker.start();
        Error error;
        worker.post([](auto& s, auto& d) { return s.perform(RobotCommand::PowerOn, d); }, this,
                    [&](const Result<void>& result) { error = result.error(); });
        QTRY_COMPARE_WITH_TIMEOUT(error.code, ErrorCode::ConnectionRefused, 60'000);
    }

    void stoppingDoesNotWaitForASilentServer() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        ServiceWorker worker(at(peer.port(), RawPeer::deadPort()));
        worker.start();
        bool delivered = false;
        worker.post([](auto& s, auto& d) { return s.perform(RobotCommand::PowerOn, d); }, this,
                    [&](const Result<void>&) { delivered = true; }, milliseconds(600'000));
        QTRY_COMPARE_WITH_TIMEOUT(peer.clients(), 1, 60'000);
        worker.stop();  // would exceed the time limit of the test if it waited
        QCoreApplication::processEvents();
        QVERIFY(!delivered);
    }

    void aDestroyedCallerIsNotCalled() {
        RawPeer peer(agreeing());
        ServiceWorker worker(at(peer.port(), RawPeer::deadPort()));
        worker.start();
        const auto powerOn = [](auto& s, auto& d) { return s.perform(RobotCommand::PowerOn, d); };
        bool called = false;
        auto caller = std::make_unique<QObject>();
        worker.post(powerOn, caller.get(), [&](const Result<void>&) { called = true; });
        caller.reset();
        bool after = false;
        worker.post(powerOn, this, [&](const Result<void>&) { after = true; });
        QTRY_VERIFY_WITH_TIMEOUT(after, 60'000);
        QVERIFY(!called);
    }
};

QTEST_GUILESS_MAIN(TestServiceWorker)
#include "tst_service_worker.moc"
