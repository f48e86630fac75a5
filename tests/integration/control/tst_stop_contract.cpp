// SPDX-License-Identifier: MIT
//
// The stop contract of the native library: whatever moves the arm, and whatever happens to the one who moves
// it, to the link or to the robot, the arm stands in time and nothing resumes; also where a real controller
// behaves in another way than ours does by default.
//
// Runs a part of the table, drawn anew for each reading but the same each time. All of it, and 200 random
// combinations of readings:
//
//     tst_stop_contract --all

#include <QElapsedTimer>
#include <algorithm>
#include <cstdio>
#include <map>

#include "tests/integration/control/contract_cell.h"

using namespace tiller;
using namespace tiller::test;

namespace {

bool runsAll = false;
constexpr quint32 kSeed = 20261123;

simulator::Assumptions assumed(const QString& words) {
    simulator::Assumptions assumptions;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (const auto taken = simulator::assume(assumptions, word); !taken) {
            qFatal("%s", qPrintable(taken.error().context));
        }
    }
    return assumptions;
}

/// Worst of what was seen, by motion and event.
struct Worst {
    double standstillMs = 0;
    double driftMm = 0;
    double resumedMm = 0;
    int cells = 0;
};
std::map<std::pair<std::size_t, std::size_t>, Worst> worst;

}  // namespace

class TestStopContract : public QObject {
    Q_OBJECT

    static void check(std::size_t m, std::size_t e, const QString& words, double slider,
                      QStringList& problems) {
        const ContractMotion& motion = contractMotions()[m];
        const ContractEvent& event = contractEvents()[e];
        // Where forces go on in a pause, and the process dies in it, nobody is left who could end them: the
        // program stands still and the PC is gone.
        if (motion.yields && event.losesBoth && words.contains(QLatin1String("pause=frees"))) {
            return;
        }
        const ContractOutcome outcome = ContractCell(assumed(words), slider).run(motion, event);
        if (!outcome.applies) {
            return;
        }
        if (!outcome.problem.isEmpty()) {
            problems << QStringLiteral("%1 x %2, slider %3, %4: %5")
                            .arg(QLatin1String(motion.name), QLatin1String(event.name))
                            .arg(slider)
                            .arg(words.isEmpty() ? QStringLiteral("as by default") : words, outcome.problem);
            std::fprintf(stderr, "%s\n", qPrintable(problems.last()));
        }
        Worst& w = worst[{m, e}];
        w.standstillMs = std::max(w.standstillMs, outcome.standstillMs);
        w.driftMm = std::max(w.driftMm, outcome.driftMm);
        w.resumedMm = std::max(w.resumedMm, outcome.resumedMm);
        ++w.cells;
    }

    static void report(const QStringList& problems) {
        QVERIFY2(problems.isEmpty(), qPrintable(QString::number(problems.size()) + " cells"));
    }

private Q_SLOTS:
    void everyMotionEndsInTime_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<double>("slider");
        QTest::addColumn<int>("cells");  ///< of a run that is not of all
        QTest::newRow("as by default") << QString() << 1.0 << 24;
        QTest::newRow("slider at 30 %") << QString() << 0.3 << 2;
        constexpr int kFew = 2;
        for (const simulator::AssumptionInfo& info : simulator::assumptionTable()) {
            for (const QString& reading : info.readings.mid(1)) {
                const QString words = info.name + "=" + reading;
                QTest::newRow(qPrintable(words)) << words << 1.0 << kFew;
                // What it is about shows below 100 % only.
                if (reading == QLatin1String("scaled") || reading == QLatin1String("real")) {
                    QTest::newRow(qPrintable(words + ", slider at 50 %")) << words << 0.5 << 1;
                    QTest::newRow(qPrintable(words + ", slider at 10 %")) << words << 0.1 << 1;
                }
            }
        }
    }
    void everyMotionEndsInTime() {
        QFETCH(QString, words);
        QFETCH(double, slider);
        QFETCH(int, cells);
        const std::size_t motions = contractMotions().size();
        const std::size_t events = contractEvents().size();
        QStringList problems;
        if (runsAll) {
            for (std::size_t i = 0; i < motions * events; ++i) {
                check(i % motions, i / motions, words, slider, problems);
            }
        } else {
            // Of two numbers without a common divisor every pair comes round, and so do all motions and
            // events.
            QRandomGenerator random(kSeed + static_cast<quint32>(qHash(words + QString::number(slider), 0)));
            std::size_t at = random.bounded(static_cast<quint32>(motions * events));
            for (int i = 0; i < cells; ++i, ++at) {
                check(at % motions, at % events, words, slider, problems);
            }
        }
        report(problems);
    }

    void randomCombinationsToo() {
        const int combinations = runsAll ? 200 : 3;
        const int cells = runsAll ? 20 : 2;
        QStringList problems;
        for (int i = 0; i < combinations; ++i) {
            QRandomGenerator random(kSeed + static_cast<quint32>(i));
            QStringList words;
            for (const simulator::AssumptionInfo& info : simulator::assumptionTable()) {
                // Half of them as by default.
                const auto readings = static_cast<quint32>(info.readings.size());
                if (random.bounded(2) == 1) {
                    words << info.name + "=" +
                                 info.readings[static_cast<qsizetype>(random.bounded(1U, readings))];
                }
            }
            constexpr double kSliders[] = {1.0, 1.0, 0.5, 0.2};
            const double slider = kSliders[random.bounded(4)];
            for (int c = 0; c < cells; ++c) {
                check(random.bounded(static_cast<quint32>(contractMotions().size())),
                      random.bounded(static_cast<quint32>(contractEvents().size())), words.join(' '), slider,
                      problems);
            }
        }
        report(problems);
    }

    void cleanupTestCase() {
        std::printf("%-24s%-22s%8s%12s%10s%12s\n", "motion", "event", "cells", "stands ms", "way mm",
                    "resumed mm");
        for (const auto& [cell, w] : worst) {
            std::printf("%-24s%-22s%8d%12.0f%10.1f%12.2f\n", contractMotions()[cell.first].name,
                        contractEvents()[cell.second].name, w.cells, w.standstillMs, w.driftMm, w.resumedMm);
        }
        std::fflush(stdout);
    }
};

int main(int argc, char** argv) {
    std::vector<char*> rest;
    for (int i = 0; i < argc; ++i) {
        if (qstrcmp(argv[i], "--all") == 0) {
            runsAll = true;
        } else {
            rest.push_back(argv[i]);
        }
    }
    qputenv("QTEST_FUNCTION_TIMEOUT", "36000000");
    int count = static_cast<int>(rest.size());
    QCoreApplication app(count, rest.data());
    TestStopContract test;
    return QTest::qExec(&test, count, rest.data());
}
#include "tst_stop_contract.moc"
