// SPDX-License-Identifier: MIT
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <memory>

#include "robot/recording/mcap/mcap_recording.h"
#include "robot/station/station.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"

using namespace tiller;

namespace {

struct Bench {
    VirtualClock clock;
    Station station{"Lab UR5e", std::make_unique<ProjectDocument>(), clock};
    test::VirtualCell cell{clock, station.session()};
};

project::Waypoint home() {
    project::Waypoint waypoint;
    waypoint.id = QUuid::createUuid();
    waypoint.name = "home";
    return waypoint;
}

}  // namespace

class TestStation : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theHistoryNeedsNoView() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.station.history().setStepLabel("Step 2 (MoveL)");
        bench.cell.advanceMs(1000);
        const SignalStore& store = bench.station.history().store();
        QVERIFY(store.live().lastTime() - store.live().firstTime() > 0.9);
        const int joint = store.find("actual_q_0");
        QVERIFY(joint >= 0);
        const double value = store.valueAt(joint, store.live().lastTime()).value();
        QVERIFY2(std::abs(value - bench.cell.truth().q[0]) < 1e-6, qPrintable(QString::number(value)));
        const auto& segments = bench.station.history().lane().segments();
        QVERIFY(!segments.empty() && segments.back().kind != LaneKind::NoData);
        QVERIFY2(std::abs(bench.station.history().plotTime(bench.station.session().state().robotTime) -
                          segments.back().end) < 1e-6,
                 "the lane does not end at the newest sample");
    }

    void displayedFieldsAreRequestedFromTheRobot() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        SignalStore& store = bench.station.history().store();
        const int extra = store.find("output_int_register_3");
        QVERIFY(extra >= 0);
        QSignalSpy samples(&bench.station.session(), &RobotSession::extraSamplesReceived);
        QVERIFY(store.want(this, {extra}));
        QVERIFY(bench.cell.advanceUntil([&] { return samples.size() > 2; }, 60'000));
        QVERIFY(!store.further().isEmpty());
    }

    void theCellOfTheProjectProtectsTheArm() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        const JointPositions path = bench.cell.truth().q;
        QVERIFY(bench.station.session().permitsPath({&path, 1}).ok());
        const test::EventSpy messages(bench.station.journal());
        project::CellGeometry cell = bench.station.document().cell();
        project::CellBox box;
        box.id = QUuid::createUuid();
        box.name = "crate";
        box.frame = QUuid::createUuid();  // not in the project, so the position of the box is unknown
        cell.boxes.append(box);
        bench.station.document().changeCell(cell, "Add crate");
        QCOMPARE(messages.count(), 1);
        QVERIFY2(messages.front().text.contains("“crate”"), qPrintable(messages.front().text));
        QVERIFY(!bench.station.session().permitsPath({&path, 1}).ok());
    }

    void recordingsContainTheProject() {
        const QTemporaryDir folder;
        Bench bench;
        const QString file = folder.filePath("cell-7.tiller");
        QVERIFY(bench.station.file().saveAs(file).ok());
        bench.station.document().insertWaypoints(0, {home()}, "Teach");
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const QString path = folder.filePath("run.mcap");
        bench.station.session().recording().start({.path = path, .format = "mcap"});
        const auto isRecording = [&] { return bench.station.session().state().recording.active; };
        QVERIFY(bench.cell.advanceUntil(isRecording, 60'000));
        bench.cell.advanceMs(200);
        bench.station.session().recording().stop();
        QVERIFY(bench.cell.advanceUntil([&] { return !isRecording(); }, 60'000));
        const auto recording = recording::openMcap(path);
        QVERIFY2(recording.ok(), qPrintable(recording.error().toString()));
        const QByteArray project = recording.value()->attachment("cell-7.tiller").value();
        QVERIFY2(project.contains("\"home\""), project.constData());
    }

    void unsavedChangesAreSavedAtTheEnd() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("cell-7.tiller");
        {
            Station station("Lab UR5e", std::make_unique<ProjectDocument>());
            QVERIFY(station.file().saveAs(file).ok());
            station.document().insertWaypoints(0, {home()}, "Teach");
        }
        QFile saved(file);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QVERIFY(saved.readAll().contains("\"home\""));
    }

    void aStopIsRecorded() {
        Bench bench;
        QVERIFY(bench.station.incidents() == nullptr);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(500);
        bench.cell.robot.protectiveStop();
        QVERIFY(bench.cell.advanceUntil([&] { return bench.station.stops().last().has_value(); }, 10'000));
        QVERIFY(bench.station.stops().last()->points.size() > 200);
    }
};

QTEST_GUILESS_MAIN(TestStation)
#include "tst_station.moc"
