// SPDX-License-Identifier: MIT

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct Answer {
    int status = 0;
    QByteArray head, body;
    QJsonObject json() const { return QJsonDocument::fromJson(body).object(); }
};

/// A persistent HTTP connection.
struct Web : RawClient {
    explicit Web(const VirtualRobot& robot) : RawClient(robot.host(), robot.controller.ports().robotApi) {}

    Answer next(bool hasBody = true) {
        Answer answer;
        QByteArray text;
        do {
            text = line();
            answer.head += text;
        } while (text.size() > 2);
        answer.status = answer.head.mid(9, 3).toInt();
        const qsizetype at = answer.head.indexOf("Content-Length: ");
        const int size = answer.head.mid(at + 16, answer.head.indexOf('\r', at) - at - 16).toInt();
        answer.body = hasBody && at >= 0 ? take(size) : QByteArray();
        return answer;
    }
    Answer ask(const QByteArray& method, const QByteArray& path, const QByteArray& body = {},
               const QByteArray& headers = {}) {
        send(method + " /universal-robots/robot-api" + path + " HTTP/1.1\r\nHost: robot\r\n" + headers +
             "Content-Length: " + QByteArray::number(body.size()) + "\r\n\r\n" + body);
        return next();
    }
    Answer upload(const QByteArray& method, const QByteArray& content,
                  const QByteArray& fileName = "filename") {
        const QByteArray form = "--edge\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" +
                                fileName + "\"\r\nContent-Type: text/plain\r\n\r\n" + content +
                                "\r\n--edge--\r\n";
        return ask(method, "/programs/v1/", form, "Content-Type: multipart/form-data; boundary=edge\r\n");
    }
};

simulator::SimulatorOptions polyScopeX(quint32 minor = 12) {
    auto options = VirtualRobot::options();
    options.software = {10, minor, 0, 0};
    return options;
}

const QByteArray kProgram =
    R"({"name":"wait","script":"def wait():\n  while True:\n    sleep(1)\n  end\nend\n"})";

}  // namespace

class TestRobotApi : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void apiDescribesItself() {
        VirtualRobot robot(polyScopeX());
        QCOMPARE(robot.controller.ports().dashboard, quint16(0));
        Web web(robot);
        const QJsonObject api = web.ask("GET", "/openapi.json").json();
        QCOMPARE(api["info"]["version"].toString(), QStringLiteral("3.1.4"));
        QVERIFY(api["paths"].toObject().contains("/robotstate/v1/state"));
        QCOMPARE(web.ask("GET", "/docs").status, 200);
        QCOMPARE(web.ask("GET", "/nothing").status, 404);
        const Answer wrong = web.ask("PUT", "/robotstate/v1/robotmode");
        QCOMPARE(wrong.status, 405);
        QVERIFY(wrong.head.contains("Allow: GET"));
    }

    void olderSoftwareHasFewerEndpoints() {
        VirtualRobot eleven(polyScopeX(11));
        Web web(eleven);
        QCOMPARE(web.ask("GET", "/robotstate/v1/robotmode").status, 404);
        QCOMPARE(web.ask("GET", "/programs/v1/").status, 404);
        QCOMPARE(web.ask("GET", "/program/v1/state").status, 200);
        QCOMPARE(web.ask("PUT", "/program/v1/load", R"({"programName":"x"})").status, 404);
        QCOMPARE(web.ask("PUT", "/program/v1/load", "{}").status, 422);  // the path exists, unlike in 10.12
        VirtualRobot twelve(polyScopeX(12));
        QVERIFY(!Web(twelve).ask("PUT", "/program/v1/load", "{}").body.contains("programName"));
        QCOMPARE(VirtualRobot(polyScopeX(10)).controller.ports().robotApi, quint16(0));
    }

    // The server must not read or write through the link.
    void aLinkOutsideTheProgramsFolderIsNotAProgram() {
        QTemporaryDir place;
        const QDir outside(place.path());
        QVERIFY(outside.mkpath("programs"));
        QFile secret(outside.filePath("wait.urpx"));
        QVERIFY(secret.open(QIODevice::WriteOnly));
        secret.write(kProgram);
        secret.close();
        QVERIFY(QFile::link(secret.fileName(), outside.filePath("programs/wait.urpx")));
        auto options = polyScopeX();
        options.programsFolder = outside.filePath("programs");
        VirtualRobot robot(options);
        Web web(robot);
        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"wait"})").status, 404);
        QCOMPARE(web.ask("GET", "/programs/v1/wait").status, 404);
        QCOMPARE(web.ask("GET", "/programs/v1/").json()["programs"].toArray().size(), 0);
        QVERIFY(web.upload("PUT", R"({"name":"wait","script":"overwritten"})").status != 200);
        QVERIFY(web.upload("POST", R"({"name":"wait","script":"overwritten"})").status != 200);
        QVERIFY(secret.open(QIODevice::ReadOnly));
        QCOMPARE(secret.readAll(), kProgram);
    }

    void aProgramIsUploadedLoadedPlayedPausedAndStopped() {
        VirtualRobot robot(polyScopeX());
        Web web(robot);
        QCOMPARE(web.ask("GET", "/program/v1/loaded").json()["name"].toString(),
                 QStringLiteral("Default program"));
        QCOMPARE(web.ask("GET", "/programs/v1/").json()["programs"].toArray().size(), 0);
        const Answer stored = web.upload("POST", kProgram);
        QCOMPARE(stored.status, 200);
        QCOMPARE(stored.json()["programName"].toString(), QStringLiteral("wait"));
        QCOMPARE(web.upload("POST", kProgram).status, 400);  // the program already exists
        QCOMPARE(web.upload("PUT", R"({"name":"other"})").status, 404);
        QCOMPARE(web.upload("PUT", kProgram).status, 200);
        QCOMPARE(web.upload("POST", "no json").status, 400);
        QCOMPARE(web.upload("POST", R"({"name":"../outside"})").status, 400);
        QCOMPARE(web.ask("POST", "/programs/v1/", "no form").status, 422);
        const QJsonObject listed = web.ask("GET", "/programs/v1/").json()["programs"].toArray()[0].toObject();
        QCOMPARE(listed["name"].toString(), QStringLiteral("wait"));
        QVERIFY(listed["createdDate"].isDouble());
        QCOMPARE(web.ask("GET", "/programs/v1/wait").body, kProgram);
        QCOMPARE(web.ask("GET", "/programs/v1/none").status, 404);
        QCOMPARE(web.ask("GET", "/programs/v1/..%2f..%2fetc%2fpasswd").status, 404);

        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"none"})").status, 404);
        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"wait"})").status, 200);
        QCOMPARE(web.ask("GET", "/program/v1/loaded").json()["name"].toString(), QStringLiteral("wait"));
        QCOMPARE(web.upload("PUT", kProgram).status, 409);  // the program is loaded

        const auto act = [&](const char* action) {
            const Answer answer =
                web.ask("PUT", "/program/v1/state", QByteArray("{\"action\":\"") + action + "\"}");
            robot.controller.step(100);
            return answer;
        };
        const auto state = [&] { return web.ask("GET", "/program/v1/state").json()["state"].toString(); };
        QCOMPARE(state(), QStringLiteral("STOPPED"));
        QCOMPARE(act("pause").status, 409);
        QCOMPARE(act("resume").status, 409);
        QCOMPARE(act("play").status, 200);
        QCOMPARE(state(), QStringLiteral("PLAYING"));
        QCOMPARE(act("play").status, 409);
        const Answer paused = act("pause");
        QCOMPARE(paused.json()["message"].toString(), QStringLiteral("Program state changed: PAUSED"));
        QCOMPARE(paused.json()["details"].toString(), QStringLiteral("Pause successful"));
        QCOMPARE(state(), QStringLiteral("PAUSED"));
        QCOMPARE(act("resume").status, 200);
        QCOMPARE(state(), QStringLiteral("PLAYING"));
        QCOMPARE(act("stop").status, 200);
        QCOMPARE(state(), QStringLiteral("STOPPED"));
        QCOMPARE(act("dance").status, 422);
        QCOMPARE(web.ask("PUT", "/program/v1/state", "not json").status, 422);
    }

    // The layout is that of programs saved by the vendor's pendant.
    void aProgramInTheVendorLayoutIsParsed() {
        VirtualRobot robot(polyScopeX());
        Web web(robot);
        const auto part = [](const char* script) {
            return QJsonObject{{"script", script}, {"nodeIDList", QJsonArray()}};
        };
        const QJsonObject information{{"name", "test upload"},
                                      {"description", "waits"},
                                      {"createdDate", 1700000000000.0},
                                      {"lastSavedDate", 1700000001000.0},
                                      {"lastModifiedDate", QJsonValue()},
                                      {"programState", "DRAFT"}};
        const QJsonObject whole{
            {"application",
             QJsonObject{{"urscript", part("  global corner = p[0.1,0,0,0,0,0]\n"
                                           "  move_frame(\"base\", p[0,0,0,0,0,0], \"world\")\n"
                                           "  def wait():\n    sleep(1)\n  end")}}},
            {"program",
             QJsonObject{{"id", "7"},
                         {"programContent", QJsonObject()},
                         {"programInformation", information},
                         {"urscript", part("  while True:\n    $ 1 \"Wait\"\n    wait()\n  end")}}}};
        const QByteArray program = QJsonDocument(whole).toJson(QJsonDocument::Compact);
        QCOMPARE(web.upload("POST", program).json()["programName"].toString(), QStringLiteral("test upload"));
        QCOMPARE(web.ask("GET", "/programs/v1/test%20upload").body, program);
        const QJsonObject listed = web.ask("GET", "/programs/v1/").json()["programs"].toArray()[0].toObject();
        QCOMPARE(listed["description"].toString(), QStringLiteral("waits"));
        QCOMPARE(listed["createdDate"].toDouble(), 1700000000000.0);
        QVERIFY(listed["lastModifiedDate"].isNull());
        QCOMPARE(listed["programState"].toString(), QStringLiteral("DRAFT"));
        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"test upload"})").status, 200);
        QCOMPARE(web.ask("PUT", "/program/v1/state", R"({"action":"play"})").status, 200);
        robot.controller.stepSeconds(3);
        QCOMPARE(web.ask("GET", "/program/v1/state").json()["state"].toString(), QStringLiteral("PLAYING"));
        // The default program of a new controller replaces the loaded program.
        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"Default program"})").status, 200);
        QCOMPARE(web.ask("GET", "/program/v1/loaded").json()["name"].toString(),
                 QStringLiteral("Default program"));
        QCOMPARE(web.ask("GET", "/program/v1/state").json()["state"].toString(), QStringLiteral("STOPPED"));
    }

    void aTrailingSlashIsIgnored() {
        VirtualRobot robot(polyScopeX());
        Web web(robot);
        for (const char* path : {"/robotstate/v1/robotmode", "/program/v1/state", "/programs/v1"}) {
            QCOMPARE(web.ask("GET", path).status, 200);
            QCOMPARE(web.ask("GET", QByteArray(path) + "/").status, 200);
        }
        QCOMPARE(web.ask("PUT", "/robotstate/v1/state/", R"({"action":"POWER_OFF"})").status, 200);
        QCOMPARE(web.ask("GET", "/robotstate/v1/robotmode//").status, 404);
    }

    // Clients query the new state or request the next step immediately after the reply.
    void slowRequestsAreAnsweredOnCompletion() {
        auto options = polyScopeX();
        options.time = simulator::Time::Real;
        options.fastTransitions = true;
        VirtualRobot robot(options);
        Web web(robot);
        const auto act = [&web](const QByteArray& path, const QByteArray& action) {
            return web.ask("PUT", path, "{\"action\":\"" + action + "\"}").status;
        };
        const auto value = [&web](const QByteArray& path, const char* key) {
            return web.ask("GET", path).json()[QLatin1String(key)].toString();
        };
        const auto mode = [&value] { return value("/robotstate/v1/robotmode", "mode"); };
        QCOMPARE(act("/robotstate/v1/state", "POWER_OFF"), 200);
        QCOMPARE(mode(), QStringLiteral("POWER_OFF"));
        QCOMPARE(act("/robotstate/v1/state", "POWER_ON"), 200);
        QCOMPARE(mode(), QStringLiteral("IDLE"));
        QCOMPARE(act("/robotstate/v1/state", "BRAKE_RELEASE"), 200);
        QCOMPARE(mode(), QStringLiteral("RUNNING"));
        robot.controller.protectiveStop();
        QTRY_COMPARE_WITH_TIMEOUT(value("/robotstate/v1/safetymode", "mode"),
                                  QStringLiteral("PROTECTIVE_STOP"), 60'000);
        QCOMPARE(act("/robotstate/v1/state", "UNLOCK_PROTECTIVE_STOP"), 200);
        QCOMPARE(value("/robotstate/v1/safetymode", "mode"), QStringLiteral("NORMAL"));

        QCOMPARE(web.upload("POST", kProgram).status, 200);
        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"wait"})").status, 200);
        const std::pair<QByteArray, QString> steps[] = {{"play", QStringLiteral("PLAYING")},
                                                        {"pause", QStringLiteral("PAUSED")},
                                                        {"resume", QStringLiteral("PLAYING")},
                                                        {"stop", QStringLiteral("STOPPED")}};
        for (const auto& [action, state] : steps) {
            QCOMPARE(act("/program/v1/state", action), 200);
            QCOMPARE(value("/program/v1/state", "state"), state);
        }
    }

    void slowRequestBlocksOnlyItsConnection() {
        auto options = polyScopeX();
        options.time = simulator::Time::Real;
        options.poweredOn = false;
        VirtualRobot robot(options);
        Web web(robot);
        const QByteArray path = "/universal-robots/robot-api/robotstate/v1/";
        web.send("PUT " + path +
                 "state HTTP/1.1\r\nContent-Length: 26\r\n\r\n{\"action\":\"BRAKE_RELEASE\"}" + "GET " +
                 path + "robotmode HTTP/1.1\r\n\r\n");
        QVERIFY(Web(robot).ask("GET", "/robotstate/v1/robotmode").json()["mode"] != QLatin1String("RUNNING"));
        QCOMPARE(web.next().status, 200);
        QCOMPARE(web.next().json()["mode"].toString(), QStringLiteral("RUNNING"));
    }

    void localControlRefusesAllChanges() {
        auto options = polyScopeX();
        options.remoteControl = false;
        VirtualRobot robot(options);
        Web web(robot);
        QCOMPARE(web.ask("GET", "/system/v1/controlmode").json()["mode"].toString(), QStringLiteral("LOCAL"));
        const Answer refused = web.ask("PUT", "/robotstate/v1/state", R"({"action":"POWER_OFF"})");
        QCOMPARE(refused.status, 403);
        QCOMPARE(refused.json()["message"].toString(), QStringLiteral("Forbidden - Operation Not Allowed"));
        QCOMPARE(web.upload("POST", kProgram).status, 200);  // storing a program does not move the arm
        QCOMPARE(web.ask("PUT", "/program/v1/loaded", R"({"name":"wait"})").status, 403);
        QCOMPARE(web.ask("GET", "/robotstate/v1/robotmode").json()["mode"].toString(),
                 QStringLiteral("RUNNING"));
        robot.controller.setRemoteControl(true);
        robot.controller.drainSockets();
        QCOMPARE(web.ask("PUT", "/robotstate/v1/state", R"({"action":"POWER_OFF"})").status, 200);
        QCOMPARE(web.ask("GET", "/system/v1/controlmode").json()["mode"].toString(),
                 QStringLiteral("REMOTE"));
    }

    void requestsMayHaveAnyFormAllowedByHttp() {
        VirtualRobot robot(polyScopeX());
        Web web(robot);
        const QByteArray path = "/universal-robots/robot-api/robotstate/v1/robotmode";
        // Send two requests in one piece, the second of them byte by byte, then a chunked body.
        web.send("GET " + path + " HTTP/1.1\r\n\r\nGET " + path + "?x=1 HTT");
        QCOMPARE(web.next().status, 200);
        for (const char c : QByteArray("P/1.1\r\nX: y\r\n\r\n")) {
            web.send(QByteArray(1, c));
        }
        QCOMPARE(web.next().status, 200);
        web.send(
            "PUT /universal-robots/robot-api/robotstate/v1/state HTTP/1.1\r\nTransfer-Encoding: "
            "chunked\r\n\r\n"
            "a\r\n{\"action\":\r\n");
        web.send("b\r\n\"POWER_ON\"}\r\n0\r\n\r\n");
        QCOMPARE(web.next().status, 200);
        web.send("HEAD " + path + " HTTP/1.1\r\n\r\n");
        QCOMPARE(web.next(false).status, 200);
        web.send(
            "PUT /universal-robots/robot-api/robotstate/v1/state HTTP/1.1\r\nExpect: "
            "100-continue\r\nContent-Length: 2\r\n\r\n");
        QCOMPARE(web.next().status, 100);
        web.send("{}");
        QCOMPARE(web.next().status, 422);
        web.send("GET " + path + " HTTP/1.1\r\nConnection: close\r\n\r\n");
        QVERIFY(web.next().head.contains("Connection: close"));
        QVERIFY(web.waitClosed());
    }

    void malformedRequestIsRefusedAndEndsTheConnection_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("status");
        QTest::newRow("no request line") << QByteArray("hello\r\n\r\n") << 400;
        QTest::newRow("another version") << QByteArray("GET / HTTP/2.0\r\n\r\n") << 505;
        QTest::newRow("no header") << QByteArray("GET / HTTP/1.1\r\nnonsense\r\n\r\n") << 400;
        QTest::newRow("length") << QByteArray("PUT / HTTP/1.1\r\nContent-Length: many\r\n\r\n") << 400;
        QTest::newRow("two lengths")
            << QByteArray("PUT / HTTP/1.1\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\n") << 400;
        QTest::newRow("length and chunks")
            << QByteArray("PUT / HTTP/1.1\r\nContent-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n") << 400;
        QTest::newRow("too large") << QByteArray("PUT / HTTP/1.1\r\nContent-Length: 99999999\r\n\r\n") << 413;
        QTest::newRow("chunk too large")
            << QByteArray("PUT / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nfffffffff\r\n") << 413;
        QTest::newRow("another encoding")
            << QByteArray("PUT / HTTP/1.1\r\nTransfer-Encoding: gzip\r\n\r\n") << 501;
        QTest::newRow("endless head") << "GET / HTTP/1.1\r\nA: " + QByteArray(100'000, 'x') << 431;
        QTest::newRow("broken escape") << QByteArray("GET /%zz HTTP/1.1\r\n\r\n") << 400;
    }
    void malformedRequestIsRefusedAndEndsTheConnection() {
        QFETCH(QByteArray, bytes);
        QFETCH(int, status);
        VirtualRobot robot(polyScopeX());
        Web web(robot);
        web.socket().write(bytes);
        QCOMPARE(web.next().status, status);
        QVERIFY(web.waitClosed());
        QCOMPARE(Web(robot).ask("GET", "/openapi.json").status, 200);
    }
};

QTEST_GUILESS_MAIN(TestRobotApi)
#include "tst_robot_api.moc"
