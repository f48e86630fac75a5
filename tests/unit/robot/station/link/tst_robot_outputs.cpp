// SPDX-License-Identifier: MIT
// Outputs of a session without a connection.
#include <QTest>

#include "robot/station/link/robot_session.h"
#include "tests/support/event_spy.h"

using namespace tiller;

class TestRobotOutputs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aCommandWithoutAConnectionIsReported() {
        RobotSession session;
        QStringList errors;
        test::onMessage(session.journal(), this, [&errors](Severity severity, const QString& text) {
            if (severity == Severity::Error) {
                errors << text;
            }
        });
        std::optional<ErrorCode> code;
        session.outputs().setDigitalOutputs(
            1, 1, QStringLiteral("Lamp"),
            {.done = [&code](const Result<void>& result) { code = result.error().code; }});
        QCOMPARE(code, std::optional(ErrorCode::NotConnected));
        QCOMPARE(errors.size(), 1);
        QVERIFY2(errors.front().contains("Lamp"), qPrintable(errors.front()));
    }
};

QTEST_GUILESS_MAIN(TestRobotOutputs)
#include "tst_robot_outputs.moc"
