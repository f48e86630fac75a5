// SPDX-License-Identifier: MIT
//
// Two simple types of client. One is like Universal Robots' RTDE Python library (an input recipe, an output
// recipe, a setpoint program). The other is like python-urx (single script lines on the secondary interface,
// the state parsed from its packages, the realtime records).

#include <QTest>
#include <cmath>
#include <map>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Like the RTDE Python library: takes names and types from the replies, and stores values by name.
class RecipeClient {
public:
    explicit RecipeClient(VirtualRobot& robot) : robot_(robot), rtde_(robot.rtde()) {}

    /// Requires the same payload sizes as the library.
    bool connect() {
        const auto protocol = rtde_.request('V', bigEndian(quint16(2)));
        const auto version = rtde_.request('v');
        return protocol.type == 'V' && protocol.payload == QByteArray(1, '\1') && version.type == 'v' &&
               version.payload.size() == 16;
    }
    bool setupOutputs(const QByteArray& names) {
        const QByteArray reply = rtde_.setupOutputs(500, names);
        outputs_ = names.split(',');
        types_ = reply.mid(1).split(',');
        return reply[0] == 1 && types_.size() == outputs_.size() && !types_.contains("NOT_FOUND");
    }
    char setupInputs(const QByteArray& names) {
        const QByteArray reply = rtde_.setupInputs(names);
        return reply.contains("IN_USE") || reply.contains("NOT_FOUND") ? '\0' : reply[0];
    }
    bool start() {
        const auto reply = rtde_.request('S');
        return reply.type == 'S' && reply.payload == QByteArray(1, '\1');
    }
    bool pause() {
        auto reply = rtde_.request('P');
        while (reply.type == 'U') {
            reply = rtde_.next();
        }
        return reply.type == 'P' && reply.payload == QByteArray(1, '\1');
    }
    bool send(char recipe, const QByteArray& values) {
        const std::uint64_t before = robot_.controller.inputPackages();
        rtde_.sendPackage('U', recipe + values);
        return robot_.controller.waitForInputPackages(before + 1, Deadline::after(std::chrono::seconds(20)));
    }
    /// Advances one period and reads the package of that period.
    bool receive() {
        robot_.controller.step();
        const auto package = rtde_.next();
        if (package.type != 'U' || package.payload[0] != 1) {
            return false;
        }
        qsizetype at = 1;
        for (qsizetype i = 0; i < types_.size(); ++i) {
            std::vector<double>& value = values_[outputs_[i]];
            value.clear();
            const QByteArray& type = types_[i];
            const int count = type == "VECTOR6D" ? 6 : 1;
            for (int n = 0; n < count; ++n) {
                if (type == "DOUBLE" || type == "VECTOR6D") {
                    value.push_back(doubleAt(package.payload, at));
                    at += 8;
                } else {
                    value.push_back(intAt(package.payload, at));
                    at += 4;
                }
            }
        }
        return at == package.payload.size();
    }
    double value(const QByteArray& name, std::size_t i = 0) const { return values_.at(name)[i]; }

private:
    VirtualRobot& robot_;
    RawRtde rtde_;
    QList<QByteArray> outputs_;
    QList<QByteArray> types_;
    std::map<QByteArray, std::vector<double>> values_;
};

/// Like python-urx: reads the secondary stream, resynchronizes after an invalid header, and uses the state.
class LineClient {
public:
    explicit LineClient(VirtualRobot& robot)
        : robot_(robot)
        , secondary_(robot.host(), robot.controller.ports().secondary)
        , realtime_(robot.host(), robot.controller.ports().realtime) {}

    struct State {
        bool known = false;
        bool running = false;  ///< criteria of the library: mode, connected, enabled, powered, no stops
        bool programRunning = false;
        std::array<double, 6> joints{};
        std::array<double, 6> pose{};
        quint32 digitalOutputs = 0;
    };
    const State& state() const { return state_; }
    const QByteArray& record() const { return record_; }
    QByteArray trouble;

    void sendLine(const QByteArray& line) {
        secondary_.send(line + '\n');
        robot_.controller.drainSockets();
    }
    /// Advances a tenth of a second and reads the received states.
    void step() {
        robot_.controller.step(50);
        buffer_ += secondary_.takeAll();
        while (parseOne()) {
        }
        QByteArray records = realtime_.takeAll();
        if (records.size() >= 4) {
            const int size = intAt(records, 0);
            if (size > 0 && records.size() >= size) {
                record_ = records.right(records.size() % size == 0 ? size : 0);
            }
        }
    }
    template <class Condition>
    bool until(Condition condition, double seconds) {
        for (int n = static_cast<int>(seconds * 10); n > 0; --n) {
            step();
            if (condition()) {
                return true;
            }
        }
        return false;
    }
    /// Waits for the end of a move like the library: first the program starts, then no program is running.
    bool waitForMove(double seconds) {
        return until([this] { return state_.programRunning; }, 1) &&
               until([this] { return !state_.programRunning; }, seconds);
    }

private:
    bool parseOne() {
        if (buffer_.size() < 5) {
            return false;
        }
        const int size = intAt(buffer_, 0);
        if (size < 5 || size > 2000 || (buffer_[4] != 16 && buffer_[4] != 20)) {
            trouble = "header that makes no sense";
            buffer_.remove(0, 1);
            return true;
        }
        if (buffer_.size() < size) {
            return false;
        }
        if (buffer_[4] == 16) {
            parseState(buffer_.left(size));
        }
        buffer_.remove(0, size);
        return true;
    }
    void parseState(const QByteArray& package) {
        for (qsizetype at = 5; at + 5 <= package.size();) {
            const int size = intAt(package, at);
            const int type = package[at + 4];
            const QByteArray sub = package.mid(at, size);
            if (size < 5 || sub.size() != size) {
                trouble = "sub-package that makes no sense";
                return;
            }
            if (type == 0) {
                if (size != 47) {
                    trouble = "robot mode data of another version";
                }
                const bool connected = sub[13] != 0;
                const bool enabled = sub[14] != 0;
                const bool powered = sub[15] != 0;
                const bool stops = sub[16] != 0 || sub[17] != 0;
                state_.running = sub[20] == 7 && connected && enabled && powered && !stops;
                state_.programRunning = sub[18] != 0;
                state_.known = true;
            } else if (type == 1) {
                for (std::size_t j = 0; j < 6; ++j) {
                    state_.joints[j] = doubleAt(sub, 5 + 41 * static_cast<qsizetype>(j));
                }
            } else if (type == 3) {
                state_.digitalOutputs = wordAt(sub, 9);
            } else if (type == 4) {
                for (std::size_t i = 0; i < 6; ++i) {
                    state_.pose[i] = doubleAt(sub, 5 + 8 * static_cast<qsizetype>(i));
                }
            }
            at += size;
        }
    }

    VirtualRobot& robot_;
    RawClient secondary_;
    RawClient realtime_;
    QByteArray buffer_;
    QByteArray record_;
    State state_;
};

}  // namespace

class TestLineClients : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // The control loop example of the library: setpoints in registers, a watchdog bit, and a program that
    // moves.
    void aRecipeClientRunsItsControlLoop() {
        VirtualRobot robot;
        RecipeClient client(robot);
        QVERIFY(client.connect());
        QVERIFY(client.setupOutputs(
            "actual_q,actual_TCP_pose,output_int_register_0,runtime_state,output_double_register_0"));
        const char setp = client.setupInputs(
            "input_double_register_0,input_double_register_1,input_double_register_2,"
            "input_double_register_3,input_double_register_4,input_double_register_5");
        const char watchdog = client.setupInputs("input_int_register_0");
        QVERIFY(setp == 1 && watchdog == 2);
        RawClient script(robot.host(), robot.controller.ports().secondary);
        script.send(
            "def main_loop():\n"
            "  rtde_set_watchdog(\"input_int_register_0\", 1, \"stop\")\n"
            "  write_output_integer_register(0, 0)\n"
            "  while True:\n"
            "    write_output_integer_register(0, 1)\n"
            "    while read_input_integer_register(0) == 0:\n      sync()\n    end\n"
            "    local target = p[read_input_float_register(0), read_input_float_register(1), "
            "read_input_float_register(2), read_input_float_register(3), read_input_float_register(4), "
            "read_input_float_register(5)]\n"
            "    write_output_integer_register(0, 2)\n"
            "    movej(target, a=1.2, v=1.0)\n"
            "    while read_input_integer_register(0) != 0:\n      sync()\n    end\n"
            "  end\n"
            "end\n");
        robot.controller.drainSockets();
        QVERIFY(client.start());
        QVERIFY(client.receive());
        std::array<std::array<double, 6>, 2> goals{
            {{-0.12, -0.43, 0.14, 0, 3.11, 0.04}, {-0.12, -0.51, 0.21, 0, 3.11, 0.04}}};
        const auto waitFor = [&](int state, double seconds) {
            for (int n = static_cast<int>(seconds / 0.002); n > 0; --n) {
                if (!client.send(watchdog, bigEndian(qint32(state == 1 ? 0 : 1))) || !client.receive()) {
                    return false;
                }
                if (client.value("output_int_register_0") == state) {
                    return true;
                }
            }
            return false;
        };
        for (int round = 0; round < 4; ++round) {
            QVERIFY(waitFor(1, 10));
            QByteArray values;
            for (const double v : goals[static_cast<std::size_t>(round % 2)]) {
                values += bigEndian(v);
            }
            QVERIFY(client.send(setp, values));
            QVERIFY(waitFor(2, 1));
            QVERIFY(waitFor(1, 10));
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(std::abs(client.value("actual_TCP_pose", i) -
                                 goals[static_cast<std::size_t>(round % 2)][i]) < 1e-3);
            }
        }
        // Without further watchdog signals, the watchdog stops the program.
        bool stopped = false;
        for (int n = 0; n < 1000 && !stopped; ++n) {
            QVERIFY(client.receive());
            stopped = client.value("runtime_state") == 1;
        }
        QVERIFY(stopped);
        QVERIFY(client.pause());
    }

    void secondRecipeClientLearnsWhichInputsAreInUse() {
        VirtualRobot robot;
        RecipeClient first(robot);
        RecipeClient second(robot);
        QVERIFY(first.connect() && second.connect());
        QCOMPARE(first.setupInputs("input_int_register_0,speed_slider_mask,speed_slider_fraction"), '\1');
        QCOMPARE(second.setupInputs("speed_slider_mask,speed_slider_fraction"), '\0');
        QCOMPARE(second.setupInputs("input_int_register_1"), '\1');
    }

    void aLineClientMovesByLines() {
        VirtualRobot robot;
        LineClient client(robot);
        QVERIFY(client.until([&] { return client.state().known; }, 2));
        QVERIFY(client.state().running);
        QVERIFY(!client.state().programRunning);
        std::array<double, 6> q = client.state().joints;
        const auto list = [](const std::array<double, 6>& values) {
            QByteArray text;
            for (const double v : values) {
                text += (text.isEmpty() ? "[" : ",") + QByteArray::number(v, 'f', 6);
            }
            return text + ']';
        };
        q[0] += 0.3;
        client.sendLine("movej(" + list(q) + ", a=0.5, v=0.5, r=0)");
        QVERIFY(client.waitForMove(10));
        QVERIFY(std::abs(client.state().joints[0] - q[0]) < 1e-4);
        std::array<double, 6> pose = client.state().pose;
        pose[2] += 0.05;
        client.sendLine("movel(p" + list(pose) + ", a=0.3, v=0.1, r=0)");
        QVERIFY(client.waitForMove(10));
        QVERIFY(std::abs(client.state().pose[2] - pose[2]) < 1e-4);
        pose[2] += 0.02;
        client.sendLine("movep(p" + list(pose) + ", a=0.3, v=0.1, r=0)");
        QVERIFY(client.waitForMove(10));
        std::array<double, 6> via = pose;
        via[1] += 0.02;
        via[2] += 0.01;
        pose[2] += 0.03;
        client.sendLine("movec(p" + list(via) + ", p" + list(pose) + ", a=0.3, v=0.1, r=0)");
        QVERIFY(client.waitForMove(10));
        QVERIFY(std::abs(client.state().pose[2] - pose[2]) < 1e-3);
        // Several moves in one program, with blends except for the last move.
        std::array<double, 6> second = pose;
        second[1] -= 0.1;
        client.sendLine("def myProg():\n\tmovel(p" + list(second) + ",a=0.5,v=0.2,r=0.02)\n\tmovel(p" +
                        list(pose) + ",a=0.5,v=0.2,r=0)\nend");
        QVERIFY(client.waitForMove(15));
        QVERIFY(std::abs(client.state().pose[1] - pose[1]) < 1e-3);
        QCOMPARE(client.trouble, QByteArray());
    }

    void aLineClientSpeedsAndStops() {
        VirtualRobot robot;
        LineClient client(robot);
        QVERIFY(client.until([&] { return client.state().known; }, 2));
        const double z = client.state().pose[2];
        client.sendLine("speedl([0,0,0.05,0,0,0], 0.5, 1.0)");
        QVERIFY(client.until([&] { return client.state().pose[2] > z + 0.02; }, 2));
        client.sendLine("stopl(0.5)");
        QVERIFY(client.waitForMove(3) || !client.state().programRunning);
        QVERIFY(robot.stepUntil([&] { return robot.controller.truth().qd.values.norm() < 2e-3; }, 2));
        const double there = robot.controller.truth().tcpPose.position.z();
        client.step();
        QVERIFY(std::abs(robot.controller.truth().tcpPose.position.z() - there) < 1e-3);
        client.sendLine("speedj([0.2,0,0,0,0,0], 1.0, 0.5)");
        QVERIFY(client.until([&] { return robot.controller.truth().qd[0] > 0.1; }, 1));
        client.sendLine("stopj(1.0)");
        QVERIFY(client.until([&] { return robot.controller.truth().qd.values.norm() < 2e-3; }, 2));
    }

    void aLineClientConfiguresTheRobotAndSetsOutputs() {
        VirtualRobot robot;
        LineClient client(robot);
        QVERIFY(client.until([&] { return client.state().known; }, 2));
        client.sendLine("set_tcp(p[0,0,0.1,0,0,0])");
        client.step();
        client.sendLine("set_payload(1.2)");
        client.step();
        client.sendLine("set_payload(1.0, [0,0,0.05])");
        client.step();
        client.sendLine("set_gravity([0,0,9.82])");
        client.step();
        client.sendLine("set_standard_digital_out(3, True)");
        QVERIFY(client.until([&] { return (client.state().digitalOutputs >> 3 & 1U) != 0; }, 1));
        client.sendLine("set_digital_out(2, True)");
        QVERIFY(client.until([&] { return (client.state().digitalOutputs >> 2 & 1U) != 0; }, 1));
        client.sendLine("set_tool_voltage(24)");
        client.sendLine("set sim");
        client.sendLine("set real");
        client.step();
        QVERIFY(client.state().running);
    }

    void aLineClientReadsRealtimeRecords() {
        VirtualRobot robot;
        LineClient client(robot);
        QVERIFY(client.until([&] { return client.record().size() == 1220; }, 2));
        const QByteArray& record = client.record();
        QVERIFY(std::abs(doubleAt(record, 252) - client.state().joints[0]) < 1e-3);
        QVERIFY(std::abs(doubleAt(record, 444 + 16) - client.state().pose[2]) < 1e-3);
        QCOMPARE(doubleAt(record, 756), 7.0);
        QCOMPARE(doubleAt(record, 812), 1.0);
    }

    void aLineClientFreesTheArm() {
        VirtualRobot robot;
        LineClient client(robot);
        QVERIFY(client.until([&] { return client.state().known; }, 2));
        client.sendLine("def free():\n  freedrive_mode()\n  sleep(2)\n  end_freedrive_mode()\nend");
        robot.controller.pressHand({{0, 0, 25}, {0, 0, 0}});
        const double z = client.state().pose[2];
        QVERIFY(client.until([&] { return client.state().pose[2] > z + 0.03; }, 2));
        robot.controller.pressHand({});
        QVERIFY(client.until([&] { return !client.state().programRunning; }, 4));
    }
};

QTEST_GUILESS_MAIN(TestLineClients)
#include "tst_line_clients.moc"
