// SPDX-License-Identifier: MIT
// The end of a recorded path, with the simulated controller in virtual time.
#include <QTest>

#include "robot/station/document/project_document.h"
#include "robot/station/route/path_recorder.h"
#include "tests/support/virtual_cell.h"

using namespace tiller;
using namespace tiller::test;

class TestPathRecorder : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // The owner may ask the user before it keeps or discards the path.
    void theEndIsReportedOnce() {
        VirtualClock clock;
        RobotSession session{clock};
        VirtualCell cell{clock, session};
        ProjectDocument document;
        PathRecorder recorder(session, document);
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        int ends = 0;
        connect(&recorder, &PathRecorder::ended, this, [&ends] { ++ends; });
        for (int recording = 1; recording <= 2; ++recording) {
            QVERIFY(cell.advanceUntil([&] { return session.state().link == LinkState::Live; }, 5'000));
            recorder.start();
            QVERIFY(recorder.isRecording());
            QVERIFY(cell.robot.inject("link lost").ok());
            for (int t = 0; t < 2'000; t += 2) {  // no packets arrive
                clock.advanceNs(2 * kNsPerMs);
                cell.robot.step();
                QTest::qWait(1);
                session.refresh();
            }
            QCOMPARE(session.state().link, LinkState::Lost);
            QVERIFY(cell.robot.inject("link back").ok());
            QCOMPARE(ends, recording);
            QVERIFY(recorder.isRecording());
            recorder.abandon();
            for (int t = 0; t < 60'000 && session.state().link != LinkState::Live; t += 2) {
                clock.advanceNs(2 * kNsPerMs);
                cell.robot.step();
                QTest::qWait(1);
                session.refresh();
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestPathRecorder)
#include "tst_path_recorder.moc"
