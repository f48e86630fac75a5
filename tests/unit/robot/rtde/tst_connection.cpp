// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>
#include <chrono>

#include "robot/rtde/connection.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace tiller::rtde;
using namespace std::chrono_literals;
using test::RtdePeer;
using test::ScriptedPeer;

namespace {

// Timeout that is sufficient for any machine. Only a hanging test uses the whole time.
constexpr auto kTestTimeout = 20s;

ConnectionOptions to(std::uint16_t port, std::vector<std::string> outputs = {"timestamp", "actual_q"}) {
    ConnectionOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = port;
    options.request.outputs = std::move(outputs);
    return options;
}

Result<std::unique_ptr<Connection>> open(const ConnectionOptions& options,
                                         std::chrono::milliseconds time = kTestTimeout) {
    return Connection::open(options, Deadline::after(time));
}

std::uint16_t portNobodyListensOn() {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

}  // namespace

class TestConnection : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void receivesData();
    void speaksVersionOne();
    void survivesTextMessagesEverywhere();
    void sendsInputs();
    void inputsWorkWithoutOutputs();
    void invalidRecipeCannotBeSent();
    void pausesAndStarts();
    void errorsNameHostAndPort_data();
    void errorsNameHostAndPort();
    void aSilentPeerCausesATimeout();
    void cancelEndsTheWait();
    void aDisconnectDuringTheHandshakeIsReported_data();
    void aDisconnectDuringTheHandshakeIsReported();
    void partialPackagesAreCompleted();
    void garbageIsAProtocolError();
    void dataThatDoNotFitTheRecipeAreMalformed();
    void noticesTheEnd();
    void aFloodOfTextDoesNotBlockTheReader();
    void slowReaderOfInputsNeverBlocks();
    void closesAtOnceWhateverThePeerDoes();
};

void TestConnection::receivesData() {
    RtdePeer peer;
    peer.set("actual_q", {1, 2, 3, 4, 5, -6.5});
    auto connection = open(to(peer.port()));
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    QCOMPARE((*connection)->version().major, 5U);
    QCOMPARE((*connection)->protocol(), ProtocolVersion::V2);
    QCOMPARE((*connection)->period(), 0.002);
    QCOMPARE(peer.outputs().frequency, 500.0);

    for (int i = 1; i <= 100; ++i) {
        peer.send(i * 0.002);
    }
    std::array<double, 7> values{};
    for (int i = 1; i <= 100; ++i) {
        QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Package);
        QCOMPARE(values[0], i * 0.002);
        QCOMPARE(values[6], -6.5);
    }
    QCOMPARE((*connection)->readPackage(values, 0ns), Connection::Read::Nothing);
    QVERIFY(!(*connection)->hasPackage());
}

void TestConnection::speaksVersionOne() {
    test::RtdePeerOptions robot;
    robot.highestProtocol = 1;
    robot.version = {3, 3, 4, 0};
    RtdePeer peer(robot);
    auto connection = open(to(peer.port()));
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    QCOMPARE((*connection)->protocol(), ProtocolVersion::V1);
    QCOMPARE((*connection)->period(), 0.008);
    peer.send(4.5);
    std::array<double, 7> values{};
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Package);
    QCOMPARE(values[0], 4.5);
}

void TestConnection::survivesTextMessagesEverywhere() {
    test::RtdePeerOptions robot;
    robot.textBeforeEveryReply = true;
    robot.version = {10, 11, 0, 0};
    RtdePeer peer(robot);
    auto connection = open(to(peer.port()));
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    QCOMPARE((*connection)->session().texts().size(), std::size_t(4));
    Bytes text;
    writeControllerText(text, ProtocolVersion::V2, {TextLevel::Error, "in between", "x"});
    peer.sendRaw(text);
    peer.send(1.0);
    std::array<double, 7> values{};
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Package);
    QTRY_COMPARE_WITH_TIMEOUT(
        ((*connection)->readPackage(values, 0ns), (*connection)->session().texts().back().message),
        std::string("in between"), 20000);
}

void TestConnection::sendsInputs() {
    RtdePeer peer;
    auto options = to(peer.port());
    options.request.inputs.push_back({{"input_int_register_24", "input_double_register_24"}, true});
    options.request.inputs.push_back({{"external_force_torque"}, true});
    auto connection = open(options);
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    QCOMPARE((*connection)->sendInputs(0, std::array{-7.0, 0.25}), Connection::Send::Sent);
    QCOMPARE((*connection)->sendInputs(1, std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}), Connection::Send::Sent);
    QTRY_COMPARE_WITH_TIMEOUT(peer.inputPackages(), 2, 20000);
    QCOMPARE(peer.input("input_int_register_24"), std::vector<double>{-7});
    QCOMPARE(peer.input("input_double_register_24"), std::vector<double>{0.25});
    QCOMPARE(peer.input("external_force_torque"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

void TestConnection::inputsWorkWithoutOutputs() {
    RtdePeer peer;
    auto options = to(peer.port(), {});
    options.request.inputs.push_back({{"speed_slider_mask", "speed_slider_fraction"}, true});
    auto connection = open(options);
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    QCOMPARE((*connection)->sendInputs(0, std::array{1.0, 0.5}), Connection::Send::Sent);
    QTRY_COMPARE_WITH_TIMEOUT(peer.inputPackages(), 1, 20000);
    QVERIFY(!peer.isStarted());
    QCOMPARE((*connection)->start(Deadline::after(kTestTimeout)).error().code, ErrorCode::Rejected);
}

void TestConnection::invalidRecipeCannotBeSent() {
    test::RtdePeerOptions robot;
    robot.missing = {"input_int_register_24"};
    RtdePeer peer(robot);
    auto options = to(peer.port());
    options.request.inputs.push_back({{"input_int_register_24"}, true});
    auto connection = open(options);
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    QCOMPARE((*connection)->sendInputs(0, std::array{1.0}), Connection::Send::Failed);
    QCOMPARE((*connection)->sendInputs(1, std::array{1.0}), Connection::Send::Failed);
}

void TestConnection::pausesAndStarts() {
    RtdePeer peer;
    auto connection = open(to(peer.port()));
    QVERIFY(connection.ok());
    QVERIFY(peer.isStarted());
    QVERIFY((*connection)->pause(Deadline::after(kTestTimeout)).ok());
    QVERIFY(!peer.isStarted());
    QVERIFY((*connection)->start(Deadline::after(kTestTimeout)).ok());
    peer.send(3.0);
    std::array<double, 7> values{};
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Package);
    QCOMPARE(values[0], 3.0);
}

void TestConnection::errorsNameHostAndPort_data() {
    QTest::addColumn<QString>("host");
    QTest::addColumn<int>("code");
    QTest::newRow("refused") << "127.0.0.1" << int(ErrorCode::ConnectionRefused);
    QTest::newRow("empty") << " " << int(ErrorCode::AddressInvalid);
    QTest::newRow("no such name") << "no such host.invalid" << int(ErrorCode::AddressInvalid);
}

void TestConnection::errorsNameHostAndPort() {
    QFETCH(QString, host);
    QFETCH(int, code);
    auto options = to(portNobodyListensOn());
    options.host = host;
    const auto connection = open(options);
    QVERIFY(!connection.ok());
    QCOMPARE(int(connection.error().code), code);
    const QString peer = QStringLiteral("%1:%2").arg(host.trimmed()).arg(options.port);
    QVERIFY2(connection.error().context.contains(peer), qPrintable(connection.error().context));
}

void TestConnection::aSilentPeerCausesATimeout() {
    ScriptedPeer peer([](ScriptedPeer::Link& link) { link.beMute(); });
    const auto connection = open(to(peer.port()), 100ms);
    QCOMPARE(connection.error().code, ErrorCode::Timeout);
    QVERIFY2(connection.error().context.contains(QLatin1String("RTDE_REQUEST_PROTOCOL_VERSION")),
             qPrintable(connection.error().context));
}

void TestConnection::cancelEndsTheWait() {
    const CancelToken token;
    ScriptedPeer peer([&](ScriptedPeer::Link& link) {
        while (!link.isOver() && !link.nextPackage()) {
        }
        token.cancel();
        link.beMute();
    });
    const auto connection = Connection::open(to(peer.port()), Deadline::after(1h, token));
    QCOMPARE(connection.error().code, ErrorCode::Cancelled);
}

void TestConnection::aDisconnectDuringTheHandshakeIsReported_data() {
    QTest::addColumn<int>("answers");
    for (int answers = 0; answers < 4; ++answers) {
        QTest::addRow("after %d answers", answers) << answers;
    }
}

void TestConnection::aDisconnectDuringTheHandshakeIsReported() {
    QFETCH(int, answers);
    ScriptedPeer peer([&](ScriptedPeer::Link& link) {
        int left = answers;
        while (!link.isOver()) {
            const auto package = link.nextPackage();
            if (!package) {
                continue;
            }
            if (left-- == 0) {
                return;
            }
            Bytes out;
            switch (package->type) {
                case PackageType::RequestProtocolVersion:
                    writeProtocolReply(out, true);
                    break;
                case PackageType::GetUrControlVersion:
                    writeVersionReply(out, {5, 22, 0, 0});
                    break;
                default:
                    writeSetupOutputsReply(
                        out, ProtocolVersion::V2, 1,
                        std::array{FieldAnswer::of(DataType::Double), FieldAnswer::of(DataType::Vector6D)});
            }
            link.send(out);
        }
    });
    const auto connection = open(to(peer.port()));
    QCOMPARE(connection.error().code, ErrorCode::ConnectionClosed);
    QVERIFY2(connection.error().context.contains(QLatin1String("the reply to RTDE_")),
             qPrintable(connection.error().context));
}

void TestConnection::partialPackagesAreCompleted() {
    RtdePeer peer;
    auto connection = open(to(peer.port()));
    QVERIFY(connection.ok());
    const ValueLayout layout({DataType::Double, DataType::Vector6D});
    Bytes package(dataPackageSize(layout.wireBytes(), true));
    QVERIFY(writeDataPackage(package, 1, layout, std::array{9.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) != 0);
    std::array<double, 7> values{};
    for (std::size_t cut = 1; cut < package.size(); ++cut) {
        peer.sendRaw(Bytes(package.begin(), package.begin() + static_cast<std::ptrdiff_t>(cut)));
        QCOMPARE((*connection)->readPackage(values, 1ms), Connection::Read::Nothing);
        peer.sendRaw(Bytes(package.begin() + static_cast<std::ptrdiff_t>(cut), package.end()));
        QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Package);
        QCOMPARE(values[6], 6.0);
    }
}

void TestConnection::garbageIsAProtocolError() {
    RtdePeer peer;
    auto connection = open(to(peer.port()));
    QVERIFY(connection.ok());
    peer.sendRaw({0, 1, 'U'});
    std::array<double, 7> values{};
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Malformed);
    QCOMPARE((*connection)->error().code, ErrorCode::ProtocolError);
    QVERIFY((*connection)->error().context.contains((*connection)->peer()));
}

void TestConnection::dataThatDoNotFitTheRecipeAreMalformed() {
    for (const Bytes& wrong : {Bytes{0, 3, 'U'}, Bytes{0, 5, 'U', 1, 0}, Bytes{0, 4, 'U', 9}}) {
        RtdePeer peer;
        auto connection = open(to(peer.port()));
        QVERIFY(connection.ok());
        peer.sendRaw(wrong);
        std::array<double, 7> values{};
        QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Malformed);
        QCOMPARE((*connection)->error().code, ErrorCode::ProtocolError);
    }
}

void TestConnection::noticesTheEnd() {
    RtdePeer peer;
    auto connection = open(to(peer.port()));
    QVERIFY(connection.ok());
    peer.send(1.0);
    std::array<double, 7> values{};
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Package);
    peer.closeConnection();
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Closed);
    QCOMPARE((*connection)->error().code, ErrorCode::ConnectionClosed);
}

void TestConnection::aFloodOfTextDoesNotBlockTheReader() {
    // Sends text messages as fast as the connection accepts them, until the client disconnects.
    Bytes texts;
    for (int i = 0; i < 100; ++i) {
        writeControllerText(texts, ProtocolVersion::V2, {TextLevel::Info, std::string(200, 'x'), "flood"});
    }
    ScriptedPeer peer([&](ScriptedPeer::Link& link) {
        bool started = false;
        while (!link.isOver()) {
            if (started) {
                link.send(texts);
                continue;
            }
            const auto package = link.nextPackage();
            if (!package) {
                continue;
            }
            Bytes out;
            if (package->type == PackageType::RequestProtocolVersion) {
                writeProtocolReply(out, true);
            } else if (package->type == PackageType::GetUrControlVersion) {
                writeVersionReply(out, {5, 22, 0, 0});
            } else if (package->type == PackageType::SetupOutputs) {
                writeSetupOutputsReply(
                    out, ProtocolVersion::V2, 1,
                    std::array{FieldAnswer::of(DataType::Double), FieldAnswer::of(DataType::Vector6D)});
            } else {
                writeStartReply(out, true);
                started = true;
            }
            link.send(out);
        }
    });
    auto connection = open(to(peer.port()));
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    std::array<double, 7> values{};
    for (int i = 0; i < 3; ++i) {
        QCOMPARE((*connection)->readPackage(values, 5ms), Connection::Read::Nothing);
        QCOMPARE((*connection)->readPackage(values, 0ns), Connection::Read::Nothing);
    }
}

void TestConnection::slowReaderOfInputsNeverBlocks() {
    // Replies to the handshake and then stops reading.
    std::atomic<bool> drain{false};
    ScriptedPeer peer([&](ScriptedPeer::Link& link) {
        for (int answers = 0; answers < 3 && !link.isOver();) {
            const auto package = link.nextPackage();
            if (!package) {
                continue;
            }
            Bytes out;
            if (package->type == PackageType::RequestProtocolVersion) {
                writeProtocolReply(out, true);
            } else if (package->type == PackageType::GetUrControlVersion) {
                writeVersionReply(out, {5, 22, 0, 0});
            } else {
                writeSetupInputsReply(out, 1,
                                      std::vector<FieldAnswer>(40, FieldAnswer::of(DataType::Double)));
            }
            link.send(out);
            ++answers;
        }
        while (!drain && !link.isOver()) {
            std::this_thread::yield();
        }
        int whole = 0;
        while (!link.isOver()) {
            if (const auto package = link.nextPackage()) {
                // No package is incomplete, even if many packages were dropped.
                whole = package->payload.size() == 1 + 40 * 8 ? whole + 1 : -1000000;
                if (whole < 0) {
                    return;
                }
            }
        }
    });
    ConnectionOptions options = to(peer.port(), {});
    options.request.inputs.emplace_back();
    for (int i = 0; i < 40; ++i) {
        options.request.inputs[0].names.push_back("input_double_register_" + std::to_string(i));
    }
    auto connection = open(options);
    QVERIFY2(connection.ok(), qPrintable(connection.error().toString()));
    const std::array<double, 40> values{};
    bool busy = false;
    for (int i = 0; i < 200000 && !busy; ++i) {
        const auto sent = (*connection)->sendInputs(0, values);
        QVERIFY(sent != Connection::Send::Failed);
        busy = sent == Connection::Send::Busy;
    }
    QVERIFY(busy);
    drain = true;
    // When the peer reads again, sending resumes and the stream is still synchronized.
    QTRY_COMPARE_WITH_TIMEOUT((*connection)->sendInputs(0, values), Connection::Send::Sent, 20000);
    for (int i = 0; i < 100; ++i) {
        QVERIFY((*connection)->sendInputs(0, values) != Connection::Send::Failed);
    }
}

void TestConnection::closesAtOnceWhateverThePeerDoes() {
    RtdePeer peer;
    auto connection = open(to(peer.port()));
    QVERIFY(connection.ok());
    QVERIFY((*connection)->isOpen());
    (*connection)->close();
    QVERIFY(!(*connection)->isOpen());
    std::array<double, 7> values{};
    QCOMPARE((*connection)->readPackage(values, kTestTimeout), Connection::Read::Failed);
    QCOMPARE((*connection)->sendInputs(0, values), Connection::Send::Failed);
    QCOMPARE((*connection)->pause(Deadline::after(kTestTimeout)).error().code, ErrorCode::NotConnected);
    (*connection)->close();
    QTRY_VERIFY_WITH_TIMEOUT(!peer.isStarted(), 20000);
}

QTEST_GUILESS_MAIN(TestConnection)
#include "tst_connection.moc"
