// SPDX-License-Identifier: MIT
//
// The comparison of the ur_rtde paper (section IV), run again over real sockets against the simulated
// controller on this machine, and the figures we hold the backend to: one table with pass or FAIL, or one
// JSON object with --json. Exits with 1 when a figure is missed. What is judged are the cycles and round
// trips during which the processors were there (machine_watch.h); those of all are in the table beside. Which
// loop is the more even one is judged by the quieter half of all half seconds, in turns, without the watch.
// Load ("stress") is made here: busy threads, one for each core and one more.
//
//   sudo build/release/bin/benchmarks/backend_performance            everything, about twelve minutes
//   build/release/bin/benchmarks/backend_performance --seconds 3 --round-trips 100      a quick look
//
// Real-time priority takes root, or a line in limits.d; without it the rows that need it fail.

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
         {"only", "Only one part: loops, costs, patience or face.", "part"},
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
    // This first: once memory is locked and priorities are given, all that follows would have them too.
    if (isWanted("costs")) {
        measureCosts(report);
    }
    if (isWanted("patience")) {
        measurePatience(report);
    }
    if (isWanted("face")) {
        measureFace(report, wishes);
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
