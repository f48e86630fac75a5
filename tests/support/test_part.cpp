// SPDX-License-Identifier: MIT
// Runs a part of a Qt Test program, so that ctest can run the parts in parallel:
//     tiller_test_part <part> <parts> <program> [arguments]
// A part consists of every <parts>-th test function and data row, starting with number <part> (1, 2, ...).
// All parts together run the complete program.

#include <QCoreApplication>
#include <QProcess>
#include <cstdio>

namespace {

/// Returns the tests of the program in the form of its command line: "function" or "function:row".
QStringList testsOf(const QString& program) {
    QProcess lister;
    lister.start(program, {QStringLiteral("-datatags")});
    if (!lister.waitForFinished(-1) || lister.exitCode() != 0) {
        return {};
    }
    QStringList tests;
    const QStringList lines =
        QString::fromUtf8(lister.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
    for (const QString& line : lines) {
        const QString function = line.section(' ', 1, 1);
        const QString row = line.section(' ', 2);
        tests.append(row.isEmpty() ? function : function + ':' + row);
    }
    return tests;
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QStringList arguments = QCoreApplication::arguments().mid(1);
    if (arguments.size() < 3) {
        std::fprintf(stderr, "usage: tiller_test_part <part> <parts> <program> [arguments]\n");
        return 2;
    }
    const int part = arguments.takeFirst().toInt();
    const int parts = arguments.takeFirst().toInt();
    const QString program = arguments.takeFirst();
    const QStringList tests = testsOf(program);
    if (part < 1 || part > parts || tests.size() < parts) {
        std::fprintf(stderr, "%s has %d tests: there is no part %d of %d\n", qPrintable(program),
                     int(tests.size()), part, parts);
        return 2;
    }
    for (int i = part - 1; i < tests.size(); i += parts) {
        arguments.append(tests[i]);
    }
    QProcess runner;
    runner.setProcessChannelMode(QProcess::ForwardedChannels);
    runner.start(program, arguments);
    runner.waitForFinished(-1);
    return runner.exitStatus() == QProcess::NormalExit ? runner.exitCode() : 128;
}
