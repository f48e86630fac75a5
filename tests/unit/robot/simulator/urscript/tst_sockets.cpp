// SPDX-License-Identifier: MIT
// Socket built-ins with two strings as the connection, and the splitter that divides incoming text into
// program units.

#include "robot/simulator/urscript/source_splitter.h"
#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;
using State = Interpreter::State;
using Kind = SourceSplitter::Unit::Kind;

namespace {

// `body` with the open socket "socket_0", which has received `input`.
struct SocketRun : ScriptRun {
    SocketRun(const std::string& body, const std::string& input) {
        host.sockets["socket_0"].state = SocketHost::State::Open;
        host.sockets["socket_0"].in = input;
        load("def m():\n" + body + "\nend\n");
    }
    FakeHost::Socket& socket() { return host.sockets["socket_0"]; }
};

std::vector<SourceSplitter::Unit> split(const std::string& text, std::size_t chunk) {
    SourceSplitter splitter;
    std::vector<SourceSplitter::Unit> out;
    for (std::size_t i = 0; i < text.size(); i += chunk) {
        splitter.feed(std::string_view(text).substr(i, chunk));
        while (auto unit = splitter.next()) {
            out.push_back(*unit);
        }
    }
    return out;
}

}  // namespace

class tst_Sockets : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void openSucceedsFailsAndTimesOut() {
        ScriptRun run("def m():\nok = socket_open(\"127.0.0.1\", 50001, \"a\")\nend\n");
        QCOMPARE(run.frames(2), State::Finished);
        QCOMPARE(run.value("ok"), "True");
        ScriptRun refused("def m():\nok = socket_open(\"127.0.0.1\", 50001, \"a\")\nend\n");
        refused.host.acceptSockets = false;
        refused.frames(2);
        QCOMPARE(refused.value("ok"), "False");
        ScriptRun mute("def m():\nok = socket_open(\"127.0.0.1\", 50001, \"a\")\nend\n");
        mute.host.sockets["a"].connectAtOnce = false;
        QCOMPARE(mute.frames(1000), State::Running);
        QCOMPARE(mute.frames(2), State::Finished);
        QCOMPARE(mute.value("ok"), "False");
    }
    void integersAreBigEndian() {
        SocketRun run("a = socket_read_binary_integer(2)\nsocket_send_int(-2)\nsocket_send_byte(65)",
                      std::string("\xff\xff\xff\xfe\0\0\1\0rest", 12));
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.value("a"), "[2, -2, 256]");
        QCOMPARE(run.socket().in, "rest");
        QCOMPARE(run.socket().out, std::string("\xff\xff\xff\xfe\x41", 5));
    }
    void readsWaitForTheCompleteMessage() {
        SocketRun run("a = socket_read_binary_integer(1, timeout=0)", "\x01\x02");
        QCOMPARE(run.frames(5000), State::Running);
        run.socket().in += "\x03\x04";
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.value("a"), "[1, 16909060]");
    }
    void readsTimeOut() {
        SocketRun run("a = socket_read_binary_integer(2, timeout=0.02)", "");
        QCOMPARE(run.frames(10), State::Running);
        run.frames(1);
        QCOMPARE(run.value("a"), "[0, -1, -1]");
        SocketRun step("a = socket_read_binary_integer(1, \"socket_0\", get_steptime())\nsync()", "");
        step.frames(2);
        QCOMPARE(step.value("a"), "[0, -1]");
    }
    void readsEndWithTheConnection() {
        SocketRun run(
            "a = socket_read_binary_integer(1, timeout=0)\nb = socket_read_line()\nok = socket_send_int(1)",
            "");
        run.frames(2);
        run.socket().state = SocketHost::State::Closed;
        run.frames(4);
        QCOMPARE(run.value("a"), "[0, -1]");
        QCOMPARE(run.value("b"), "");
        QCOMPARE(run.value("ok"), "False");
    }
    void aLoopOverAClosedSocketDoesNotSpin() {
        SocketRun run("while True:\na = socket_read_byte_list(1)\nend", "");
        run.socket().state = SocketHost::State::Closed;
        QCOMPARE(run.frames(10), State::Running);
    }
    // Reading takes time, so only a loop that neither waits nor reads is endless. The limits of a frame are
    // small here, so a small amount of data is sufficient.
    void aLoopThatAlwaysFindsDataContinues_data() {
        QTest::addColumn<QString>("read");
        QTest::addColumn<QString>("unit");
        QTest::newRow("integers") << "a = socket_read_binary_integer(1)"
                                  << "abcd";
        QTest::newRow("bytes") << "a = socket_read_byte_list(1)"
                               << "x";
        QTest::newRow("floats") << "a = socket_read_ascii_float(1)"
                                << "(1)";
        QTest::newRow("lines") << "a = socket_read_line()"
                               << "x\n";
        QTest::newRow("text") << "a = socket_read_string(suffix=\"x\")"
                              << "x";
        QTest::newRow("variables") << "a = socket_get_var(\"P\")"
                                   << "P 1\n";
    }
    void aLoopThatAlwaysFindsDataContinues() {
        QFETCH(QString, read);
        QFETCH(QString, unit);
        Limits limits;
        limits.threadOperationsPerFrame = 20'000;
        limits.readingOperationsPerFrame = 2'000;
        ScriptRun run;
        run.host.sockets["socket_0"].state = SocketHost::State::Open;
        run.load("def m():\nglobal n = 0\nwhile True:\n" + read.toStdString() + "\nn = n + 1\nend\nend\n",
                 limits);
        int before = 0;
        for (int frame = 0; frame < 10; ++frame) {
            run.host.sockets["socket_0"].in = unit.repeated(4000).toStdString();
            QCOMPARE(run.frames(1), State::Running);
            const int after = std::stoi(run.value("n"));
            // Each frame reads only some of the lines, because only part of the frame time is available for
            // reading.
            QVERIFY2(after - before > 10 && after - before < 2'000 / 20, qPrintable(QString::number(after)));
            before = after;
        }
    }
    void endlessLoopIsDetectedAfterEarlierReads() {
        SocketRun run("a = socket_read_byte_list(1)\nwhile True:\nb = 1\nend", "xx");
        QCOMPARE(run.frames(3), State::Failed);
        QVERIFY(run.error().starts_with("Runtime is too much behind"));
    }
    void aFewReadsTakeNoFrame() {
        SocketRun run("n = 0\nwhile n < 50:\na = socket_read_byte_list(1)\nn = n + 1\nend",
                      std::string(100, 'x'));
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.socket().in.size(), 50u);
    }
    void textIsRead() {
        SocketRun floats("a = socket_read_ascii_float(3)", "( 1.4 , -3.1e1 )");
        floats.frames(1);
        QCOMPARE(floats.value("a"), "[2, 1.4, -31, nan]");
        SocketRun lines("a = socket_read_line()\nb = socket_read_line()", "one\r\ntwo\n");
        lines.frames(1);
        QCOMPARE(lines.value("a") + lines.value("b"), "onetwo");
        SocketRun all("a = socket_read_string()", "hello");
        all.frames(1);
        QCOMPARE(all.value("a"), "hello");
        SocketRun framed("a = socket_read_string(prefix=\">\", suffix=\"\\n\", interpret_escape=True)",
                         "xx>text\nmore");
        framed.frames(1);
        QCOMPARE(framed.value("a"), "text");
        QCOMPARE(framed.socket().in, "more");
        SocketRun bytes("a = socket_read_byte_list(2)", "\xff\x01\x02");
        bytes.frames(1);
        QCOMPARE(bytes.value("a"), "[2, 255, 1]");
    }
    void aSocketNameMayBeANumber() {
        ScriptRun run;
        run.host.sockets["1"].state = SocketHost::State::Open;
        run.host.sockets["1"].in = "ack";
        run.load(
            "def m():\nsocket_set_var(\"POS\", 7, 1)\na = socket_read_byte_list(3, "
            "1)\nsocket_send_line(\"x\", 1)\nend\n");
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.value("a"), "[3, 97, 99, 107]");
        QCOMPARE(run.host.sockets["1"].out, "SET POS 7\nx\n");
    }
    void variablesAreRequested() {
        SocketRun run("a = socket_get_var(\"POS\")\nsocket_set_var(\"POS\", 7)\nsocket_send_line(\"x\")", "");
        run.frames(1);
        QCOMPARE(run.socket().out, "GET POS\n");
        run.socket().in = "POS 42\n";
        run.frames(1);
        QCOMPARE(run.value("a"), "42");
        QCOMPARE(run.socket().out, "GET POS\nSET POS 7\nx\n");
    }

    // ---- the splitter
    void programUnitsDoNotDependOnSegmentation() {
        const std::string text =
            "stop program\n\tdef externalControl():\n\t\tif a == 1 or\n\t\t b: # "
            "end\n\t\t\ttextmsg(\"end\")\n\t\tend\n"
            "\t\tthread t():\n\t\tend\n\tend\n\n\nset speed 0.8\nmovej([1,2,3,4,5,6],\n a=1)\n  sec s():\n"
            "set_payload(1, [0,0,0])\nend\ntextmsg(\"x\") textmsg(\"y\")\r\npower on\r\n";
        for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, text.size()}) {
            const auto units = split(text, chunk);
            QCOMPARE(units.size(), 7u);
            QVERIFY(units[0].kind == Kind::Command && units[0].text == "stop program");
            QVERIFY(units[1].kind == Kind::Program && units[1].text.ends_with("\tend\n"));
            QVERIFY(units[1].text.starts_with("\tdef externalControl"));
            QVERIFY(units[2].kind == Kind::Command && units[2].text == "set speed 0.8");
            QVERIFY(units[3].kind == Kind::Statements && units[3].text.ends_with("a=1)\n"));
            QVERIFY(units[4].kind == Kind::Secondary);
            QVERIFY(units[5].kind == Kind::Statements);
            QVERIFY(units[6].kind == Kind::Command && units[6].text == "power on");
        }
    }
    void nothingRunsBeforeTheNewline() {
        SourceSplitter splitter;
        splitter.feed("textmsg(1)");
        QVERIFY(!splitter.next());
        QCOMPARE(splitter.pending(), 10u);
        splitter.feed("\n");
        QVERIFY(splitter.next());
        QCOMPARE(splitter.pending(), 0u);
    }
    void oneLineProgramsAreUnits() {
        const auto units = split("def f(): x = 1 end\nwhile False: sync() end\nhalt\n", 3);
        QCOMPARE(units.size(), 3u);
        QVERIFY(units[0].kind == Kind::Program);
        QVERIFY(units[1].kind == Kind::Statements);
        QVERIFY(units[2].kind == Kind::Statements);
    }
    void commentsBeforeAProgramKeepItsLineNumbers() {
        const auto units = split("\n\n# made by hand\n# two\ndef f():\nend\n", 100);
        QCOMPARE(units.size(), 1u);
        QVERIFY(units[0].text.starts_with("# made by hand\n# two\ndef f"));
    }
    void unfinishedUnitsDoNotSwallowWhatFollows() {
        auto units = split("textmsg(\"a\"\ndef f():\nend\n", 100);
        QCOMPARE(units.size(), 2u);
        QVERIFY(units[1].kind == Kind::Program);
        units = split("def f():\nif True:\nstop program\ntextmsg(1)\n", 100);
        QCOMPARE(units.size(), 3u);
        QVERIFY(units[0].kind == Kind::Program && !compile(units[0].text));
        QVERIFY(units[1].kind == Kind::Command);
        QVERIFY(units[2].kind == Kind::Statements);
    }
};

QTEST_GUILESS_MAIN(tst_Sockets)
#include "tst_sockets.moc"
