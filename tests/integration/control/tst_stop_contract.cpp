// SPDX-License-Identifier: MIT
//
// The stop contract of the native library. For all motions, and for all events concerning the client, the
// connection or the robot, the arm stops in time and no motion resumes. Also tested with alternative
// behaviour of the controller.
//
// Runs a part of the table, which is selected pseudo-randomly but reproducibly for each behaviour option.
// With --all, runs everything and 200 random combinations of options. The rows can be divided among several
// processes, with rows named as by Qt Test:
//
//     tst_stop_contract --all
//     tst_stop_contract --all everyMotionEndsInTime:data=late everyMotionEndsInTime:data=doubled
//     tst_stop_contract --all --combinations 100 200 randomCombinationsEndInTime
//
// One case, as named in a failure:
//
//     tst_stop_contract --cell "jog a joint" safeguard 0.5 "data=late stops=scaled"

#include <QElapsedTimer>
#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

#include "tests/integration/control/contract_cell.h"

using namespace tiller;
using namespace tiller::test;

namespace {

bool runsAll = false;
int firstCombination = 0;
int endCombination = 200;
QStringList onlyCell;                 ///< motion, event, slider, options
constexpr double kLostLimitMs = 250;  ///< for all events except a release [ms]
constexpr quint32 kSeed = 20261123;

simulator::BehaviourOptions assumed(const QString& words) {
    simulator::BehaviourOptions assumptions;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (const auto taken = simulator::assume(assumptions, word); !taken) {
            qFatal("%s", qPrintable(taken.error().context));
        }
    }
    return assumptions;
}

/// The worst results of a set of cases.
struct Worst {
    double standstillMs = 0;
    double driftMm = 0;
    double resumedMm = 0;
    int cells = 0;

    void add(const ContractOutcome& outcome) {
        standstillMs = std::max(standstillMs, outcome.standstillMs);
        driftMm = std::max(driftMm, outcome.driftMm);
        resumedMm = std::max(resumedMm, outcome.resumedMm);
        ++cells;
    }
    void print(const char* what, const char* andWhat) const {
        std::printf("%-44s%-26s%6d%12.0f%10.1f%12.2f\n", what, andWhat, cells, standstillMs, driftMm,
                    resumedMm);
    }
};
std::map<std::pair<std::string, std::string>, Worst> worst;  ///< worst results by motion and event
Worst released;                                              ///< worst results of this row for a release
Worst others;  ///< worst results of this row for all other events

template <class Named>
const Named& named(const std::vector<Named>& all, const char* name) {
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const Named& n) { return qstrcmp(n.name, name) == 0; });
    if (it == all.end()) {
        qFatal("%s", name);
    }
    return *it;
}

}  // namespace

Q_DECLARE_METATYPE(tiller::SoftwareVersion)

class TestStopContract : public QObject {
    Q_OBJECT

    /// given  software version; empty: a version that has this motion
    static void check(const ContractMotion& motion, const ContractEvent& event, const QString& words,
                      double slider, QStringList& problems,
                      const std::optional<SoftwareVersion>& given = std::nullopt) {
        const SoftwareVersion software =
            given.value_or(std::max(simulator::SimulatorOptions().software, motion.since));
        // If forces may continue in a pause and the process is killed in the meantime, nothing can end them,
        // because the program is paused and the PC is not available.
        if (motion.yields && event.losesBoth && words.contains(QLatin1String("pause=frees"))) {
            return;
        }
        const ContractOutcome outcome = ContractCell(assumed(words), slider, software).run(motion, event);
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
        worst[{motion.name, event.name}].add(outcome);
        (event.limitMs < kLostLimitMs ? released : others).add(outcome);
    }
    static void check(std::size_t m, std::size_t e, const QString& words, double slider,
                      QStringList& problems) {
        check(contractMotions()[m], contractEvents()[e], words, slider, problems);
    }

    static void report(const QStringList& problems) {
        if (runsAll) {
            released.print(QTest::currentDataTag() ? QTest::currentDataTag() : "combinations", "release");
            others.print("", "all others");
            std::fflush(stdout);
        }
        released = others = {};
        QVERIFY2(problems.isEmpty(), qPrintable(QString::number(problems.size()) + " cells"));
    }

private Q_SLOTS:
    void everyMotionEndsInTime_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<double>("slider");
        QTest::addColumn<int>("cells");  ///< number of cases in a partial run
        QTest::newRow("as by default") << QString() << 1.0 << 24;
        QTest::newRow("slider at 30 %") << QString() << 0.3 << 2;
        constexpr int kFew = 2;
        for (const simulator::BehaviourOptionInfo& info : simulator::assumptionTable()) {
            for (const QString& reading : info.readings.mid(1)) {
                const QString words = info.name + "=" + reading;
                QTest::newRow(qPrintable(words)) << words << 1.0 << kFew;
                // These options are relevant only below 100 %.
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
            // The motion and event of each case differ from those of the previous case. Eventually all pairs
            // are covered.
            QRandomGenerator random(kSeed + static_cast<quint32>(qHash(words + QString::number(slider), 0)));
            std::size_t at = random.bounded(static_cast<quint32>(motions * events));
            for (int i = 0; i < cells; ++i, ++at) {
                const std::size_t motion = at % motions;
                check(motion, (at / motions + motion) % events, words, slider, problems);
            }
        }
        report(problems);
    }

    void randomCombinationsEndInTime() {
        const int end = runsAll ? endCombination : 3;
        const int cells = runsAll ? 20 : 2;
        QStringList problems;
        for (int i = firstCombination; i < end; ++i) {
            QRandomGenerator random(kSeed + static_cast<quint32>(i));
            QStringList words;
            for (const simulator::BehaviourOptionInfo& info : simulator::assumptionTable()) {
                // Half of the options have their default value.
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

    // Past failures with their options: the arm moved afterwards, or the stop took too long.
    void earlierRegressionsStayFixed_data() {
        QTest::addColumn<QString>("motion");
        QTest::addColumn<QString>("event");
        QTest::addColumn<double>("slider");
        QTest::addColumn<QString>("words");
        if (!onlyCell.isEmpty()) {
            QTest::newRow("one cell") << onlyCell[0] << onlyCell[1] << onlyCell[2].toDouble() << onlyCell[3];
            return;
        }
        // During a pause, real time and program time advance differently. Regression test: when the program
        // ended, it measured its speed in one of them and decelerated in the other.
        QTest::newRow("braked in another time")
            << "jog a joint"
            << "safeguard" << 0.5 << "program-stops=scaled speed-commands=real outputs=next-period data=late";
        // Regression test: the stop used the speed from before the pause, and the deceleration for this
        // speed.
        QTest::newRow("stopped behind a pause")
            << "jog a joint"
            << "pause, kill -9, play" << 1.0 << "stops=scaled thread-start=next-period";
        QTest::newRow("servo stopped behind a pause")
            << "servoJ"
            << "pause, kill -9, play" << 1.0 << "stops=scaled speed-commands=real thread-start=next-period";
        QTest::newRow("servo stopped behind a pause, slider at 50 %")
            << "servoL"
            << "pause, kill -9, play" << 0.5 << "stops=scaled thread-start=next-period";
        QTest::newRow("bunched data") << "jog in force mode"
                                      << "release" << 1.0 << "data=bunched";
    }
    void earlierRegressionsStayFixed() {
        QFETCH(QString, motion);
        QFETCH(QString, event);
        QFETCH(double, slider);
        QFETCH(QString, words);
        QStringList problems;
        check(named(contractMotions(), qPrintable(motion)), named(contractEvents(), qPrintable(event)), words,
              slider, problems);
        report(problems);
    }

    void aRobotSwitchedToLocalStops_data() {
        QTest::addColumn<QString>("words");
        QTest::newRow("its program goes on") << QString();
        QTest::newRow("its program ends") << "remote-to-local=ends";
    }
    void aRobotSwitchedToLocalStops() {
        QFETCH(QString, words);
        QStringList problems;
        if (runsAll) {
            for (const ContractMotion& motion : contractMotions()) {
                check(motion, lostInLocal(), words, 1, problems);
            }
        } else {
            check(contractMotions().front(), lostInLocal(), words, 1, problems);
        }
        report(problems);
    }

    // Before 5.17, a program has no clock that would reveal a pause.
    void aShortPauseIsDetectedWithoutAClock_data() {
        QTest::addColumn<SoftwareVersion>("software");
        QTest::newRow("5.16") << SoftwareVersion{5, 16, 0, 0};
        QTest::newRow("5.3") << SoftwareVersion{5, 3, 0, 0};
        QTest::newRow("CB3 3.15") << SoftwareVersion{3, 15, 8, 106339};
    }
    void aShortPauseIsDetectedWithoutAClock() {
        QFETCH(SoftwareVersion, software);
        QStringList problems;
        if (runsAll) {
            for (const ContractMotion& motion : contractMotions()) {
                // The control program does not contain functions that run in a section.
                if (software.isCb3() && qstrcmp(motion.name, "function in force mode") == 0) {
                    continue;
                }
                for (const ContractEvent& pause : shortPauses()) {
                    check(motion, pause, {}, 1, problems, software);
                }
            }
        } else {
            for (const char* motion : {"jog", "force mode"}) {
                check(named(contractMotions(), motion), shortPauses()[1], {}, 1, problems, software);
            }
        }
        report(problems);
    }

    void cleanupTestCase() {
        std::printf("%-44s%-26s%6s%12s%10s%12s\n", "motion", "event", "cells", "stands ms", "way mm",
                    "resumed mm");
        for (const auto& [cell, w] : worst) {
            w.print(cell.first.c_str(), cell.second.c_str());
        }
        std::fflush(stdout);
    }
};

int main(int argc, char** argv) {
    std::vector<char*> rest;
    char oneCell[] = "earlierRegressionsStayFixed";
    for (int i = 0; i < argc; ++i) {
        if (qstrcmp(argv[i], "--all") == 0) {
            runsAll = true;
        } else if (qstrcmp(argv[i], "--combinations") == 0 && i + 2 < argc) {
            firstCombination = QByteArray(argv[++i]).toInt();
            endCombination = QByteArray(argv[++i]).toInt();
        } else if (qstrcmp(argv[i], "--cell") == 0 && i + 4 < argc) {
            for (int n = 0; n < 4; ++n) {
                onlyCell << QString::fromLocal8Bit(argv[++i]);
            }
            rest.push_back(oneCell);
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
