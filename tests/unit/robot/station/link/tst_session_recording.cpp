// SPDX-License-Identifier: GPL-3.0-or-later
//
// Content of the recordings of a session: displayed signals are recorded even if the link does not receive
// their fields.
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <functional>

#include "robot/recording/formats/open_recording.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"

using namespace tiller;
using namespace tiller::test;

namespace {

bool advanceUntil(VirtualCell& cell, const std::function<bool()>& condition) {
    constexpr int kWaitTimeoutMs = 60'000;
    QElapsedTimer waited;
    waited.start();
    while (!condition() && waited.elapsed() < kWaitTimeoutMs) {
        cell.advanceMs(16);
        QTest::qWait(1);
    }
    return condition();
}

}  // namespace

class TestSessionRecording : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void displayedRegistersAreRecorded_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QStringList>("fields");
        QTest::newRow("CSV") << QStringLiteral("csv") << QStringList();
        QTest::newRow("CSV, selected signals") << QStringLiteral("csv") << QStringList{"actual_q"};
        QTest::newRow("MCAP") << QStringLiteral("mcap") << QStringList();
    }

    // The link receives integer register 12, but not the other two registers.
    void displayedRegistersAreRecorded() {
        QFETCH(QString, format);
        QFETCH(QStringList, fields);
        const QTemporaryDir folder;
        VirtualClock clock;
        RobotSession session{clock};
        VirtualCell cell{clock, session};
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        const QStringList registers{"output_double_register_3", "output_int_register_0",
                                    "output_int_register_12"};
        const QString path = folder.filePath(QStringLiteral("run.") + format);
        session.recording().start({.path = path, .fields = fields, .shown = registers, .format = format});
        QVERIFY(advanceUntil(cell, [&] { return session.state().recording.rows > 200; }));
        QStringList messages;
        const auto listening = test::onMessage(session.journal(), &session,
                                               [&](Severity, const QString& text) { messages << text; });
        session.recording().reportDisplayed(registers);
        QVERIFY2(messages.isEmpty(), qPrintable(messages.join('\n')));
        session.recording().reportDisplayed(registers + QStringList{"output_int_register_5"});
        session.recording().reportDisplayed(registers + QStringList{"output_int_register_5"});
        QCOMPARE(messages.size(), 1);
        QVERIFY2(messages.front().contains("output_int_register_5"), qPrintable(messages.front()));
        QObject::disconnect(listening);
        session.recording().stop();
        QVERIFY(advanceUntil(cell, [&] { return !session.state().recording.active; }));
        const auto file = recording::openRecording(path);
        QVERIFY2(file.ok(), qPrintable(file.error().toString()));
        for (const QString& name : registers) {
            const auto column = (*file)->indexOf(name.toStdString());
            QVERIFY2(column, qPrintable(name));
            const std::array<std::size_t, 1> wanted{*column};
            QCOMPARE((*file)->read(wanted, {100, 1})->front().front(), 0.0);
        }
        QVERIFY((*file)->indexOf("actual_q_5") && (*file)->indexOf("timestamp"));
        QCOMPARE((*file)->indexOf("robot_mode").has_value(), fields.isEmpty());
    }

    void metadataIsRecorded_data() {
        QTest::addColumn<QString>("format");
        QTest::newRow("CSV") << QStringLiteral("csv");
        QTest::newRow("MCAP") << QStringLiteral("mcap");
    }
    void metadataIsRecorded() {
        QFETCH(QString, format);
        const QTemporaryDir folder;
        VirtualClock clock;
        RobotSession session{clock};
        VirtualCell cell{clock, session};
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        const QString path = folder.filePath(QStringLiteral("run.") + format);
        session.recording().start(
            {.path = path, .format = format, .metadata = {{"operator", "Ann"}, {"sample", "7 b"}}});
        QVERIFY(advanceUntil(cell, [&] { return session.state().recording.rows > 20; }));
        session.recording().stop();
        QVERIFY(advanceUntil(cell, [&] { return !session.state().recording.active; }));
        const auto file = recording::openRecording(path);
        QVERIFY2(file.ok(), qPrintable(file.error().toString()));
        QCOMPARE((*file)->facts().at("operator"), std::string("Ann"));
        QCOMPARE((*file)->facts().at("sample"), std::string("7 b"));
        QVERIFY(!(*file)->facts().at("software").empty());
        QVERIFY((*file)->startUtcNs().has_value());
    }

    // The trigger uses a register that the link does not receive.
    void aTriggerStartsTheRecording() {
        const QTemporaryDir folder;
        VirtualClock clock;
        RobotSession session{clock};
        VirtualCell cell{clock, session};
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        QStringList messages;
        const test::Listening listening = test::onMessage(
            session.journal(), &session, [&](Severity, const QString& text) { messages << text; });
        const QString path = folder.filePath(QStringLiteral("run.mcap"));
        session.recording().start(
            {.path = path,
             .format = QStringLiteral("mcap"),
             .trigger = QStringLiteral("output_int_register_3 = 5 or runtime_state changes"),
             .before = 0.1});
        QVERIFY(advanceUntil(cell, [&] { return session.state().recording.waiting; }));
        QVERIFY(session.state().recording.active);
        QVERIFY2(messages.last().contains("output_int_register_3"), qPrintable(messages.last()));
        cell.advanceMs(500);
        session.recording().stop();
        QVERIFY(advanceUntil(cell, [&] { return !session.state().recording.active; }));
        QTRY_VERIFY_WITH_TIMEOUT(messages.last().contains("has not occurred"), 60'000);
        QVERIFY(!QFileInfo::exists(path) && !QFileInfo::exists(folder.filePath("run_001.mcap")));

        session.recording().start({.path = path,
                                   .format = QStringLiteral("mcap"),
                                   .trigger = QStringLiteral("robot_mode = 7 and wrong"),
                                   .before = 0.1});
        QVERIFY2(messages.last().contains("wrong"), qPrintable(messages.last()));
        QVERIFY(!session.state().recording.active);
    }

    // The connection table of the controller is full: the fields of the link are recorded, and a warning
    // names the other fields.
    void withoutASecondConnectionTheLinkIsRecorded_data() {
        QTest::addColumn<QString>("format");
        QTest::newRow("CSV") << QStringLiteral("csv");
        QTest::newRow("MCAP") << QStringLiteral("mcap");
    }
    void withoutASecondConnectionTheLinkIsRecorded() {
        QFETCH(QString, format);
        const QTemporaryDir folder;
        VirtualClock clock;
        RobotSession session{clock};
        VirtualCell cell{clock, session};
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        QVERIFY(cell.robot.inject("rtde-clients 1").ok());
        QStringList warnings;
        const test::Listening listening =
            onMessage(session.journal(), &session, [&](Severity severity, const QString& text) {
                if (severity != Severity::Info) {
                    warnings << text;
                }
            });
        const QString path = folder.filePath(QStringLiteral("run.") + format);
        session.recording().start(
            {.path = path,
             .shown = {"output_double_register_3", "output_int_register_0", "output_int_register_12"},
             .format = format});
        QVERIFY(advanceUntil(cell, [&] { return session.state().recording.rows > 200; }));
        QVERIFY(advanceUntil(cell, [&] { return !warnings.isEmpty(); }));
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings[0].contains("output_double_register_3, output_int_register_0") &&
                     !warnings[0].contains("output_int_register_12"),
                 qPrintable(warnings[0]));
        // The warning is not repeated when the displayed signals change.
        session.recording().reportDisplayed({"output_int_register_0"});
        QCOMPARE(warnings.size(), 1);
        session.recording().stop();
        QVERIFY(advanceUntil(cell, [&] { return !session.state().recording.active; }));
        const auto file = recording::openRecording(path);
        QVERIFY2(file.ok(), qPrintable(file.error().toString()));
        QVERIFY((*file)->indexOf("output_int_register_12") && (*file)->indexOf("actual_q_5"));
        QVERIFY(!(*file)->indexOf("output_int_register_0") && !(*file)->indexOf("output_double_register_3"));
        QCOMPARE(cell.robot.rtdeClients(), 1);
    }
};

QTEST_MAIN(TestSessionRecording)
#include "tst_session_recording.moc"
