// SPDX-License-Identifier: MIT
// XML-RPC: the request of a call, the handling of replies, and program execution while a call blocks.

#include "robot/simulator/urscript/value_format.h"
#include "robot/simulator/urscript/xml_rpc.h"
#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;

namespace {

std::string ok(const std::string& value) {
    const std::string body = "<?xml version='1.0'?>\n<methodResponse>\n <params>\n  <param>\n   <value>" +
                             value + "</value>\n  </param>\n </params>\n</methodResponse>\n";
    return "HTTP/1.0 200 OK\r\nServer: test\r\nContent-length: " + std::to_string(body.size()) + "\r\n\r\n" +
           body;
}

/// Value of a reply in the format of to_str, "error: ...", or "more".
std::string read(const std::string& reply, bool ended = true) {
    const auto outcome = xml_rpc::reply(reply, ended);
    if (!outcome.ok()) {
        return "error: " + outcome.error().controllerMessage.toStdString();
    }
    return outcome->has_value() ? toStr(**outcome) : "more";
}

}  // namespace

class tst_RemoteCalls : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void addressesAreParsed() {
        const auto address = xml_rpc::parseAddress("http://127.0.0.1:8000/RPC2");
        QVERIFY(address);
        QCOMPARE(address->host, "127.0.0.1");
        QCOMPARE(address->port, 8000);
        QCOMPARE(address->path, "/RPC2");
        QCOMPARE(xml_rpc::parseAddress("localhost:5000")->port, 5000);
        QCOMPARE(xml_rpc::parseAddress("http://host")->path, "/");
        QVERIFY(!xml_rpc::parseAddress("ftp://host"));
        QVERIFY(!xml_rpc::parseAddress(""));
    }
    void repliesBecomeValues_data() {
        QTest::addColumn<QString>("xml");
        QTest::addColumn<QString>("value");
        const auto row = [](const char* xml, const char* value) { QTest::newRow(xml) << xml << value; };
        row("<int>-4</int>", "-4");
        row("<i4>7</i4>", "7");
        row("<double>0.25</double>", "0.25");
        row("<boolean>1</boolean>", "True");
        row("<string>a &lt;b&gt;</string>", "a <b>");
        row("plain", "plain");
        row("", "");
        row("<array><data><value><int>1</int></value> <value><double>2.5</double></value></data></array>",
            "[1, 2.5]");
        row("<array><data></data></array>", "[]");
        row("<struct><member><name>a</name><value><int>1</int></value></member><member><name>b</name>"
            "<value>x</value></member></struct>",
            "struct(a=1, b=x)");
        row("<struct><member><name>x</name><value><double>1</double></value></member><member><name>y</name>"
            "<value><double>2</double></value></member><member><name>z</name><value><int>3</int></value></"
            "member>"
            "<member><name>rx</name><value><double>0.1</double></value></member><member><name>ry</"
            "name><value>"
            "<double>0.2</double></value></member><member><name>rz</name><value><double>0.3</double></value>"
            "</member></struct>",
            "p[1, 2, 3, 0.1, 0.2, 0.3]");
        row("<dateTime.iso8601>x</dateTime.iso8601>", "error: XML-RPC type 'dateTime.iso8601' is not known");
        row("<int>many</int>", "error: The XML-RPC server's reply is malformed");
        row("<array><data><value><int>1</int></value><value>a</value></data></array>",
            "error: Type error: elements of a list must be of one type, not int and string");
    }
    void repliesBecomeValues() {
        QFETCH(QString, xml);
        QFETCH(QString, value);
        QCOMPARE(QString::fromStdString(read(ok(xml.toStdString()))), value);
    }
    void repliesMayBeFragmented() {
        const std::string whole = ok("<int>5</int>");
        for (std::size_t i = 0; i < whole.size(); ++i) {
            QCOMPARE(read(whole.substr(0, i), false), "more");
        }
        QCOMPARE(read(whole, false), "5");
        // Without a length, the reply ends when the connection closes.
        std::string unmeasured = whole;
        unmeasured.erase(unmeasured.find("Content-length"), std::string("Content-length: 000\r\n").size());
        QCOMPARE(read(unmeasured, false), "more");
        QCOMPARE(read(unmeasured, true), "5");
    }
    void badRepliesAreErrors() {
        QCOMPARE(read(""), "error: The XML-RPC server closed the connection");
        QCOMPARE(read("HTTP/1.0 404 Not Found\r\n\r\nsorry"),
                 "error: The XML-RPC server replied: HTTP/1.0 404 Not Found");
        QCOMPARE(read("HTTP/1.0 200 OK\r\n\r\n<html>"), "error: The XML-RPC server's reply is malformed");
        QCOMPARE(
            read("HTTP/1.0 200 OK\r\n\r\n<methodResponse><fault><value><struct><member><name>faultCode</name>"
                 "<value><int>4</int></value></member><member><name>faultString</name><value>no gripper"
                 "</value></member></struct></value></fault></methodResponse>"),
            "error: XML-RPC fault: no gripper");
        std::string deep = "<int>1</int>";
        for (int i = 0; i < 100; ++i) {
            deep = "<array><data><value>" + deep + "</value></data></array>";
        }
        QCOMPARE(read(ok(deep)), "error: The XML-RPC server's reply is too large");
    }

    void aProgramCallsAndWaits() {
        ScriptRun run(
            "def m():\n h = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:40405/RPC2\")\n"
            " x = h.grip(5, [1.5, 2], \"soft\", p[1,2,3,0,0,0], True) + 1\n h.closeXMLRPCClientConnection()\n"
            " textmsg(x)\nend\n");
        run.frames(5);
        FakeHost::Socket& socket = run.host.sockets["\nrpc1"];
        QVERIFY(QString::fromStdString(socket.out).startsWith("POST /RPC2 HTTP/1.0\r\nHost: 127.0.0.1\r\n"));
        for (const char* part :
             {"<methodName>grip</methodName>", "<value><int>5</int></value>",
              "<array><data><value><double>1.5</double></value><value><double>2</double></value></data></"
              "array>",
              "<string>soft</string>", "<member><name>ry</name><value><double>0</double></value></member>",
              "<boolean>1</boolean>"}) {
            QVERIFY2(socket.out.find(part) != std::string::npos, part);
        }
        socket.in = ok("<int>41</int>");
        QCOMPARE(run.frames(3), Interpreter::State::Finished);
        QCOMPARE(run.host.lastMessage(), "42");
    }
    void otherThreadsRunDuringACall() {
        ScriptRun run(
            "def m():\n n = 0\n thread t():\n while True:\n n = n + 1\n sync()\n end\n end\n run t()\n"
            " h = rpc_factory(\"xmlrpc\", \"127.0.0.1:40405\")\n x = h.slow()\nend\n");
        run.frames(20);
        QVERIFY(run.interpreter->global("n")->number() >= 19);
        run.host.sockets["\nrpc1"].state = SocketHost::State::Closed;
        QCOMPARE(run.frames(2), Interpreter::State::Failed);
        QCOMPARE(run.error(), "The XML-RPC server closed the connection");
        QCOMPARE(run.interpreter->error()->line, 11);
    }
    void missingServerEndsTheProgram() {
        ScriptRun run("def m():\n h = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:40405\")\nend\n");
        run.host.sockets["\nrpc-1"].connectAtOnce = false;
        run.frames(3);
        run.host.sockets["\nrpc-1"].state = SocketHost::State::Closed;
        QCOMPARE(run.frames(2), Interpreter::State::Failed);
        QCOMPARE(run.error(), "No XML-RPC server responds at 127.0.0.1:40405");
    }
    void invalidCallsAreErrors() {
        QCOMPARE(evaluate("rpc_factory(\"soap\", \"http://a\")"),
                 "error: rpc_factory: type must be \"xmlrpc\"");
        QCOMPARE(evaluate("rpc_factory(\"xmlrpc\", \"::\")"),
                 "error: rpc_factory: \"::\" is not the address of a server");
        QCOMPARE(evaluate("h.f(0/0.0)", "h = rpc_factory(\"xmlrpc\", \"a:1\")"),
                 "error: XML-RPC cannot represent a number that is not finite");
        ScriptRun secondary("sec s():\n h = rpc_factory(\"xmlrpc\", \"a:1\")\nend\n");
        QCOMPARE(secondary.frames(1), Interpreter::State::Failed);
    }
};

QTEST_GUILESS_MAIN(tst_RemoteCalls)
#include "tst_remote_calls.moc"
