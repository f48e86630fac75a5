// SPDX-License-Identifier: MIT
//
// The command `tiller-cli test` as build servers run it, with the sample project.

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace {

constexpr int kProcessTimeoutMs = 120'000;

struct Answer {
    int code = -1;
    QByteArray out;
    QByteArray err;
};

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestCliTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        for (const char* name : {"pick-and-place.tiller", "pick-and-place.test.json"}) {
            QVERIFY(QFile::copy(QDir(TILLER_SAMPLES).filePath(name), path(name)));
        }
        // The sample with an expectation that is not met.
        QJsonObject file = QJsonDocument::fromJson(contentOf(path("pick-and-place.test.json"))).object();
        QJsonArray tests = file["tests"].toArray();
        QJsonObject first = tests[0].toObject();
        first["expect"] = QJsonObject{{"duration", QJsonObject{{"max", 2}}}};
        file["tests"] = QJsonArray{first, tests[1]};
        write("failing.test.json", QJsonDocument(file).toJson());
    }

    void sampleTestsPass() {
        const Answer answer = run({"pick-and-place.test.json"});
        QVERIFY2(answer.code == 0, answer.out + answer.err);
        QVERIFY2(answer.out.contains("ok      end: completed (expected completed)"), answer.out);
        QVERIFY2(answer.out.contains("coverage of Place a part: 17 of 17 steps"), answer.out);
        QVERIFY2(answer.out.contains("simulated, seed 1: 5 tests, 5 passed, 0 failed"), answer.out);
    }

    void unmetExpectationGivesExitCodeOne() {
        const Answer answer = run({"failing.test.json", "--junit", "out.xml", "--coverage", "out.json"});
        QVERIFY2(answer.code == 1, answer.out + answer.err);
        QVERIFY2(answer.out.contains("FAILED  Place a part: places the part"), answer.out);
        QVERIFY2(answer.out.contains("FAILED  duration: 11."), answer.out);
        QXmlStreamReader xml(contentOf(path("out.xml")));
        int cases = 0;
        QStringList failures;
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::StartElement) {
                cases += xml.name() == QLatin1String("testcase") ? 1 : 0;
                if (xml.name() == QLatin1String("failure")) {
                    failures.append(xml.attributes().value("message").toString());
                }
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(cases, 2);
        QVERIFY2(failures.size() == 1 && failures[0].startsWith("duration: 11."),
                 qPrintable(failures.join('\n')));
        const QJsonObject coverage = QJsonDocument::fromJson(contentOf(path("out.json"))).object();
        QCOMPARE(coverage["programs"].toArray().at(0)["total"].toInt(), 17);
        QVERIFY(coverage["simulated"].toBool());
    }

    void severalFilesAreTested() {
        const Answer answer = run({"pick-and-place.test.json", "failing.test.json", "--json"});
        QVERIFY2(answer.code == 1, answer.out + answer.err);
        const QJsonObject report = QJsonDocument::fromJson(answer.out).object();
        QCOMPARE(report["passed"].toInt(), 6);
        QCOMPARE(report["failed"].toInt(), 1);
        QCOMPARE(report["tests"].toArray().size(), 7);
        QVERIFY(report["simulated"].toBool());
    }

    void sameSeedGivesTheSameOutput() {
        const QStringList words{"pick-and-place.test.json", "--json", "--junit", "a.xml", "--seed"};
        const Answer first = run(words + QStringList{"7", "--jobs", "1"});
        QCOMPARE(first.code, 0);
        const QByteArray xml = contentOf(path("a.xml"));
        QVERIFY(!xml.isEmpty());
        const Answer second = run(words + QStringList{"7", "--jobs", "3"});
        QCOMPARE(second.out, first.out);
        QCOMPARE(contentOf(path("a.xml")), xml);
        QVERIFY(run(words + QStringList{"8"}).out != first.out);
    }

    void invalidFilesGiveExitCodeTwo() {
        write("bad.test.json", "{ \"format\": ");
        write("typo.test.json",
              R"({"format": "tiller-test", "version": 1, "project": "pick-and-place.tiller",
                  "tests": [{"name": "a", "expect": {"durration": {"max": 1}}}]})");
        const Answer answer =
            run({"pick-and-place.test.json", "bad.test.json", "typo.test.json", "none.json"});
        QVERIFY2(answer.code == 2, answer.out + answer.err);
        QVERIFY2(answer.out.isEmpty(), answer.out);
        QVERIFY2(answer.err.contains("bad.test.json: line 1, column "), answer.err);
        QVERIFY2(answer.err.contains(
                     "typo.test.json: tests[0].expect.durration: is not a known field; use one of"),
                 answer.err);
        QVERIFY2(answer.err.contains("none.json: "), answer.err);
    }

    void wrongArgumentsAreReported_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("text");
        const QString file = "pick-and-place.test.json";
        QTest::newRow("no file") << QStringList{} << 2 << QByteArray("at least one test file");
        QTest::newRow("seed") << QStringList{file, "--seed", "x"} << 2
                              << QByteArray("--seed must be a number");
        QTest::newRow("whole") << QStringList{file, "--seed", "1.5"} << 2 << QByteArray("not '1.5'");
        QTest::newRow("jobs") << QStringList{file, "--jobs", "0"} << 2
                              << QByteArray("--jobs must be a number");
        QTest::newRow("option") << QStringList{file, "--nothing"} << 2 << QByteArray("nothing");
        QTest::newRow("folder") << QStringList{file, "--junit", "no/folder/a.xml"} << 1
                                << QByteArray("a.xml");
    }
    void wrongArgumentsAreReported() {
        QFETCH(QStringList, arguments);
        QFETCH(int, code);
        QFETCH(QByteArray, text);
        const Answer answer = run(arguments);
        QVERIFY2(answer.code == code, answer.out + answer.err);
        QVERIFY2(answer.err.contains(text), answer.err);
    }

    void helpIsPrinted() {
        const Answer answer = run({"--help"});
        QCOMPARE(answer.code, 0);
        QVERIFY(answer.out.contains("--junit FILE") && answer.out.contains("Exit code: 0"));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    void write(const QString& name, const QByteArray& content) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    }
    Answer run(const QStringList& arguments) const {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(QStringLiteral(TILLER_CLI), QStringList{"test"} + arguments);
        if (!process.waitForFinished(kProcessTimeoutMs)) {
            process.kill();
            process.waitForFinished();
        }
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
                process.readAllStandardOutput(), process.readAllStandardError()};
    }
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCliTest)
#include "tst_cli_test.moc"
