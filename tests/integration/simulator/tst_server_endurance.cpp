// SPDX-License-Identifier: MIT
//
// A hundred thousand invalid inputs for each service, and clients that connect and disconnect. There must be
// no crash, no leaked descriptor and no blocked control period, and the simulator must still serve a valid
// client. The default run is short. Longer runs:
//
//     tst_server_endurance --seconds 3600        clients connect and disconnect for an hour
//     tst_server_endurance --inputs 1000000 --seed 7

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include "tests/support/broken_inputs.h"
#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

int inputCount = 100'000;
int churnSeconds = 0;
quint64 seed = 1;

int openDescriptors() {
    return int(QDir(QStringLiteral("/proc/self/fd"))
                   .entryList(QDir::NoDotAndDotDot | QDir::System | QDir::Files)
                   .size());
}

/// Resident memory of this process [KiB]; 0 if the system does not report it.
qint64 residentMemory() {
    QFile file(QStringLiteral("/proc/self/status"));
    if (file.open(QIODevice::ReadOnly)) {
        for (const QByteArray& line : file.readAll().split('\n')) {
            if (line.startsWith("VmRSS:")) {
                return line.mid(6).simplified().split(' ').value(0).toLongLong();
            }
        }
    }
    return 0;
}

/// Returns true if the simulator still accepts a valid RTDE client and sends data to it.
bool servesAsBefore(VirtualRobot& robot) {
    if (!robot.controller.inject("clear").ok()) {
        return false;
    }
    // Also process clients that have just connected.
    robot.controller.drainSockets();
    robot.controller.drainSockets();
    const int others = robot.controller.rtdeClients();
    RawRtde rtde = robot.rtde();
    if (!rtde.useVersion() ||
        rtde.setupOutputs(500, "timestamp") != QByteArray("\x01"
                                                          "DOUBLE") ||
        !rtde.start()) {
        qWarning("a valid client was refused");
        return false;
    }
    const quint64 before = robot.controller.truth().tick;
    robot.controller.step(3);
    const bool served = robot.controller.truth().tick == before + 3 && rtde.next().payload.size() == 9;
    rtde.close();
    const bool gone = robot.stepUntil([&] { return robot.controller.rtdeClients() <= others; }, 5);
    if (!served || !gone) {
        qWarning("served: %d, %d clients after %d", served, robot.controller.rtdeClients(), others);
    }
    return served && gone;
}

}  // namespace

class TestServerEndurance : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void brokenInputsHarmNoService_data() {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const AttackedService& service : attackedServices()) {
            QTest::newRow(service.name) << index++;
        }
    }
    void brokenInputsHarmNoService() {
        QFETCH(int, index);
        const AttackedService& service = attackedServices()[std::size_t(index)];
        auto options = VirtualRobot::options();
        options.fastTransitions = true;
        if (service.port == &simulator::Ports::robotApi) {
            options.software = {10, 12, 0, 0};
        }
        VirtualRobot robot(options);
        QVERIFY(servesAsBefore(robot));
        if (service.port == &simulator::Ports::interpreter) {
            RawPrimary primary = robot.primary();
            primary.send("def m():\n  while True:\n    interpreter_mode()\n  end\nend\n");
            robot.controller.step(3);
            primary.close();
            robot.controller.step(3);
        }
        const int descriptors = openDescriptors();
        Chances in(seed + quint64(index));
        std::unique_ptr<RawClient> client;
        int connections = 0;
        for (int done = 0; done < inputCount;) {
            if (!client || !client->isConnected() || in.upTo(200) == 0) {
                client = std::make_unique<RawClient>(robot.host(), robot.controller.ports().*service.port);
                ++connections;
                QVERIFY(client->isConnected());
            }
            // Send only a few inputs at a time, because inputs after an input that causes a disconnection are
            // lost.
            QByteArray batch;
            for (int i = 0; i < 5; ++i, ++done) {
                batch += service.input(in);
            }
            // Do not use send(), because the other end may have closed the connection.
            client->socket().write(batch);
            client->socket().flush();
            robot.controller.drainSockets();
            client->socket().waitForReadyRead(0);
            if (client->isConnected()) {
                client->socket().readAll();
            }
            if (done % 500 == 0) {
                robot.controller.step(2);
            }
        }
        client.reset();
        QVERIFY(robot.stepUntil([&] { return robot.controller.rtdeClients() == 0; }, 5));
        QVERIFY(servesAsBefore(robot));
        robot.controller.step(5);
        QCOMPARE(openDescriptors(), descriptors);
        qInfo("%d inputs over %d connections", inputCount, connections);
    }

    void clientsConnectAndDisconnectRepeatedly() {
        VirtualRobot robot;
        QVERIFY(servesAsBefore(robot));
        const int descriptors = openDescriptors();
        Chances in(seed);
        const int lastService = int(attackedServices().size()) - 1;
        std::vector<std::unique_ptr<RawClient>> clients;
        QElapsedTimer timer;
        timer.start();
        int connections = 0;
        // No leaks: the memory at the end equals the memory after a tenth of the time, except for the reserve
        // of the allocator. Only long runs can show leaks.
        constexpr qint64 kReserve = 24 * 1024;
        qint64 settledMemory = 0;
        qint64 reported = 0;
        qint64 slowest = 0;  // longest step [ms]
        const auto goesOn = [&] {
            return churnSeconds > 0 ? timer.elapsed() < qint64(churnSeconds) * 1000 : connections < 600;
        };
        while (goesOn()) {
            const AttackedService& service = attackedServices()[std::size_t(in.upTo(lastService))];
            const quint16 port = robot.controller.ports().*service.port;
            if (port != 0) {
                clients.push_back(std::make_unique<RawClient>(robot.host(), port));
                QVERIFY(clients.back()->isConnected());
                if (++connections % 100 == 0) {
                    QVERIFY(servesAsBefore(robot));
                }
                for (int i = in.upTo(5); i > 0; --i) {
                    clients.back()->socket().write(service.input(in));
                }
                clients.back()->socket().flush();
            }
            while (clients.size() > std::size_t(in.upTo(20))) {
                const auto leaving = clients.begin() + in.upTo(int(clients.size()) - 1);
                switch (in.upTo(2)) {
                    case 0:
                        (*leaving)->socket().abort();
                        break;
                    case 1:
                        (*leaving)->socket().readAll();
                        (*leaving)->socket().disconnectFromHost();
                        break;
                    default:
                        break;  // destroyed without closing the connection first
                }
                clients.erase(leaving);
            }
            const quint64 tick = robot.controller.truth().tick;
            const int ticks = 1 + in.upTo(10);
            const qint64 began = timer.elapsed();
            robot.controller.step(ticks);
            slowest = std::max(slowest, timer.elapsed() - began);
            QCOMPARE(robot.controller.truth().tick, tick + quint64(ticks));
            if (churnSeconds > 0 && timer.elapsed() - reported > qint64(churnSeconds) * 50) {
                reported = timer.elapsed();
                if (settledMemory == 0 && reported > qint64(churnSeconds) * 100) {
                    settledMemory = residentMemory();
                }
                qInfo("%lld s: %d connections, %lld KiB, %d descriptors for %d clients, slowest step %lld ms",
                      reported / 1000, connections, residentMemory(), openDescriptors(), int(clients.size()),
                      slowest);
            }
        }
        clients.clear();
        QVERIFY(robot.stepUntil([&] { return robot.controller.rtdeClients() == 0; }, 5));
        QVERIFY(servesAsBefore(robot));
        robot.controller.step(5);
        QCOMPARE(openDescriptors(), descriptors);
        if (settledMemory > 0) {
            QVERIFY2(residentMemory() < settledMemory + kReserve,
                     qPrintable(QString::number(residentMemory())));
        }
        qInfo("%d connections in %lld ms", connections, timer.elapsed());
    }
};

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QStringList arguments = QCoreApplication::arguments();
    const auto take = [&arguments](const char* name, auto& into) {
        const qsizetype at = arguments.indexOf(QLatin1String(name));
        if (at >= 0 && at + 1 < arguments.size()) {
            into = static_cast<std::remove_reference_t<decltype(into)>>(arguments[at + 1].toLongLong());
            arguments.remove(at, 2);
        }
    };
    take("--inputs", inputCount);
    take("--seconds", churnSeconds);
    take("--seed", seed);
    if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) {
        // Qt Test aborts functions that take longer than five minutes.
        qputenv("QTEST_FUNCTION_TIMEOUT", QByteArray::number((qint64(churnSeconds) + 3600) * 1000));
    }
    TestServerEndurance test;
    return QTest::qExec(&test, arguments);
}
#include "tst_server_endurance.moc"
