// SPDX-License-Identifier: MIT
//
// Repeats the comparison in section IV of the ur_rtde publication with real sockets and the simulated
// controller on this computer, and checks the limits of the backend. Prints one table with pass or FAIL, or
// one JSON object with --json. Exits with 1 if a limit is exceeded. The limits apply to cycles and round
// trips during which the CPUs were available (machine_watch.h). The table also contains the values of all
// cycles and round trips. The regularity of the loops is compared without the watch. The loops alternate, and
// only the quieter half of all half-second periods is compared. This program generates the load ("stress"):
// busy threads, one per core plus one.
//
//   sudo build/release/bin/benchmarks/backend_performance            everything, about twelve minutes
//   build/release/bin/benchmarks/backend_performance --seconds 3 --round-trips 100      a quick run
//
// Real-time priority requires root, or an entry in limits.d. Without it, rows that need it fail.

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTextStream>

#include "tests/benchmarks/backend/report.h"

using namespace tiller::benchmark;

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions(
        {{"seconds", "How long the longer of the two circles takes (30 000 cycles: 60).", "s", "60"},
         {"round-trips", "How often the slider is set.", "n", "1000"},
         {"only", "Only one part: loops, costs, timeouts or ur_rtde.", "part"},
         {"decode-only", "Decodes so often and ends: for callgrind.", "n"},
         {"json", "One JSON object instead of a table."}});
    parser.process(application);
    if (parser.isSet("decode-only")) {
        return decodeOnly(parser.value("decode-only").toInt()) ? 0 : 1;
    }
    Wishes wishes;
    wishes.seconds = parser.value("seconds").toDouble();
    wishes.roundTrips = parser.value("round-trips").toInt();
    const auto isWanted = [&](const char* part) {
        return !parser.isSet("only") || parser.value("only") == QLatin1String(part);
    };
    Report report;
    // Measure this first, because locked memory and priorities would affect it later.
    if (isWanted("costs")) {
        measureCosts(report);
    }
    if (isWanted("timeouts")) {
        measureTimeout(report);
    }
    if (isWanted("ur_rtde")) {
        measureUrRtde(report, wishes);
    }
    if (isWanted("loops")) {
        measureLoops(report, wishes);
    }
    QTextStream out(stdout);
    if (parser.isSet("json")) {
        out << report.json() << '\n';
    } else {
        out << report.table() << '\n' << (report.passed() ? "all passed" : "NOT all passed") << '\n';
    }
    return report.passed() ? 0 : 1;
}
