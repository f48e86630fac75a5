// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests all pairs of values of key, layout, modifier and order. The complete matrix takes half an hour and is
// a separate run:
//   tst_key_matrix --all [--layout NAME] [--key NAME] [--file FILE]
// It prints one line per cell and a table at the end. With a file, cells that the file already contains are
// skipped, so that an interrupted run can be continued.

#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFile>
#include <QTextStream>

#include "tests/desktop/desktop_test.h"
#include "tests/desktop/key_matrix.h"

namespace tiller::test {
namespace {

/// Number of further runs of a cell. A busy machine may be late once, but not twice, and may refuse some
/// presses, so that there is no result. An arm that keeps moving fails immediately.
int furtherRuns(const CellOutcome& outcome) {
    switch (outcome.kind) {
        case CellOutcome::Kind::Late:
            return 1;
        case CellOutcome::Kind::Broken:
        case CellOutcome::Kind::DidNotMove:
            return 4;
        default:
            return 0;
    }
}

bool isFailure(const CellOutcome& outcome) {
    return outcome.kind == CellOutcome::Kind::GoesOn || furtherRuns(outcome) > 0;
}

QString line(const MatrixCell& cell, const CellOutcome& outcome) {
    return QStringLiteral("%1\t%2\t%3\t%4")
        .arg(nameOf(cell), nameOf(outcome.kind))
        .arg(outcome.seconds * 1e3, 0, 'f', 0)
        .arg(outcome.note);
}

/// Results of a run, counted by modifier and order, by layout, and by key.
class Tally {
public:
    void add(const MatrixCell& cell, const QString& kind, double ms) {
        const bool plain = cell.modifier == Modifier::None;
        const QString order = plain ? QString() : nameOf(cell.order);
        for (const auto& [table, row] :
             {std::pair<std::size_t, QString>{
                  0, QStringLiteral("%1 %2").arg(nameOf(cell.modifier), -8).arg(order, -6)},
              {1, layouts()[cell.layout]},
              {2, heldKeys()[cell.key].name}}) {
            if (QStringList& names = order_[table]; !names.contains(row)) {
                names.append(row);
            }
            Row& found = rows_[table][row];
            ++found.cells;
            ++found.kinds[kind];
            found.worstMs = std::max(found.worstMs, ms);
        }
    }
    QString text() const {
        static constexpr CellOutcome::Kind kKinds[] = {
            CellOutcome::Kind::Stood,      CellOutcome::Kind::Late,      CellOutcome::Kind::GoesOn,
            CellOutcome::Kind::DidNotMove, CellOutcome::Kind::OtherKeys, CellOutcome::Kind::NoSuchKeys,
            CellOutcome::Kind::Broken};
        QString text;
        for (std::size_t table = 0; table < rows_.size(); ++table) {
            text += QStringLiteral("%1%2").arg(QString(), -20).arg("cells", 7);
            for (const CellOutcome::Kind kind : kKinds) {
                text += nameOf(kind).rightJustified(14);
            }
            text += "  worst [ms]\n";
            for (const QString& name : order_[table]) {
                const Row& row = rows_[table][name];
                text += QStringLiteral("%1%2").arg(name, -20).arg(row.cells, 7);
                for (const CellOutcome::Kind kind : kKinds) {
                    text += QString::number(row.kinds.value(nameOf(kind))).rightJustified(14);
                }
                text += QString::number(row.worstMs, 'f', 0).rightJustified(12) + '\n';
            }
            text += '\n';
        }
        return text;
    }

private:
    struct Row {
        int cells = 0;
        QMap<QString, int> kinds;
        double worstMs = 0;
    };
    std::array<QMap<QString, Row>, 3> rows_;
    std::array<QStringList, 3> order_;
};

int runAll(const QString& layout, const QString& key, const QString& path) {
    QTextStream out(stdout);
    QMap<QString, QStringList> known;
    QFile file(path);
    if (!path.isEmpty()) {
        if (!file.open(QIODevice::ReadWrite | QIODevice::Text)) {
            out << path << " cannot be written\n";
            return 2;
        }
        while (!file.atEnd()) {
            const QStringList columns = QString::fromUtf8(file.readLine()).chopped(1).split('\t');
            if (columns.size() >= 3) {
                known[columns[0]] = columns;
            }
        }
    }
    KeyMatrixRun trial;
    Tally tally;
    int failures = 0;
    for (const MatrixCell& cell : wholeMatrix()) {
        const QString name = nameOf(cell);
        if ((!layout.isEmpty() && layouts()[cell.layout] != layout) ||
            (!key.isEmpty() && heldKeys()[cell.key].name != key)) {
            continue;
        }
        if (!known.contains(name)) {
            CellOutcome outcome = trial.run(cell);
            for (int again = 0; again < furtherRuns(outcome); ++again) {
                out << line(cell, outcome) << "\tonce more" << Qt::endl;
                outcome = trial.run(cell);
            }
            const QString reported = line(cell, outcome);
            out << reported << Qt::endl;
            known[name] = reported.split('\t');
            if (file.isOpen()) {
                file.write(reported.toUtf8() + '\n');
                file.flush();
            }
            failures += isFailure(outcome) ? 1 : 0;
        }
        tally.add(cell, known[name][1], known[name][2].toDouble());
    }
    out << '\n' << tally.text() << failures << " cells failed in this run\n";
    return failures == 0 ? 0 : 1;
}

}  // namespace

class TestKeyMatrix : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void releaseStopsTheArmWhateverElseIsPressed() {
        const QList<MatrixCell> cells = everyPair();
        KeyMatrixRun trial;
        Tally tally;
        QStringList failures;
        QElapsedTimer time;
        time.start();
        for (const MatrixCell& cell : cells) {
            CellOutcome outcome = trial.run(cell);
            for (int again = 0; again < furtherRuns(outcome); ++again) {
                qInfo("%s, repeated", qPrintable(line(cell, outcome)));
                outcome = trial.run(cell);
            }
            if (isFailure(outcome)) {
                qInfo("%s", qPrintable(line(cell, outcome)));
                failures.append(line(cell, outcome));
            }
            tally.add(cell, nameOf(outcome.kind), outcome.seconds * 1e3);
        }
        qInfo("%d cells in %.0f s\n%s", int(cells.size()), double(time.elapsed()) / 1e3,
              qPrintable(tally.text()));
        QVERIFY2(failures.isEmpty(), qPrintable(failures.join('\n')));
    }
};

}  // namespace tiller::test

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    using namespace tiller::test;
    if (const QString obstacle = DesktopCell::obstacle(); !obstacle.isEmpty()) {
        std::printf("Skipped: %s\n", qPrintable(obstacle));
        return kSkipped;
    }
    if (QCoreApplication::arguments().contains("--all")) {
        QCommandLineParser parser;
        parser.addOption({"all", "Every cell."});
        parser.addOption({"layout", "Run only cells of this layout.", "name"});
        parser.addOption({"key", "Run only cells of this key.", "name"});
        parser.addOption({"file", "File for the results; cells it already contains are skipped.", "file"});
        parser.process(application);
        return runAll(parser.value("layout"), parser.value("key"), parser.value("file"));
    }
    TestKeyMatrix test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_key_matrix.moc"
