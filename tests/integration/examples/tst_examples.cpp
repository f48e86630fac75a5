// SPDX-License-Identifier: MIT
// Runs the C++ examples unchanged, each with separate simulated robots, and checks the effects.
#include <unistd.h>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/recording/csv_reader.h"
#include "robot/simulator/arm/environment.h"
#include "robot/simulator/simulator.h"

using namespace tiller;

namespace {

struct Outcome {
    int code = -1;
    QString out;
    QString err;
    double furthest = 0;  ///< maximum distance of the TCP from its start [m]
};

/// A robot on a separate address with the standard ports.
std::unique_ptr<simulator::Simulator> robotAt(int number) {
    simulator::SimulatorOptions options;
    options.listenAddress =
        QStringLiteral("127.%1.%2.%3").arg(10 + getpid() % 200).arg(getpid() / 200 % 250).arg(20 + number);
    options.poweredOn = true;
    options.fastTransitions = true;
    auto robot = std::make_unique<simulator::Simulator>(options);
    if (const auto started = robot->start(); !started) {
        qFatal("%s", qPrintable(started.error().toString()));
    }
    return robot;
}

struct Cell {
    std::vector<std::unique_ptr<simulator::Simulator>> robots;
    simulator::SimulatedState before;
    QTemporaryDir folder;

    explicit Cell(int count) {
        for (int i = 0; i < count; ++i) {
            robots.push_back(robotAt(i));
        }
        before = robot().truth();
    }
    simulator::Simulator& robot(std::size_t i = 0) const { return *robots.at(i); }
    simulator::SimulatedState truth(std::size_t i = 0) const { return robots.at(i)->truth(); }
    double rise() const { return truth().tcpPose.position.z() - before.tcpPose.position.z(); }
};

Outcome run(const QString& name, const Cell& cell) {
    QProcess program;
    program.setWorkingDirectory(cell.folder.path());
    QStringList addresses;
    for (const auto& robot : cell.robots) {
        addresses << robot->listenAddress();
    }
    program.start(QStringLiteral(TILLER_EXAMPLES_DIR "/") + name, addresses);
    Outcome outcome;
    while (!program.waitForFinished(5) && program.state() != QProcess::NotRunning) {
        outcome.furthest =
            std::max(outcome.furthest, (cell.truth().tcpPose.position - cell.before.tcpPose.position).norm());
    }
    outcome.code = program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1;
    outcome.out = QString::fromUtf8(program.readAllStandardOutput());
    outcome.err = QString::fromUtf8(program.readAllStandardError());
    return outcome;
}

/// True if the output shows that the computer was blocked for 100 ms. The arm then stops as intended.
bool wasLate(const Outcome& outcome) {
    for (const char* word : {"LinkLost", "EventLoopStalled", "DataStale", "Timeout", "not refreshed"}) {
        if (outcome.err.contains(QLatin1String(word)) || outcome.out.contains(QLatin1String(word))) {
            return true;
        }
    }
    return false;
}

struct Example {
    int robots;
    /// Prepares the robot before the example runs.
    std::function<void(Cell&)> prepare;
    /// Returns a description of the problem; empty if there is none.
    std::function<QString(const Cell&, const Outcome&)> check;
};

void nothing(Cell&) {}

QString unless(bool right, const QString& wrong) {
    return right ? QString() : wrong;
}

const std::map<QString, Example>& examples() {
    static const std::map<QString, Example> kExamples{
        {"read",
         {1, nothing,
          [](const Cell&, const Outcome& o) {
              return unless(o.out.contains("joints [rad] [-1.6") && o.out.count(" s ") == 5, o.out);
          }}},
        {"record",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) {
              const auto table = recording::readCsv(cell.folder.filePath("recording.csv"));
              if (!table) {
                  return table.error().toString();
              }
              const auto* force = table->column("actual_TCP_force_2");
              return unless(force != nullptr && table->rows() > 100 &&
                                o.out.startsWith(QString::number(table->rows()) + " rows"),
                            o.out);
          }}},
        {"jog",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) {
              return unless(cell.rise() > 0.02 && cell.rise() < 0.06, o.out);
          }}},
        {"move_and_wait",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) {
              const Pose joints = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh,
                                                         {-1.6, -1.7, -2.2, -0.8, 1.6, 0.3});
              const Eigen::Vector3d up = cell.truth().tcpPose.position - joints.position;
              return unless((up - Eigen::Vector3d(0, 0, 0.05)).norm() < 1e-3, o.out);
          }}},
        {"servo_circle",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) {
              const double off = (cell.truth().tcpPose.position - cell.before.tcpPose.position).norm();
              return unless(o.furthest > 0.055 && o.furthest < 0.065 && off < 0.01,
                            QStringLiteral("%1 m away, then %2; %3").arg(o.furthest).arg(off).arg(o.out));
          }}},
        {"force",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) { return unless(cell.rise() < -0.002, o.out); }}},
        {"contact",
         {1,
          [](Cell& cell) {
              simulator::arm::ContactPlane floor;
              floor.point = cell.before.tcpPose.position - Eigen::Vector3d(0, 0, 0.05);
              cell.robot().changeWorld([floor](auto& world) { world.addPlane(floor); });
          },
          [](const Cell& cell, const Outcome& o) {
              return unless(std::abs(cell.rise() + 0.05) < 0.01 && o.out.startsWith("contact at"), o.out);
          }}},
        {"outputs",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) {
              return unless(cell.truth().digitalOutputs == 1 && o.out.startsWith("outputs 1,"), o.out);
          }}},
        {"one_robot",
         {1, nothing,
          [](const Cell& cell, const Outcome& o) {
              const double turned = cell.truth().q[5] - simulator::kHomeJoints[5];
              return unless(std::abs(turned - 0.3) < 2e-3 && cell.truth().digitalOutputs == 1 &&
                                o.out.contains("event MotionEnded") && o.out.contains("service Dashboard"),
                            o.out);
          }}},
        {"several_robots",
         {2, nothing,
          [](const Cell& cell, const Outcome& o) {
              const double first = cell.truth(0).q[5] - simulator::kHomeJoints[5];
              const double second = cell.truth(1).q[5] - simulator::kHomeJoints[5];
              return unless(
                  std::abs(first - 0.3) < 2e-3 && std::abs(second - 0.3) < 2e-3 && o.out.count("took ") == 2,
                  o.out);
          }}},
        {"simulate",
         {1, nothing,
          [](const Cell&, const Outcome& o) { return unless(o.out.contains("UnsafeState"), o.out); }}},
    };
    return kExamples;
}

}  // namespace

class TestExamples : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void thereAreElevenShortExamples() {
        const QDir folder(QStringLiteral(TILLER_SOURCE_DIR "/robot/examples/cpp"));
        const QStringList files = folder.entryList({"*.cpp"}, QDir::Files, QDir::Name);
        QCOMPARE(files.size(), 11);
        for (const QString& file : files) {
            QVERIFY2(examples().count(file.chopped(4)) == 1, qPrintable(file));
            QFile text(folder.filePath(file));
            QVERIFY(text.open(QIODevice::ReadOnly));
            const QByteArray all = text.readAll();
            QVERIFY2(all.count('\n') < 30, qPrintable(file));
            QVERIFY2(all.startsWith("// SPDX-License-Identifier: MIT\n// "), qPrintable(file));
        }
    }

    void everyExampleWorksAsDocumented_data() {
        QTest::addColumn<QString>("name");
        for (const auto& [name, example] : examples()) {
            QTest::newRow(qPrintable(name)) << name;
        }
    }
    void everyExampleWorksAsDocumented() {
        QFETCH(QString, name);
        const Example& example = examples().at(name);
        constexpr int kAttempts = 10;
        for (int attempt = 1; attempt <= kAttempts; ++attempt) {
            Cell cell(example.robots);
            example.prepare(cell);
            const Outcome outcome = run(name, cell);
            if (wasLate(outcome) && attempt < kAttempts) {
                continue;  // this computer was too busy, so try again
            }
            QVERIFY2(outcome.code == 0, qPrintable(outcome.out + outcome.err));
            QTRY_VERIFY_WITH_TIMEOUT(cell.truth().qd.values.norm() < 2e-3, 20'000);
            const QString wrong = example.check(cell, outcome);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong + outcome.err));
            return;
        }
    }

    void missingRobotIsReported() {
        QProcess program;
        program.start(QStringLiteral(TILLER_EXAMPLES_DIR "/move_and_wait"), {QStringLiteral("127.0.0.213")});
        QVERIFY(program.waitForFinished(30'000));
        QCOMPARE(program.exitCode(), EXIT_FAILURE);
        const QByteArray said = program.readAllStandardError();
        QVERIFY2(said.contains("ConnectionRefused") && said.contains("127.0.0.213"), said.constData());
    }
};

QTEST_GUILESS_MAIN(TestExamples)
#include "tst_examples.moc"
