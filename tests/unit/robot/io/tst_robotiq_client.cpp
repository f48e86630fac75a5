// SPDX-License-Identifier: MIT
// The client of the gripper's socket, with a peer controlled by the test.
#include <QTest>
#include <limits>
#include <map>

#include "robot/io/robotiq_client.h"
#include "tests/support/raw_peer.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::io;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

/// The variables of a gripper, served as by the URCap. Received lines are stored.
struct Gripper {
    std::map<QByteArray, int> values{{"STA", 3},   {"FLT", 0}, {"GTO", 1},
                                     {"PRE", 255}, {"OBJ", 2}, {"POS", 120}};
    QByteArrayList lines;  ///< lines of the newest connection; read them after the client has disconnected
    int staleAnswers = 0;  ///< number of replies in which PRE still belongs to the previous motion
    bool resets = true;

    QByteArray answer(const QByteArray& line) {
        lines << line;
        const QByteArrayList words = line.split(' ');
        if (words[0] == "GET") {
            const QByteArray& name = words[1];
            if (name == "PRE" && staleAnswers > 0) {
                --staleAnswers;
                return "PRE 7\n";
            }
            return name + ' ' + (values.contains(name) ? QByteArray::number(values[name]) : "?") + '\n';
        }
        for (qsizetype i = 1; i + 1 < words.size(); i += 2) {
            if (words[i] == "POS") {
                values["PRE"] = words[i + 1].toInt();
            } else if (words[i] == "ACT" && resets) {
                values["STA"] = words[i + 1].toInt();  // 1: activation in progress
            } else {
                values[words[i]] = words[i + 1].toInt();
            }
        }
        return "ack";
    }
    void serve(RawPeer::Link& link) {
        lines.clear();
        for (QByteArray line = link.readLine(); !line.isNull(); line = link.readLine()) {
            link.send(answer(line));
        }
    }
};

/// A peer and a client connected to it.
struct Bench {
    explicit Bench(std::function<void(RawPeer::Link&)> script)
        : peer(std::move(script)), client("127.0.0.1", peer.port()) {
        const Result<void> connected = client.connect(testTimeout());
        if (!connected) {
            qFatal("%s", why(connected).constData());
        }
    }
    RawPeer peer;
    RobotiqClient client;
};

/// Answers one line with each of these replies, then stops responding.
std::function<void(RawPeer::Link&)> saying(const QByteArrayList& answers) {
    return [answers](RawPeer::Link& link) {
        for (const QByteArray& answer : answers) {
            if (link.readLine().isNull()) {
                return;
            }
            link.send(answer);
        }
        link.beMute();
    };
}

Deadline briefly() {
    return Deadline::after(milliseconds(200));
}

}  // namespace

class TestRobotiqClient : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fragmentedValuesAreRead() {
        Bench bench([](RawPeer::Link& link) {
            link.readLine();
            link.send("PO");
            link.send("S 1");
            link.send("20\r\n");
            link.readLine();
            link.send("STA 03 \n");
            link.beMute();
        });
        QCOMPARE(bench.client.get("POS", testTimeout()).value(), std::optional(120));
        QCOMPARE(bench.client.get("STA", testTimeout()).value(), std::optional(3));
    }

    void aMissingValueIsNotReadAsZero() {
        Bench bench(saying({"POS ?\n"}));
        QCOMPARE(bench.client.get("POS", testTimeout()).value(), std::optional<int>());
        QVERIFY(bench.client.isConnected());
    }

    void acknowledgementsMayLackALineEnd() {
        Bench bench(saying({"ack", "ack\n", "POS 3\n"}));
        QVERIFY(bench.client.set({{"SPE", 1}}, testTimeout()).ok());
        QVERIFY(bench.client.set({{"FOR", 1}}, testTimeout()).ok());
        QCOMPARE(bench.client.get("POS", testTimeout()).value(), std::optional(3));
    }

    void aRefusalIsReported() {
        Bench bench(saying({"nack", "POS 3\n"}));
        const Result<void> refused = bench.client.set({{"NIX", 1}}, testTimeout());
        QCOMPARE(refused.error().code, ErrorCode::Rejected);
        QCOMPARE(refused.error().controllerMessage, QString("nack"));
        QCOMPARE(bench.client.get("POS", testTimeout()).value(), std::optional(3));
    }

    void theReplyToAnotherRequestIsNotAccepted() {
        Bench bench(saying({"OBJ 2\n", "POS hello\n"}));
        for (const char* answer : {"OBJ 2", "POS hello"}) {
            const auto wrong = bench.client.get("POS", testTimeout());
            QCOMPARE(wrong.error().code, ErrorCode::ProtocolError);
            QCOMPARE(wrong.error().controllerMessage, QString(answer));
        }
    }

    void aSilentGripperEndsWithTheDeadline() {
        Bench bench([](RawPeer::Link& link) { link.beMute(); });
        const auto look = bench.client.look(briefly());
        QCOMPARE(look.error().code, ErrorCode::Timeout);
        QVERIFY2(look.error().context.contains("GET STA"), why(look).constData());
        QVERIFY2(!bench.client.isConnected(), "a late reply would be used as the next reply");
        QCOMPARE(bench.client.get("POS", briefly()).error().code, ErrorCode::NotConnected);
        QVERIFY(bench.client.connect(testTimeout()).ok());
    }

    void aWaitCanBeCancelledEarly() {
        Bench bench([](RawPeer::Link& link) { link.beMute(); });
        const CancelToken token;
        token.cancel();
        QCOMPARE(bench.client.move(0, 0, 0, Deadline::never(token)).error().code, ErrorCode::Cancelled);
    }

    void anUnterminatedReplyIsBounded() {
        Bench bench([](RawPeer::Link& link) {
            const QByteArray flood(256, 'x');
            while (!link.isOver()) {
                link.send(flood);
            }
        });
        const auto got = bench.client.get("POS", testTimeout());
        QCOMPARE(got.error().code, ErrorCode::ProtocolError);
        QVERIFY(got.error().controllerMessage.startsWith("xxx"));
        QVERIFY(got.error().controllerMessage.size() < 200);
        QVERIFY2(!bench.client.isConnected(),
                 "the start of the next reply is unknown, so the client must disconnect");
    }

    void aContinuousSenderDoesNotExceedTheDeadline() {
        Bench bench([](RawPeer::Link& link) {
            const QByteArray nothing(256, '\n');
            while (!link.isOver()) {
                link.send(nothing);
            }
        });
        QCOMPARE(bench.client.get("POS", briefly()).error().code, ErrorCode::Timeout);
        QVERIFY(bench.client.connect(testTimeout()).ok());
        const CancelToken token;
        token.cancel();
        QCOMPARE(bench.client.get("POS", Deadline::never(token)).error().code, ErrorCode::Cancelled);
    }

    void outOfRangeValuesAreRejected_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("value");
        for (const char* name : {"STA", "FLT", "GTO", "PRE", "OBJ", "POS"}) {
            for (const int value :
                 {-1, 256, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
                QTest::addRow("%s %d", name, value) << QByteArray(name) << value;
            }
        }
    }
    void outOfRangeValuesAreRejected() {
        QFETCH(QByteArray, name);
        QFETCH(int, value);
        Gripper gripper;
        gripper.values[name] = value;
        Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        const auto look = bench.client.look(testTimeout());
        QVERIFY(!look.ok());
        QCOMPARE(look.error().code, ErrorCode::ProtocolError);
        QCOMPARE(look.error().controllerMessage, QString::fromLatin1(name) + ' ' + QString::number(value));
        const auto got = bench.client.get(name.toStdString(), testTimeout());
        QCOMPARE(got.error().code, ErrorCode::ProtocolError);
    }

    void aCounterMayExceedOneByte() {
        Bench bench(saying({"NCY 70000\n", "POS 255\n", "POS 0\n"}));
        QCOMPARE(bench.client.get("NCY", testTimeout()).value(), std::optional(70'000));
        QCOMPARE(bench.client.get("POS", testTimeout()).value(), std::optional(255));
        QCOMPARE(bench.client.get("POS", testTimeout()).value(), std::optional(0));
    }

    void aDisconnectByThePeerIsReported() {
        Bench bench([](RawPeer::Link& link) { link.readLine(); });
        QCOMPARE(bench.client.get("POS", testTimeout()).error().code, ErrorCode::ConnectionClosed);
        QVERIFY(!bench.client.isConnected());
    }

    void aRefusedConnectionIsReported() {
        RobotiqClient client("127.0.0.1", RawPeer::deadPort());
        QCOMPARE(client.connect(testTimeout()).error().code, ErrorCode::ConnectionRefused);
    }

    void oneQueryReadsTheWholeState() {
        Gripper gripper;
        Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        const auto look = bench.client.look(testTimeout());
        QVERIFY2(look.ok() && look->has_value(), why(look).constData());
        const RobotiqState& state = **look;
        QCOMPARE(state.activation, RobotiqActivation::Active);
        QCOMPARE(state.object, RobotiqObject::StoppedClosing);
        QCOMPARE(state.fault, RobotiqFault::None);
        QCOMPARE(state.position, 120);
        QCOMPARE(state.requested, 255);
        QVERIFY(state.goTo);
        QVERIFY(state.holds());
    }

    void noObjectIsHeldBeforeAMotionWasRequested_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("value");
        QTest::addColumn<bool>("holds");
        QTest::newRow("from outside") << QByteArray("OBJ") << 2 << true;
        QTest::newRow("from inside") << QByteArray("OBJ") << 1 << true;
        QTest::newRow("moving") << QByteArray("OBJ") << 0 << false;
        QTest::newRow("there") << QByteArray("OBJ") << 3 << false;
        QTest::newRow("not asked") << QByteArray("GTO") << 0 << false;
        QTest::newRow("not active") << QByteArray("STA") << 0 << false;
    }
    void noObjectIsHeldBeforeAMotionWasRequested() {
        QFETCH(QByteArray, name);
        QFETCH(int, value);
        QFETCH(bool, holds);
        Gripper gripper;
        gripper.values[name] = value;
        Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        const auto look = bench.client.look(testTimeout());
        QVERIFY2(look.ok() && look->has_value(), why(look).constData());
        QCOMPARE((*look)->holds(), holds);
    }

    void withoutPowerThereIsNoState() {
        Gripper gripper;
        gripper.values.erase("OBJ");
        Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        const auto look = bench.client.look(testTimeout());
        QVERIFY2(look.ok(), why(look).constData());
        QVERIFY(!look->has_value());
    }

    void aMoveReturnsAfterItWasAccepted() {
        Gripper gripper;
        gripper.staleAnswers = 3;
        {
            Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
            const Result<void> moved = bench.client.move(80, 255, 10, testTimeout());
            QVERIFY2(moved.ok(), why(moved).constData());
        }
        QCOMPARE(gripper.lines.value(0), QByteArray("SET POS 80 SPE 255 FOR 10 GTO 1"));
        QCOMPARE(gripper.lines.count("GET PRE"), 4);
    }

    void aMoveThatIsNotAcceptedIsReported() {
        Gripper gripper;
        gripper.staleAnswers = 1'000'000;
        Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        QCOMPARE(bench.client.move(80, 255, 10, Deadline::after(milliseconds(1000))).error().code,
                 ErrorCode::Rejected);
    }

    void valuesOutOfRangeAreNotSent() {
        Gripper gripper;
        {
            Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
            for (const auto& [position, speed, force] :
                 {std::tuple(256, 0, 0), std::tuple(0, -1, 0), std::tuple(0, 0, 999)}) {
                QCOMPARE(bench.client.move(position, speed, force, testTimeout()).error().code,
                         ErrorCode::InvalidArgument);
            }
        }
        QVERIFY(gripper.lines.isEmpty());
    }

    void anActivationStartsWithAReset() {
        Gripper gripper;
        {
            Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
            const Result<void> begun = bench.client.beginActivation(testTimeout());
            QVERIFY2(begun.ok(), why(begun).constData());
        }
        QCOMPARE(gripper.lines, (QByteArrayList{"SET ACT 0 ATR 0", "GET STA", "SET ACT 1"}));
    }

    void aGripperThatDoesNotBecomeResetIsNotActivated() {
        Gripper gripper;
        gripper.resets = false;
        {
            Bench bench([&gripper](RawPeer::Link& link) { gripper.serve(link); });
            QCOMPARE(bench.client.beginActivation(Deadline::after(milliseconds(1000))).error().code,
                     ErrorCode::Rejected);
        }
        QVERIFY(!gripper.lines.contains("SET ACT 1"));
    }
};

QTEST_GUILESS_MAIN(TestRobotiqClient)
#include "tst_robotiq_client.moc"
