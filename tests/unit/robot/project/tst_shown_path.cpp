// SPDX-License-Identifier: MIT
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <random>

#include "robot/core/angles.h"
#include "robot/project/demonstration.h"
#include "robot/recording/csv_reader.h"

using namespace tiller;
using namespace tiller::project;

namespace {

const DhParameters& arm() {
    return robotModel(RobotModelId::UR5e).dh;
}
const Pose kTool(0.01, 0.02, 0.15, 0, 0, 0);

/// Simulates an operator who guides the arm by hand: slow waves, corners, pauses, reversals and a tremor.
Demonstration shownBy(std::mt19937& random, int samples, double tremble) {
    std::uniform_real_distribution<double> unit(-1, 1);
    std::normal_distribution<double> noise(0, tremble > 0 ? tremble : 1);
    Demonstration shown;
    Vector6 q;
    q << -1.6, -1.7, -2.2, -0.8, 1.6, 0;
    Vector6 wanted = Vector6::Zero();
    Vector6 qd = Vector6::Zero();
    for (int i = 0; i < samples; ++i) {
        if (i % 200 == 0) {
            for (int joint = 0; joint < 6; ++joint) {
                wanted[joint] = unit(random) * (i % 600 == 400 ? 0 : 0.6);  // [rad/s]
            }
            qd = i % 1000 == 0 ? wanted : qd;  // an occasional corner
        }
        qd += 0.02 * (wanted - qd);
        q += 0.002 * qd;
        Vector6 seen = q;
        for (int joint = 0; tremble > 0 && joint < 6; ++joint) {
            seen[joint] += noise(random);
        }
        shown.append(100 + 0.002 * i, JointPositions(seen));
    }
    return shown;
}

Result<Demonstration> fromTable(const recording::CsvTable& table) {
    std::array<const std::vector<double>*, 6> joints{};
    for (std::size_t joint = 0; joint < 6; ++joint) {
        joints[joint] = table.column("actual_q_" + std::to_string(joint));
        if (joints[joint] == nullptr) {
            return Error{ErrorCode::FileCorrupt, {}, {}};
        }
    }
    const std::vector<double>* times = table.column("timestamp");
    return times != nullptr ? demonstrationFrom(*times, joints) : Error{ErrorCode::FileCorrupt, {}, {}};
}

}  // namespace

class TestDemonstration : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // For every demonstration, each demonstrated position is within the permitted distance of the stored
    // path.
    void everyShownPointIsWithinTheTolerance() {
        std::mt19937 random(1);
        int kept = 0;
        int samples = 0;
        for (int round = 0; round < 40; ++round) {
            const double tremble = round % 4 == 0 ? 0 : 0.0002 * (round % 4);
            const Demonstration shown = shownBy(random, 500 + 137 * (round % 9), tremble);
            PathTolerance tolerance;
            tolerance.tcp = round % 3 == 0 ? 0.0002 : round % 3 == 1 ? 0.001 : 0.01;
            tolerance.joints = toRadians(round % 2 == 0 ? 0.1 : 2);
            const std::vector<KeptPlace> path = keptPath(shown, arm(), kTool, tolerance);
            const PathDeviation off = deviation(shown, path, arm(), kTool, tolerance);
            QVERIFY2(off.joints <= tolerance.joints * (1 + 1e-9), qPrintable(QString::number(off.joints)));
            QVERIFY2(off.tcp <= tolerance.tcp * (1 + 1e-9), qPrintable(QString::number(off.tcp)));
            QVERIFY(path.front().q == shown.q.front());
            QVERIFY(path.back().q == shown.q.back());
            QCOMPARE(path.front().time, shown.times.front());
            QCOMPARE(path.back().time, shown.times.back());
            for (std::size_t i = 1; i < path.size(); ++i) {
                QVERIFY(path[i].time > path[i - 1].time);
            }
            if (tolerance.tcp == 0.001 && tremble == 0) {
                kept += static_cast<int>(path.size());
                samples += static_cast<int>(shown.size());
            }
        }
        QVERIFY2(kept * 20 < samples, qPrintable(QStringLiteral("%1 of %2").arg(kept).arg(samples)));
    }

    void aStraightPathNeedsTwoPoints() {
        Demonstration shown;
        for (int i = 0; i < 1000; ++i) {
            shown.append(0.002 * i, JointPositions(0.001 * i, -1.5, 1.5, -1.5, -1.5, 0));
        }
        QCOMPARE(keptPath(shown, arm(), {}, {}).size(), std::size_t(2));
        QVERIFY(keptPath({}, arm(), {}, {}).empty());
        Demonstration one;
        one.append(0, shown.q.front());
        QCOMPARE(keptPath(one, arm(), {}, {}).size(), std::size_t(1));
    }

    // A movement in both directions is not a straight path, although it starts and ends at the same position.
    void theFarEndOfAReturnPathIsKept() {
        Demonstration shown;
        for (int i = 0; i <= 1000; ++i) {
            const double turn = 0.001 * (i <= 500 ? i : 1000 - i);
            shown.append(0.002 * i, JointPositions(turn, -1.5, 1.5, -1.5, -1.5, 0));
        }
        const auto path = keptPath(shown, arm(), {}, {});
        double furthest = 0;
        for (const KeptPlace& place : path) {
            furthest = std::max(furthest, place.q[0]);
        }
        QVERIFY2(furthest > 0.5 - 0.0087, qPrintable(QString::number(furthest)));
    }

    void standstillAtTheEndsIsTrimmed() {
        Demonstration shown;
        for (int i = 0; i < 300; ++i) {
            const int moved = std::clamp(i - 100, 0, 100);
            shown.append(0.002 * i, JointPositions(0.002 * moved, -1.5, 1.5, -1.5, -1.5, 0));
        }
        const Demonstration moving = withoutPauses(shown);
        QVERIFY(moving.size() >= 100 && moving.size() <= 104);
        QVERIFY(moving.q.front() == shown.q.front());
        QVERIFY((moving.q.back().values - shown.q.back().values).cwiseAbs().maxCoeff() < 0.0006);
    }

    void theTableRoundTrips() {
        std::mt19937 random(2);
        const Demonstration shown = shownBy(random, 400, 0.0003);
        QTemporaryDir folder;
        const QString path = folder.filePath("demonstration.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(demonstrationCsv(shown));
        file.close();
        const auto table = recording::readCsv(path);
        QVERIFY2(table.ok(), "readable");
        QCOMPARE(table->columns.front(), std::string("timestamp"));
        const Result<Demonstration> again = fromTable(*table);
        QVERIFY(again.ok());
        QCOMPARE(again->times, shown.times);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            QVERIFY(again->q[i] == shown.q[i]);
        }
    }

    // Samples along the stored path follow it with its timing.
    void samplesLieOnThePath() {
        std::mt19937 random(3);
        const Demonstration shown = shownBy(random, 800, 0);
        const auto path = keptPath(shown, arm(), kTool, {});
        const Demonstration along = alongPath(path, 0.008);
        QVERIFY(along.q.front() == path.front().q && along.q.back() == path.back().q);
        QCOMPARE(along.times.back(), shown.times.back());
        for (std::size_t i = 1; i < along.size(); ++i) {
            const double step = along.times[i] - along.times[i - 1];
            QVERIFY(step > 0 && step < 0.008 + 1e-9);
        }
        const PathDeviation off = deviation(along, path, arm(), kTool);
        QVERIFY(off.joints < 1e-9 && off.tcp < 1e-9);
    }

    void invalidRowsAreReported_data() {
        QTest::addColumn<std::vector<double>>("times");
        QTest::addColumn<std::vector<double>>("first");
        QTest::addColumn<QString>("said");
        using V = std::vector<double>;
        QTest::newRow("no number") << V{0, 1, 2} << V{0, std::nan(""), 0} << "row 2";
        QTest::newRow("time stands still") << V{0, 1, 1} << V{0, 0, 0} << "row 3";
        QTest::newRow("degrees") << V{0, 1} << V{-90, -89} << "degrees";
        QTest::newRow("one row") << V{0} << V{0} << "two rows";
        QTest::newRow("no row") << V{} << V{} << "two rows";
        QTest::newRow("a short column") << V{0, 1, 2} << V{0, 0} << "row 3";
    }
    void invalidRowsAreReported() {
        QFETCH(std::vector<double>, times);
        QFETCH(std::vector<double>, first);
        QFETCH(QString, said);
        const std::vector<double> zeros(times.size(), 0.0);
        const auto shown = demonstrationFrom(times, {&first, &zeros, &zeros, &zeros, &zeros, &zeros});
        QVERIFY(!shown.ok());
        QCOMPARE(shown.error().code, ErrorCode::FileCorrupt);
        QVERIFY2(shown.error().context.contains(said), qPrintable(shown.error().context));
    }

    void mutatedTablesNeverCrash() {
        std::mt19937 random(4);
        const QByteArray whole = demonstrationCsv(shownBy(random, 30, 0.0003));
        QTemporaryDir folder;
        const QString path = folder.filePath("mutated.csv");
        int refused = 0;
        for (int round = 0; round < 1000; ++round) {
            QByteArray bytes = whole;
            for (int i = 0; i < 1 + round % 5; ++i) {
                const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()));
                switch (random() % 3) {
                    case 0:
                        bytes[at] = static_cast<char>(random() % 256);
                        break;
                    case 1:
                        bytes.remove(at, static_cast<qsizetype>(random() % 40));
                        break;
                    default:
                        bytes.insert(at, bytes.mid(at / 2, 25));
                        break;
                }
                bytes = bytes.isEmpty() ? whole : bytes;
            }
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
            file.write(bytes);
            file.close();
            const auto table = recording::readCsv(path);
            const Result<Demonstration> shown =
                table ? fromTable(*table) : Result<Demonstration>(table.error());
            if (!shown) {
                ++refused;
                continue;
            }
            for (const JointPositions& q : shown->q) {
                QVERIFY(q.values.allFinite());
            }
            (void)keptPath(*shown, arm(), {}, {});
        }
        QVERIFY(refused > 0 && refused < 1000);
    }
};

QTEST_APPLESS_MAIN(TestDemonstration)
#include "tst_shown_path.moc"
