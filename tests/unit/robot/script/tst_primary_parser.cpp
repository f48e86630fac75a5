// SPDX-License-Identifier: MIT
#include <QTest>
#include <random>

#include "robot/script/detail/primary_parser.h"
#include "tests/unit/robot/script/primary_bytes.h"

using namespace tiller;
using namespace tiller::script;
using namespace tiller::test;

namespace {

std::span<const std::uint8_t> view(const QByteArray& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())};
}

/// A package with the global variables of a program.
QByteArray variables(const Wire& body) {
    return package(25, Wire().u64(1).raw(body.bytes()).bytes());
}

ControllerMessage only(const QByteArray& bytes) {
    PrimaryParser parser;
    parser.feed(view(bytes), 7);
    const auto messages = parser.takeMessages();
    return messages.size() == 1 ? messages.front() : ControllerMessage{};
}

}  // namespace

class TestPrimaryParser : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void textMessageIsParsed() {
        const auto m = only(message(0, "hello robot"));
        QCOMPARE(m.kind, MessageKind::Text);
        QCOMPARE(m.text, QStringLiteral("hello robot"));
        QCOMPARE(m.source, -3);
        QCOMPARE(m.robotTime, 123456U);
        QCOMPARE(m.hostTimeNs, 7);
    }

    void versionMessageGivesTheVersion() {
        PrimaryParser parser;
        QVERIFY(parser.feed(view(versionMessage()), 0));
        const SoftwareVersion expected{5, 24, 1, 77};
        QVERIFY(parser.state().version == expected);
        QCOMPARE(parser.takeMessages().front().title, QStringLiteral("URControl"));
    }

    // The layout of the package is the one in the description of the primary interface.
    void compileErrorHasLineAndColumn() {
        const auto m =
            only(message(10, Wire().i32(3).i32(1).text("compile_error_name_not_found:txtmsg:").bytes()));
        QCOMPARE(m.kind, MessageKind::RuntimeException);
        QCOMPARE(m.line, 3);
        QCOMPARE(m.column, 1);
        QCOMPARE(m.text, QStringLiteral("compile_error_name_not_found:txtmsg:"));
        QCOMPARE(m.severity, MessageSeverity::Violation);
    }

    void errorCodeHasItsNameAndLevel() {
        const auto m = only(message(6, Wire().i32(209).i32(0).i32(2).u32(0).u32(0).text("why").bytes()));
        QCOMPARE(m.kind, MessageKind::ErrorCode);
        QCOMPARE(m.codeName(), QStringLiteral("C209A0"));
        QCOMPARE(m.severity, MessageSeverity::Warning);
        QCOMPARE(m.text, QStringLiteral("why"));
    }

    void keyMessageReportsPrograms() {
        const auto m = only(
            message(7, Wire().i32(0).i32(0).u8(19).text("PROGRAM_XXX_STARTEDtiller_control").bytes(), 0xfe));
        QCOMPARE(m.kind, MessageKind::Key);
        QCOMPARE(m.title, QStringLiteral("PROGRAM_XXX_STARTED"));
        QCOMPARE(m.text, QStringLiteral("tiller_control"));
        QCOMPARE(m.source, -2);
    }

    void safetyModeMessageChangesTheState() {
        PrimaryParser parser;
        parser.feed(view(message(5, Wire().i32(0).i32(0).u8(3).u32(0).u32(0).bytes())), 0);
        QCOMPARE(parser.state().safetyMode, SafetyMode::ProtectiveStop);
        const auto m = parser.takeMessages().front();
        QCOMPARE(m.text, QStringLiteral("PROTECTIVE_STOP"));
        QCOMPARE(m.severity, MessageSeverity::Warning);
    }

    void popupsOfBothLayoutsAreParsed() {
        const auto newer =
            only(message(2, Wire().u32(5).u32(8).u8(1).u8(0).u8(1).u8(5).text("TitleSome text").bytes()));
        QCOMPARE(newer.kind, MessageKind::Popup);
        QCOMPARE(newer.title, QStringLiteral("Title"));
        QCOMPARE(newer.text, QStringLiteral("Some text"));
        QCOMPARE(newer.severity, MessageSeverity::Warning);
        const auto older = only(message(2, Wire().u8(0).u8(1).u8(5).text("TitleSome text").bytes()));
        QCOMPARE(older.title, QStringLiteral("Title"));
        QCOMPARE(older.text, QStringLiteral("Some text"));
        QCOMPARE(older.severity, MessageSeverity::Violation);
    }

    void unknownMessagesAreKeptAsOther() {
        const auto m = only(message(99, "whatever"));
        QCOMPARE(m.kind, MessageKind::Other);
        QCOMPARE(m.code, 99);
    }

    void robotStateGivesModes() {
        PrimaryParser parser;
        parser.feed(view(robotState(robotModeData(7, true) + masterboardData(2))), 0);
        QCOMPARE(parser.state().packages, 1U);
        QCOMPARE(parser.state().robotMode, RobotMode::Running);
        QCOMPARE(parser.state().safetyMode, SafetyMode::Reduced);
        QVERIFY(parser.state().powerOn);
        QVERIFY(parser.state().programRunning);
        parser.feed(view(robotState(robotModeData(0xff, false))), 0);
        QCOMPARE(parser.state().robotMode, RobotMode::NoController);
    }

    void configurationGivesTheArmsDimensions() {
        PrimaryParser parser;
        QVERIFY(!parser.configuration());
        parser.feed(view(robotState(robotModeData(7, false) + configurationData())), 0);
        QVERIFY(parser.configuration().has_value());
        const RobotConfiguration& c = *parser.configuration();
        QCOMPARE(c.minPosition[2], -8.2);
        QCOMPARE(c.maxPosition[5], 11.2);
        QCOMPARE(c.maxSpeed[0], 3.3);
        QCOMPARE(c.dh.a[1], -0.425);
        QCOMPARE(c.dh.d[0], 0.1625);
        QCOMPARE(c.robotType, 1);
        QCOMPARE(c.robotSubType, 3);
        // Later packages omit the value. The stored value is kept.
        parser.feed(view(robotState(robotModeData(7, false))), 0);
        QVERIFY(parser.configuration().has_value());
    }

    // The calibration is part of KinematicsInfo. It is used regardless of the order of the two packages.
    void theCalibrationComesFromKinematicsInfo() {
        Wire own;
        for (int i = 0; i < 6; ++i) {
            own.u32(0xffffffff);
        }
        for (int i = 0; i < 24; ++i) {  // theta, a, d, alpha
            own.f64(0.01 * i);
        }
        const QByteArray kinematics = package(5, own.u32(0).bytes());
        for (const QByteArray& parts : {kinematics + configurationData(), configurationData() + kinematics}) {
            PrimaryParser parser;
            parser.feed(view(robotState(robotModeData(7, false) + parts)), 0);
            QVERIFY(parser.configuration().has_value());
            const RobotConfiguration& c = *parser.configuration();
            QCOMPARE(c.dh.theta[1], 0.01);
            QCOMPARE(c.dh.a[1], 0.07);
            QCOMPARE(c.dh.d[1], 0.13);
            QCOMPARE(c.dh.alpha[1], 0.19);
            QCOMPARE(c.maxSpeed[0], 3.3);
        }
    }

    void unknownSubPackagesAndExtraBytesAreSkipped() {
        PrimaryParser parser;
        QByteArray longer = masterboardData(1);
        longer[3] = static_cast<char>(longer[3] + 4);
        longer += "more";
        parser.feed(view(robotState(package(77, "???") + longer + robotModeData(5, false))), 0);
        QCOMPARE(parser.malformed(), 0U);
        QCOMPARE(parser.state().robotMode, RobotMode::Idle);
        QCOMPARE(parser.state().safetyMode, SafetyMode::Normal);
    }

    void theSegmentationOfTheStreamDoesNotMatter() {
        const QByteArray stream = versionMessage() +
                                  robotState(robotModeData(7, true) + configurationData()) +
                                  message(0, "one") + package(26, "ignored") + message(0, "two");
        for (const int piece : {1, 2, 3, 7, 64, 4096}) {
            PrimaryParser parser;
            for (int at = 0; at < stream.size(); at += piece) {
                QVERIFY(parser.feed(view(stream.mid(at, piece)), 0));
            }
            const auto messages = parser.takeMessages();
            QCOMPARE(messages.size(), 3U);
            QCOMPARE(messages.back().text, QStringLiteral("two"));
            QVERIFY(parser.configuration().has_value());
            QCOMPARE(parser.malformed(), 0U);
        }
    }

    void invalidLengthsEndTheStream() {
        for (const std::uint32_t length : {0U, 4U, 0xffffffffU, 0x7fffffffU}) {
            PrimaryParser parser;
            QVERIFY(!parser.feed(view(Wire().u32(length).u8(16).bytes()), 0));
            QCOMPARE(parser.malformed(), 1U);
            parser.reset();
            QVERIFY(parser.feed(view(message(0, "again")), 0));
            QCOMPARE(parser.takeMessages().size(), 1U);
        }
    }

    void truncatedPackagesAreCountedAndSkipped() {
        PrimaryParser parser;
        const QByteArray whole = message(7, Wire().i32(0).i32(0).u8(200).text("short").bytes());
        QVERIFY(parser.feed(view(whole), 0));
        QVERIFY(parser.feed(view(message(6, "\0\0")), 0));
        QVERIFY(parser.feed(view(package(20, "x")), 0));
        QVERIFY(parser.feed(view(robotState(Wire().u32(400).u8(0).bytes())), 0));
        QVERIFY(parser.feed(view(robotState(package(0, "abc"))), 0));
        QCOMPARE(parser.malformed(), 5U);
        QVERIFY(parser.takeMessages().empty());
        QVERIFY(parser.feed(view(message(0, "alive")), 0));
        QCOMPARE(parser.takeMessages().size(), 1U);
    }

    void variablesHaveTypesAndValues() {
        PrimaryParser parser;
        parser.feed(view(versionMessage()), 0);
        QVERIFY(!parser.state().variables);
        parser.feed(view(variables(Wire().u8(0).u8(0).u8(0).text("n\nx\nok\nwords\nhere\nall\n"))), 0);
        QCOMPARE(parser.state().variables->size(), 6U);
        QVERIFY(parser.state().variables->front() == ProgramVariable{.name = "n"});
        Wire values;
        values.u8(1).u8(0).u8(0);
        values.u8(15).i32(-3).u8('\n').u8(16).f32(0.1F).u8('\n').u8(13).u8(1).u8('\n');
        values.u8(3).u8(0).u8(2).text("h\n").u8('\n').u8(12).f32(1).f32(0).f32(0).f32(0).f32(0).f32(-2.5F);
        values.u8('\n').u8(17).u8(0).u8(2).u8(0).u8(17).u8(0).u8(1).u8(15).i32(7).u8('\n');
        parser.feed(view(variables(values)), 0);
        using Type = ProgramVariable::Type;
        const std::vector<ProgramVariable> expected{
            {"n", Type::Whole, "-3", -3},
            {"x", Type::Number, "0.1", static_cast<double>(0.1F)},
            {"ok", Type::Flag, "True", 1},
            {"words", Type::Text, "\"h\n\"", 0},
            {"here", Type::Pose, "p[1, 0, 0, 0, 0, -2.5]", 0},
            {"all", Type::List, "[, [7]]", 0},
        };
        QVERIFY(*parser.state().variables == expected);
        // Names and values in several packages.
        parser.feed(view(variables(Wire().u8(0).u8(0).u8(6).text("table\n"))), 0);
        QCOMPARE(parser.state().variables->size(), 7U);
        parser.feed(
            view(variables(
                Wire().u8(1).u8(0).u8(6).u8(18).u8(0).u8(2).u8(0).u8(1).u8(16).f32(1).u8(16).f32(2).u8(
                    '\n'))),
            0);
        QCOMPARE(parser.state().variables->back().text, QStringLiteral("[[1], [2]]"));
        QVERIFY(parser.state().variables->front() == expected.front());
        QCOMPARE(parser.malformed(), 0U);
        // The next program may have no variables.
        parser.feed(view(message(7, Wire().i32(0).i32(0).u8(19).text("PROGRAM_XXX_STOPPEDp").bytes())), 0);
        QVERIFY(!parser.state().variables);
    }

    void olderSoftwareHasOtherVariableTypes() {
        PrimaryParser parser;
        parser.feed(
            view(message(3, Wire().u8(9).text("URControl").u8(3).u8(13).i32(1).i32(77).text("").bytes(),
                         0xfe)),
            0);
        parser.feed(view(variables(Wire().u8(0).u8(0).u8(0).text("n\nx\nok\nhere\nall\n"))), 0);
        Wire values;
        values.u8(1).u8(0).u8(0).u8(14).i32(1).u8('\n').u8(15).f32(0.5F).u8('\n').u8(12).u8(0).u8('\n');
        values.u8(10).f32(0).f32(0).f32(0).f32(0).f32(0).f32(1).u8('\n').u8(5).u8(0).u8(1).u8(14).i32(2).u8(
            '\n');
        parser.feed(view(variables(values)), 0);
        QStringList texts;
        for (const ProgramVariable& variable : *parser.state().variables) {
            texts << variable.text;
        }
        QCOMPARE(texts, (QStringList{"1", "0.5", "False", "p[0, 0, 0, 0, 0, 1]", "[2]"}));
    }

    void invalidVariablesAreCountedAndSkipped() {
        PrimaryParser parser;
        parser.feed(view(versionMessage()), 0);
        const QByteArray names = variables(Wire().u8(0).u8(0).u8(0).text("n\n"));
        const QByteArray one = variables(Wire().u8(1).u8(0).u8(0).u8(15).i32(1).u8('\n'));
        parser.feed(view(names + one), 0);
        int expected = 0;
        for (const Wire& wrong :
             {Wire().u8(1).u8(0).u8(0).u8(15).i32(2), Wire().u8(1).u8(0).u8(0).u8(99).i32(2).u8('\n'),
              Wire().u8(1).u8(0).u8(9).u8(15).i32(2).u8('\n'), Wire().u8(0).u8(0).u8(9).text("far\n"),
              Wire().u8(1), Wire().u8(1).u8(0).u8(0).u8(18).u8(255).u8(255).u8(0).u8(0).u8('\n'),
              Wire().u8(1).u8(0).u8(0).u8(3).u8(255).u8(255).text("short\n")}) {
            parser.feed(view(variables(wrong)), 0);
            QCOMPARE(parser.malformed(), static_cast<std::uint64_t>(++expected));
            QCOMPARE(parser.state().variables->front().text, QStringLiteral("1"));
        }
        QByteArray nested = QByteArray("\1\0\0", 3);
        for (int i = 0; i < 10'000; ++i) {
            nested += QByteArray("\21\0\1", 3);
        }
        parser.feed(view(variables(Wire().raw(nested))), 0);
        QCOMPARE(parser.malformed(), static_cast<std::uint64_t>(expected + 1));
    }

    // Real packages with random changes, and random bytes. The parser neither crashes nor hangs.
    void randomInputDoesNotCrash() {
        std::mt19937 random(1);
        const QByteArray good =
            versionMessage() + robotState(robotModeData(7, true) + configurationData()) +
            message(2, Wire().u32(5).u32(8).u8(1).u8(0).u8(1).u8(5).text("TitleX").bytes()) +
            message(10, Wire().i32(3).i32(1).text("oops").bytes());
        for (int round = 0; round < 5000; ++round) {
            QByteArray bytes = good;
            const int changes = 1 + static_cast<int>(random() % 8);
            for (int i = 0; i < changes; ++i) {
                bytes[static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()))] =
                    static_cast<char>(random());
            }
            PrimaryParser parser;
            parser.feed(view(bytes), 0);
            QVERIFY(parser.takeMessages().size() <= 10);
        }
    }
};

QTEST_GUILESS_MAIN(TestPrimaryParser)
#include "tst_primary_parser.moc"
