// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>

#include "widgets/common/elided_label.h"
#include "widgets/common/theme.h"
#include "widgets/status/status_line.h"

using namespace tiller;

class TestStatusLine : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void recordingShowsTimeRowsFileAndSpace() {
        StatusLine line;
        line.show();
        QCOMPARE(line.recordingText(), QStringLiteral("Not recording"));
        SessionState state;
        state.recording.active = true;
        state.recording.path = QStringLiteral("/data/pick-and-place.csv");
        state.recording.rows = 96000;
        state.recording.seconds = 192;
        state.recording.freeBytes = 80'000'000'000;
        line.applyState(state);
        QCOMPARE(line.recordingText(), QStringLiteral("REC 00:03:12"));
        const QString details = line.findChild<ElidedLabel*>(QStringLiteral("recordingDetails"))->fullText();
        QVERIFY(details.contains(QStringLiteral("pick-and-place.csv")));
        QVERIFY(details.contains(QStringLiteral("80 GB free")));
        QVERIFY(details.startsWith(QStringLiteral("96")));
        auto* label = line.findChild<QLabel*>(QStringLiteral("recordingState"));
        QCOMPARE(label->palette().color(QPalette::WindowText), Theme::light().recording);
    }
    void failedRecordingGivesTheReason() {
        StatusLine line;
        line.show();
        SessionState state;
        state.recording.rows = 96'000;
        state.recording.error = QStringLiteral("Disk full: 96 000 samples are kept");
        line.applyState(state);
        QCOMPARE(line.recordingText(), QStringLiteral("Recording stopped"));
        QCOMPARE(line.findChild<ElidedLabel*>(QStringLiteral("recordingDetails"))->fullText(),
                 state.recording.error);
    }
    void messageHasItsTimeAndItsColour() {
        StatusLine line;
        line.show();
        line.showMessage(Severity::Error, QStringLiteral("Link lost"));
        QVERIFY(QRegularExpression(QStringLiteral("^\\d\\d:\\d\\d:\\d\\d Link lost$"))
                    .match(line.messageText())
                    .hasMatch());
        const auto* label = line.findChild<QLabel*>(QStringLiteral("lastMessage"));
        QCOMPARE(label->palette().color(QPalette::WindowText), Theme::light().alarm);
        line.showMessage(Severity::Info, QStringLiteral("Connected"));
        QCOMPARE(label->palette().color(QPalette::WindowText), Theme::light().secondary);
    }
    void theSolutionStaysVisibleWhenSpaceIsShort() {
        StatusLine line;
        line.resize(700, StatusLine::kHeight);
        line.show();
        line.showMessage(
            Severity::Error,
            QStringLiteral("Connection ended by the robot: RTDE at 10.255.255.1:30004, waiting for "
                           "the reply to RTDE_REQUEST_PROTOCOL_VERSION. Restart the robot."));
        QCoreApplication::processEvents();
        const QString shown = line.findChild<QLabel*>("lastMessage")->text();
        QVERIFY(shown.contains(QChar(0x2026)));
        QVERIFY2(shown.endsWith("Restart the robot."), qPrintable(shown));
    }

    // The log keeps the message. The status line would show it as if the problem still existed.
    void aWarningEndsWithItsCause() {
        StatusLine line;
        line.show();
        SessionState state;
        state.link = LinkState::Live;
        state.sequence = 1;
        state.robotMode = RobotMode::Running;
        state.safetyMode = SafetyMode::Normal;
        state.control = ControlState::InControl;
        line.applyState(state);
        line.showMessage(Severity::Warning, QStringLiteral("Protective stop"));
        line.applyState(state);
        QVERIFY2(line.messageText().contains("Protective stop"),
                 "the message disappeared before the robot reported the stop");
        state.safetyMode = SafetyMode::ProtectiveStop;
        line.applyState(state);
        line.showMessage(Severity::Error, QStringLiteral("Control lost"));
        state.control = ControlState::None;
        line.applyState(state);
        QVERIFY(line.messageText().contains("Control lost"));
        state.safetyMode = SafetyMode::Normal;
        line.applyState(state);
        QCOMPARE(line.messageText(), QString());
        line.showMessage(Severity::Warning, QStringLiteral("Take control refused"));
        line.applyState(state);
        QVERIFY(line.messageText().contains("refused"));
        state.control = ControlState::InControl;
        line.applyState(state);
        QCOMPARE(line.messageText(), QString());
    }
    void aMessageIsShownInFullWhenItFits() {
        StatusLine line;
        line.resize(1200, StatusLine::kHeight);
        line.show();
        line.showMessage(Severity::Warning, QStringLiteral("Words and words and words ").repeated(4));
        QCoreApplication::processEvents();
        const auto* label = line.findChild<ElidedLabel*>("lastMessage");
        QCOMPARE(label->text(), label->fullText());
    }

    void coloursFollowTheTheme() {
        StatusLine line;
        line.show();
        line.showMessage(Severity::Warning, QStringLiteral("late"));
        applyTheme(*qApp, Theme::dark());
        const auto* label = line.findChild<QLabel*>(QStringLiteral("lastMessage"));
        QCOMPARE(label->palette().color(QPalette::WindowText), Theme::dark().warning);
        applyTheme(*qApp, Theme::light());
        QCOMPARE(label->palette().color(QPalette::WindowText), Theme::light().warning);
    }
    void theProjectNameIsShown() {
        StatusLine line;
        line.show();
        line.setProjectText(QStringLiteral("cell-7.tiller — saved"));
        QCOMPARE(line.findChild<ElidedLabel*>(QStringLiteral("projectFile"))->fullText(),
                 QStringLiteral("cell-7.tiller — saved"));
    }

    // The error of a recording stays until the next recording, so it leaves space for newer messages.
    void theErrorOfARecordingLeavesSpaceForMessages() {
        StatusLine line;
        line.resize(1280, StatusLine::kHeight);
        SessionState state;
        state.recording.rows = 100;
        state.recording.path = QStringLiteral("/data/first.csv");
        state.recording.error = QStringLiteral("Disk full: /data/") + QString(150, QLatin1Char('x')) +
                                QStringLiteral(".csv. Free some space on the disk, then record again.");
        line.applyState(state);
        line.showMessage(Severity::Error, QStringLiteral("The program of another client has ended. Check the "
                                                         "robot, then take control."));
        line.show();
        QVERIFY(QTest::qWaitForWindowExposed(&line));
        const auto* details = line.findChild<ElidedLabel*>(QStringLiteral("recordingDetails"));
        const auto* message = line.findChild<ElidedLabel*>(QStringLiteral("lastMessage"));
        QCOMPARE(details->toolTip(), state.recording.error);
        QVERIFY2(message->width() >= 1280 / 3, qPrintable(QString::number(message->width())));
        state.recording.error.clear();
        line.applyState(state);
        QVERIFY(details->toolTip().isEmpty());
    }
};

QTEST_MAIN(TestStatusLine)
#include "tst_status_line.moc"
