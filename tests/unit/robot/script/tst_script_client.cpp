// SPDX-License-Identifier: MIT
#include <QTest>
#include <future>

#include "robot/script/script_client.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::script;
using std::chrono::milliseconds;
using test::RawPeer;

namespace {

Deadline soon() {
    return Deadline::after(milliseconds(20000));
}

}  // namespace

class TestScriptClient : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theProgramArrivesCompleteAndEndsWithANewline() {
        std::promise<QByteArray> arrived;
        RawPeer peer([&](RawPeer::Link& link) { arrived.set_value(link.readAll()); });
        QString text = QStringLiteral("def f():\n");
        for (int i = 0; i < 5000; ++i) {
            text += QStringLiteral("  textmsg(\"line %1\")\n").arg(i);
        }
        text += QStringLiteral("end");
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QVERIFY(client.send(text, soon()).ok());
        client.close();
        QCOMPARE(arrived.get_future().get(), text.toUtf8() + '\n');
    }

    // If data from the controller are unread, closing the connection sends a reset, which could discard the
    // sent program.
    void connectionIsClosedCleanly() {
        std::promise<bool> ended;
        std::promise<void> streamed;
        RawPeer peer([&](RawPeer::Link& link) {
            link.readLine();
            link.send(QByteArray(100'000, 'x'));
            streamed.set_value();
            link.readAll();
            ended.set_value(link.endedInOrder());
        });
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QVERIFY(client.send(QStringLiteral("textmsg(\"a\")"), soon()).ok());
        streamed.get_future().wait();
        client.close();
        QVERIFY(ended.get_future().get());
    }

    void theConnectionStaysOpenAfterSending() {
        RawPeer peer([](RawPeer::Link& link) {
            link.readLine();
            link.beMute();
        });
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QVERIFY(client.send(QStringLiteral("textmsg(\"a\")"), soon()).ok());
        QVERIFY(client.isConnected());
        QVERIFY(client.send(QStringLiteral("textmsg(\"b\")\n"), soon()).ok());
    }

    void anyThreadMaySend() {
        std::promise<QByteArray> arrived;
        RawPeer peer([&](RawPeer::Link& link) { arrived.set_value(link.readAll()); });
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QVERIFY(std::async(std::launch::async, [&] {
                    return client.send(QStringLiteral("textmsg(\"a\")"), soon()).ok();
                }).get());
        client.close();
        QCOMPARE(arrived.get_future().get(), QByteArray("textmsg(\"a\")\n"));
    }

    // The client must not take received data as proof that the connection is still open.
    void aDisconnectIsDetectedBeforeSending() {
        RawPeer peer([](RawPeer::Link& link) { link.send(QByteArray(100'000, 'x')); });
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QTRY_VERIFY_WITH_TIMEOUT(!client.isConnected(), 20000);
        QCOMPARE(client.send(QStringLiteral("halt"), soon()).error().code, ErrorCode::NotConnected);
    }

    void nothingIsSentWithoutAConnection() {
        ScriptClient client(QStringLiteral("127.0.0.1"), 1);
        QCOMPARE(client.send(QStringLiteral("halt"), soon()).error().code, ErrorCode::NotConnected);
    }

    void anEmptyProgramIsRefused() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        QCOMPARE(client.send(QStringLiteral(" \n"), soon()).error().code, ErrorCode::InvalidArgument);
    }

    void aRefusedPortNamesTheAddress() {
        const int port = RawPeer::deadPort();
        ScriptClient client(QStringLiteral("127.0.0.1"), port);
        const Error error = client.connect(soon()).error();
        QCOMPARE(error.code, ErrorCode::ConnectionRefused);
        QVERIFY(error.context.contains(QStringLiteral("127.0.0.1:%1").arg(port)));
    }

    void anEmptyAddressIsRefused() {
        QCOMPARE(ScriptClient(QStringLiteral("  ")).connect(soon()).error().code, ErrorCode::AddressInvalid);
        QCOMPARE(ScriptClient(QStringLiteral("127.0.0.1"), 70000).connect(soon()).error().code,
                 ErrorCode::AddressInvalid);
    }

    void aCancelledConnectEndsAtOnce() {
        const CancelToken token;
        token.cancel();
        // An address reserved for documentation, which does not respond.
        ScriptClient client(QStringLiteral("192.0.2.1"));
        const ErrorCode code = client.connect(Deadline::after(milliseconds(600'000), token)).error().code;
        QVERIFY(code == ErrorCode::Cancelled || code == ErrorCode::HostUnreachable);
    }

    // If a controller is not reading, the sender gives up at its deadline and closes the connection, so that
    // no partial program remains in the stream.
    void aFullSendBufferTimesOutAndEndsTheConnection() {
        std::promise<void> done;
        RawPeer peer([&, wait = done.get_future().share()](RawPeer::Link&) { wait.wait(); });
        ScriptClient client(QStringLiteral("127.0.0.1"), peer.port());
        QVERIFY(client.connect(soon()).ok());
        const QString huge = QString(64 * 1024 * 1024, QLatin1Char('#'));
        const auto result = client.send(huge, Deadline::after(milliseconds(300)));
        done.set_value();
        QCOMPARE(result.error().code, ErrorCode::Timeout);
        QVERIFY(!client.isConnected());
    }
};

QTEST_GUILESS_MAIN(TestScriptClient)
#include "tst_script_client.moc"
