// SPDX-License-Identifier: MIT
//
// Tests of device tables: which row answers a request, and which errors in a table are reported.

#include <QTest>

#include "robot/simulator/equipment/device_table.h"
#include "robot/simulator/urscript/constants.h"
#include "robot/simulator/urscript/value_format.h"
#include "robot/simulator/urscript/xml_rpc.h"

using namespace tiller;
using namespace tiller::simulator;
using urscript::constantValue;
using urscript::Value;

namespace {

constexpr const char* kHead = "protocol xml-rpc\naddress 10.0.0.9:4242\n";

DeviceTable table(const QString& text) {
    Result<DeviceTable> parsed = DeviceTable::parse(QStringLiteral("t"), text);
    if (!parsed) {
        qFatal("%s", qPrintable(parsed.error().context));
    }
    return std::move(*parsed);
}

/// Reply to a call as text; "none" if no row matches.
QString answer(DeviceTable& device, const char* method, const std::vector<Value>& arguments) {
    const auto given = device.answer(method, arguments);
    return !given         ? QStringLiteral("none")
           : given->fault ? QStringLiteral("fault ") + QString::fromStdString(*given->fault)
                          : QString::fromStdString(urscript::toStr(given->value));
}

QString lineAnswer(DeviceTable& device, const char* line) {
    const auto given = device.answer(std::string_view(line));
    return !given         ? QStringLiteral("none")
           : given->fault ? QStringLiteral("fault ") + QString::fromStdString(*given->fault)
                          : QString::fromStdString(given->text);
}

}  // namespace

class TestDeviceTable : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void constantsUseTheProgramSyntax_data() {
        QTest::addColumn<QString>("value");
        const auto row = [](const char* text, const char* value) { QTest::newRow(text) << QString(value); };
        row("7", "7");
        row("-0.5", "-0.5");
        row("True", "True");
        row("\"a | b\"", "a | b");
        row("[1, 2.5]", "[1, 2.5]");
        row("[[1,2],[3,4]]", "[[1, 2], [3, 4]]");
        row("p[0.1,0,-0.2,0,3.1,0]", "p[0.1, 0, -0.2, 0, 3.1, 0]");
        row("struct(a=1, b=\"x\")", "struct(a=1, b=x)");
        row("get_actual_tcp_pose()", "error");
        row("1 y = 2", "error");
        row("[1, True]", "error");
        row("", "error");
    }
    void constantsUseTheProgramSyntax() {
        const Result<Value> value = constantValue(QTest::currentDataTag());
        QTEST(value ? QString::fromStdString(urscript::toStr(*value)) : QStringLiteral("error"), "value");
    }

    void aCallIsAnsweredByItsNameAndArguments() {
        DeviceTable device = table(QString(kHead) +
                                   "# name | arguments | answer | delay\n"
                                   "pose  | 1, *        | p[0.1,0,0,0,0,0] | 0.25\n"
                                   "pose  | 2, \"left\" | p[0.2,0,0,0,0,0]\n"
                                   "log   | *           |\n"
                                   "stop  |             | fault the camera is cold\n");
        QCOMPARE(device.port(), 4242);
        QCOMPARE(device.host(), QStringLiteral("10.0.0.9"));
        QCOMPARE(answer(device, "pose", {Value(1), Value(5)}), QStringLiteral("p[0.1, 0, 0, 0, 0, 0]"));
        QCOMPARE(device.answer("pose", std::vector<Value>{Value(1.0), Value(5)})->delay, 0.25);
        QCOMPARE(answer(device, "pose", {Value(2), Value(std::string("left"))}),
                 QStringLiteral("p[0.2, 0, 0, 0, 0, 0]"));
        QCOMPARE(answer(device, "pose", {Value(2), Value(std::string("right"))}), QStringLiteral("none"));
        QCOMPARE(answer(device, "pose", {Value(1)}), QStringLiteral("none"));
        QVERIFY(device.answer("log", std::vector<Value>{Value(1), Value(2), Value(3)})
                    ->value.is(Value::Type::None));
        QCOMPARE(answer(device, "stop", {}), QStringLiteral("fault the camera is cold"));
        QCOMPARE(answer(device, "stop", {Value(1)}), QStringLiteral("none"));
    }

    void identicalRowsAreUsedInTurn() {
        DeviceTable device =
            table(QString(kHead) + "ready | | False\nother | | 1\nready | | False\nready | | True\n");
        for (const char* wanted : {"False", "False", "True", "True"}) {
            QCOMPARE(answer(device, "ready", {}), QString(wanted));
        }
        QCOMPARE(answer(device, "other", {}), QStringLiteral("1"));
    }

    void linesAreMatchedByTheirPrefix() {
        DeviceTable device = table(
            "protocol lines\naddress camera:8500\n"
            "TRIGGER | | OK\n"
            "T1,0 | | (0.1,0.2)\\r\\c\n"
            "GET | POS | 17\\|18\n"
            "GET | *   | 0\n"
            "QUIET | |\n"
            "BYE | | fault\n");
        QCOMPARE(lineAnswer(device, "TRIGGER\r"), QStringLiteral("OK\n"));
        QCOMPARE(lineAnswer(device, "TRIGGERS"), QStringLiteral("none"));
        QCOMPARE(lineAnswer(device, "T1,0"), QStringLiteral("(0.1,0.2)\r"));
        QCOMPARE(lineAnswer(device, "GET POS"), QStringLiteral("17|18\n"));
        QCOMPARE(lineAnswer(device, "GET SPEED"), QStringLiteral("0\n"));
        QCOMPARE(lineAnswer(device, "QUIET"), QString());
        QCOMPARE(lineAnswer(device, "BYE"), QStringLiteral("fault "));
        QCOMPARE(lineAnswer(device, "WHO"), QStringLiteral("none"));
    }

    void errorsAreReported_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const QString& text, const char* reason) {
            QTest::newRow(name) << text << QString(reason);
        };
        row("no address", "protocol lines\n", "the address is missing");
        row("address", "protocol lines\naddress 10.0.0.9\n", "line 2: the address must have the form");
        row("protocol", "protocol modbus\n", "line 1: the protocol must be xml-rpc or lines, not 'modbus'");
        row("row first", "a | | 1\n", "line 1: 'protocol xml-rpc' or 'protocol lines' must come before");
        row("cells", QString(kHead) + "a 1\n",
            "line 3: a row must have the form NAME | ARGUMENTS | ANSWER | DELAY");
        row("name", QString(kHead) + " | | 1\n", "line 3: the name is missing");
        row("delay", QString(kHead) + "a | | 1 | soon\n", "line 3: 'soon' is not a delay");
        row("answer", QString(kHead) + "a | | 1 +\n", "line 3: the answer '1 +' is not a URScript value");
        row("argument", QString(kHead) + "a | b | 1\n", "line 3: the argument 'b' is not a URScript value");
    }
    void errorsAreReported() {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        const Result<DeviceTable> parsed = DeviceTable::parse(QStringLiteral("t"), text);
        QVERIFY(!parsed.ok());
        QCOMPARE(parsed.error().code, ErrorCode::FileCorrupt);
        QVERIFY2(parsed.error().context.contains(reason), qPrintable(parsed.error().context));
    }

    // Values written by the program are read by the server, and vice versa.
    void callsAndRepliesRoundTrip() {
        using namespace urscript;
        const std::vector<Value> values{Value(3),
                                        Value(0.5),
                                        Value(true),
                                        *constantValue("[1,2]"),
                                        *constantValue("p[1,2,3,0.1,0.2,0.3]"),
                                        Value(std::string("a<b"))};
        const Result<std::string> request = xml_rpc::request({"h", 80, "/RPC2"}, "m", values);
        QVERIFY(request.ok());
        const Result<xml_rpc::MethodCall> call =
            xml_rpc::readCall(request->substr(request->find("\r\n\r\n") + 4));
        QVERIFY(call.ok());
        QCOMPARE(call->method, std::string("m"));
        QCOMPARE(call->arguments.size(), values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            QVERIFY(call->arguments[i].equals(values[i]));
            const std::string body = xml_rpc::response(values[i]);
            const auto reply = xml_rpc::reply(
                "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body,
                false);
            QVERIFY(reply.ok() && reply->has_value());
            QVERIFY((*reply)->equals(values[i]));
        }
        QVERIFY(!xml_rpc::readCall("<methodCall><methodName>m</methodName><params><param/></params>").ok());
        QVERIFY(!xml_rpc::readCall("GET").ok());
    }
};

QTEST_GUILESS_MAIN(TestDeviceTable)
#include "tst_device_table.moc"
