// SPDX-License-Identifier: MIT
//
// A hundred thousand broken inputs for each service, and clients that come and go: no crash, no descriptor
// left, no control period that hangs, and a proper client is served as before. Short by default;
//
//     tst_server_endurance --seconds 3600        clients come and go for an hour
//     tst_server_endurance --inputs 1000000 --seed 7

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTest>
#include <random>

#include "tests/integration/simulator/raw_client.h"

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

/// Memory of this process in RAM [KiB]; 0 where the system does not tell.
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

class Inputs {
public:
    explicit Inputs(quint64 number) : random_(number) {}
    int upTo(int most) { return int(random_() % quint64(most + 1)); }
    QByteArray any(const QList<QByteArray>& from) { return from[upTo(int(from.size()) - 1)]; }
    QByteArray bytes(int most) {
        QByteArray out(upTo(most), '\0');
        for (char& c : out) {
            c = char(random_());
        }
        return out;
    }
    /// Words in any order, now and then damaged.
    QByteArray soup(const QList<QByteArray>& words, int most) {
        QByteArray out;
        for (int i = upTo(most); i >= 0; --i) {
            out += any(words);
        }
        return damaged(out);
    }
    QByteArray damaged(QByteArray text) {
        switch (text.isEmpty() ? 9 : upTo(9)) {
            case 0:
                text[upTo(int(text.size()) - 1)] = char(random_());
                break;
            case 1:
                text.truncate(upTo(int(text.size())));
                break;
            case 2:
                text.insert(upTo(int(text.size())), bytes(8));
                break;
            case 3:
                text += text;
                break;
            default:
                break;
        }
        return text;
    }

private:
    std::mt19937_64 random_;
};

QByteArray dashboardInput(Inputs& in) {
    // `shutdown` would end the game.
    static const QList<QByteArray> words{"load ",
                                         "play",
                                         "stop",
                                         "pause",
                                         "running",
                                         "programState",
                                         "get ",
                                         "loaded program",
                                         "isProgramSaved",
                                         "installation ",
                                         "robotmode",
                                         "power on",
                                         "power off",
                                         "brake release",
                                         "unlock protective stop",
                                         "close ",
                                         "safety popup",
                                         "popup",
                                         "restart safety",
                                         "safetymode",
                                         "safetystatus",
                                         "quit",
                                         "addToLog ",
                                         "saveLog",
                                         "setUserRole ",
                                         "getUserRole",
                                         "PolyscopeVersion",
                                         "version",
                                         "serial number",
                                         "robot model",
                                         "is in remote control",
                                         "set operational mode ",
                                         "manual",
                                         "generate flight report ",
                                         "generate support file ",
                                         "../",
                                         "\"",
                                         " ",
                                         "\r",
                                         "\0",
                                         "x.urp",
                                         "%n%s",
                                         "\xff\xfe"};
    return in.soup(words, 4) + '\n';
}

QByteArray rtdeInput(Inputs& in) {
    static const QList<QByteArray> names{"timestamp",
                                         "actual_q",
                                         "input_int_register_0",
                                         "speed_slider_mask",
                                         "payload",
                                         ",",
                                         ",,",
                                         "input_double_register_47",
                                         "output_bit_register_64",
                                         "no_such_field",
                                         "",
                                         "standard_digital_output_mask",
                                         "standard_digital_output"};
    QByteArray payload;
    const char type = "VvMUOISPx\0\xff"[in.upTo(10)];
    switch (type) {
        case 'V':
            payload = bigEndian(quint16(in.upTo(3)));
            break;
        case 'O':
            payload = bigEndian(double(in.upTo(2000)) - 500) + in.any(names) + ',' + in.any(names);
            break;
        case 'I':
            payload = in.any(names) + ',' + in.any(names);
            break;
        case 'U':
            payload = char(in.upTo(6)) + in.bytes(40);
            break;
        default:
            payload = in.bytes(12);
    }
    QByteArray package = RawRtde::package(type, in.damaged(payload));
    return in.upTo(50) == 0 ? in.damaged(package) : package;
}

QByteArray scriptInput(Inputs& in) {
    static const QList<QByteArray> words{"def p():\n",
                                         "end\n",
                                         "sec s():\n",
                                         "movej(",
                                         "[0,-1.5,-2,0,0,0]",
                                         "p[0.1,0.2,0.3,0,0,0]",
                                         ")",
                                         "(",
                                         ",",
                                         "a=1",
                                         "1e308",
                                         "-",
                                         "+",
                                         "*",
                                         "/",
                                         "%",
                                         "\"text\"",
                                         "'",
                                         "[",
                                         "]",
                                         "{",
                                         "}",
                                         "if ",
                                         "True",
                                         ":\n",
                                         "else:\n",
                                         "elif ",
                                         "return ",
                                         "global x=",
                                         "x",
                                         "textmsg(",
                                         "popup(",
                                         "set_digital_out(",
                                         "0",
                                         "9999999999999",
                                         "sleep(",
                                         "sync()",
                                         "\n",
                                         "#",
                                         "\\",
                                         "$ 1 2\n",
                                         "power on\n",
                                         "power off\n",
                                         "stop program\n",
                                         "set robotmode run\n",
                                         "struct(",
                                         ".",
                                         "!",
                                         "thread t():\n",
                                         "run t()",
                                         "kill ",
                                         "break\n",
                                         "and ",
                                         "not ",
                                         "==",
                                         "socket_close(",
                                         "\xc3\x28"};
    return in.soup(words, 12) + '\n';
}

QByteArray interpreterInput(Inputs& in) {
    static const QList<QByteArray> lines{"statelastexecuted",
                                         "stateunexecuted",
                                         "statelastcleared",
                                         "skipbuffer",
                                         "abort",
                                         "clear_interpreter()",
                                         "x = 1",
                                         "x = x + 1",
                                         "textmsg(x)",
                                         "sleep(0.01)",
                                         "def f(a): return a end",
                                         "f(2)",
                                         "movej([0,-1.5,-2,0,0,0])",
                                         "x = [1,2",
                                         "y",
                                         "set_digital_out(0, True)"};
    return in.upTo(3) == 0 ? scriptInput(in) : in.damaged(in.any(lines)) + '\n';
}

QByteArray httpInput(Inputs& in) {
    static const QList<QByteArray> words{
        "GET ",
        "PUT ",
        "POST ",
        "HEAD ",
        "DELETE ",
        "/universal-robots/robot-api",
        "/programs/v1/",
        "/program/v1/state",
        "/robotstate/v1/state",
        "/openapi.json",
        "..%2f..",
        "%zz",
        "%00",
        " HTTP/1.1\r\n",
        " HTTP/1.0\r\n",
        " HTTP/9.9\r\n",
        "Content-Length: 5\r\n",
        "Content-Length: -1\r\n",
        "Content-Length: 999999999999999999999\r\n",
        "Transfer-Encoding: chunked\r\n",
        "5\r\nhello\r\n",
        "0\r\n\r\n",
        "ffffffffffffffff\r\n",
        "Expect: 100-continue\r\n",
        "Connection: close\r\n",
        "Content-Type: multipart/form-data; boundary=x\r\n",
        "--x\r\nContent-Disposition: form-data; name=\"file\"; filename=\"a\"\r\n\r\n{}\r\n--x--\r\n",
        "{\"action\":\"POWER_ON\"}",
        "{\"name\":",
        "\r\n",
        "\r\n\r\n",
        ":",
        "\0",
        "\xff"};
    static const QList<QByteArray> proper{
        "GET /universal-robots/robot-api/robotstate/v1/robotmode HTTP/1.1\r\n\r\n",
        "PUT /universal-robots/robot-api/program/v1/state HTTP/1.1\r\nContent-Length: "
        "17\r\n\r\n{\"action\":\"play\"}",
        "POST /universal-robots/robot-api/programs/v1/ HTTP/1.1\r\nTransfer-Encoding: "
        "chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n"};
    return in.upTo(1) == 0 ? in.damaged(in.any(proper)) : in.soup(words, 8);
}

QByteArray gripperInput(Inputs& in) {
    static const QList<QByteArray> words{"SET ", "GET ", "ACT ", "GTO ", "POS ", "SPE ", "FOR ",
                                         "ATR ", "ARD ", "1 ",   "0 ",   "255 ", "-1 ",  "99999999999 ",
                                         "x",    "STA",  "OBJ",  "?",    "\r",   "\t",   "\xff"};
    return in.soup(words, 6) + '\n';
}

QByteArray faultInput(Inputs& in) {
    static const QList<QByteArray> words{"safeguard ",
                                         "on",
                                         "off",
                                         "delay ",
                                         "0 ",
                                         "1e9 ",
                                         "nan",
                                         "reduced ",
                                         "status",
                                         "help",
                                         "hold-registers ",
                                         "lower",
                                         "release-registers",
                                         "popup ",
                                         "speed ",
                                         "0.5",
                                         "hand ",
                                         "clear",
                                         "calibration ",
                                         "gripper-object ",
                                         "none",
                                         "digital-input ",
                                         "7 ",
                                         "\xff",
                                         "\0"};
    return in.soup(words, 4) + '\n';
}

struct Service {
    const char* name;
    std::uint16_t simulator::Ports::*port;
    QByteArray (*input)(Inputs&);
};
const Service kServices[] = {
    {"dashboard", &simulator::Ports::dashboard, dashboardInput},
    {"RTDE", &simulator::Ports::rtde, rtdeInput},
    {"primary", &simulator::Ports::primary, scriptInput},
    {"realtime", &simulator::Ports::realtime, scriptInput},
    {"interpreter", &simulator::Ports::interpreter, interpreterInput},
    {"Robot API", &simulator::Ports::robotApi, httpInput},
    {"gripper", &simulator::Ports::gripper, gripperInput},
    {"faults", &simulator::Ports::faults, faultInput},
};

/// A proper client gets what it has always got.
bool servesAsBefore(VirtualRobot& robot) {
    if (!robot.controller.inject("clear").ok()) {
        return false;
    }
    // Those who have just connected are counted among the others.
    robot.controller.drainSockets();
    robot.controller.drainSockets();
    const int others = robot.controller.rtdeClients();
    RawRtde rtde = robot.rtde();
    if (!rtde.useVersion() ||
        rtde.setupOutputs(500, "timestamp") != QByteArray("\x01"
                                                          "DOUBLE") ||
        !rtde.start()) {
        qWarning("a proper client is refused");
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
        for (int i = 0; i < int(std::size(kServices)); ++i) {
            QTest::newRow(kServices[i].name) << i;
        }
    }
    void brokenInputsHarmNoService() {
        QFETCH(int, index);
        const Service& service = kServices[index];
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
        Inputs in(seed + quint64(index));
        std::unique_ptr<RawClient> client;
        int connections = 0;
        for (int done = 0; done < inputCount;) {
            if (!client || !client->isConnected() || in.upTo(200) == 0) {
                client = std::make_unique<RawClient>(robot.host(), robot.controller.ports().*service.port);
                ++connections;
                QVERIFY(client->isConnected());
            }
            // A few at a time: what follows the one that makes the service hang up is lost.
            QByteArray batch;
            for (int i = 0; i < 5; ++i, ++done) {
                batch += service.input(in);
            }
            // Not send(): the other end may have had enough.
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

    void clientsComeAndGo() {
        VirtualRobot robot;
        QVERIFY(servesAsBefore(robot));
        const int descriptors = openDescriptors();
        Inputs in(seed);
        std::vector<std::unique_ptr<RawClient>> clients;
        QElapsedTimer timer;
        timer.start();
        int connections = 0;
        // Free of leaks: what it has taken after a tenth of the time is what it has at the end, but for the
        // allocator's own affairs. Of use for long runs only.
        constexpr qint64 kReserve = 24 * 1024;
        qint64 settledMemory = 0;
        qint64 told = 0;
        qint64 slowest = 0;  // step [ms]
        const auto goesOn = [&] {
            return churnSeconds > 0 ? timer.elapsed() < qint64(churnSeconds) * 1000 : connections < 600;
        };
        while (goesOn()) {
            const Service& service = kServices[in.upTo(int(std::size(kServices)) - 1)];
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
                        break;  // as it is
                }
                clients.erase(leaving);
            }
            const quint64 tick = robot.controller.truth().tick;
            const int ticks = 1 + in.upTo(10);
            const qint64 began = timer.elapsed();
            robot.controller.step(ticks);
            slowest = std::max(slowest, timer.elapsed() - began);
            QCOMPARE(robot.controller.truth().tick, tick + quint64(ticks));
            if (churnSeconds > 0 && timer.elapsed() - told > qint64(churnSeconds) * 50) {
                told = timer.elapsed();
                if (settledMemory == 0 && told > qint64(churnSeconds) * 100) {
                    settledMemory = residentMemory();
                }
                qInfo("%lld s: %d connections, %lld KiB, %d descriptors for %d clients, slowest step %lld ms",
                      told / 1000, connections, residentMemory(), openDescriptors(), int(clients.size()),
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
        // Qt Test ends what takes longer than five minutes.
        qputenv("QTEST_FUNCTION_TIMEOUT", QByteArray::number((qint64(churnSeconds) + 3600) * 1000));
    }
    TestServerEndurance test;
    return QTest::qExec(&test, arguments);
}
#include "tst_server_endurance.moc"
