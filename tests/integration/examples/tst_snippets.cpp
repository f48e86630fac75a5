// SPDX-License-Identifier: MIT
// Tests for the code in the READMEs. Each code block is contained literally in one of the examples.
// integration/package/readme builds the CMake blocks.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace {

struct Block {
    QString page;
    QString language;
    QStringList lines;
};

QStringList linesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).split('\n') : QStringList();
}

QList<Block> blocksOf(const QString& page) {
    QList<Block> blocks;
    bool inside = false;
    for (const QString& line : linesOf(QStringLiteral(TILLER_SOURCE_DIR "/") + page)) {
        if (line.startsWith("```")) {
            inside = !inside;
            if (inside) {
                blocks.append({page, line.mid(3), {}});
            }
        } else if (inside) {
            blocks.last().lines << line;
        }
    }
    return blocks;
}

QString indentOf(const QString& line) {
    static const QRegularExpression kSpaces(QStringLiteral("^ *"));
    return kSpaces.match(line).captured();
}

/// True if the text contains all lines of the block in order. The text may have a constant additional
/// indentation.
bool standsIn(const QStringList& block, const QStringList& text) {
    for (qsizetype at = 0; at + block.size() <= text.size(); ++at) {
        const QString indent =
            indentOf(text[at]).chopped(std::min(indentOf(block.first()).size(), indentOf(text[at]).size()));
        bool same = true;
        for (qsizetype i = 0; i < block.size() && same; ++i) {
            same = text[at + i] == (block[i].isEmpty() ? QString() : indent + block[i]);
        }
        if (same) {
            return true;
        }
    }
    return false;
}

/// The source files with code in this language.
QStringList sourcesOf(const QString& language) {
    QStringList files;
    QDirIterator it(QStringLiteral(TILLER_SOURCE_DIR "/robot/examples/") + language,
                    {language == "cpp" ? "*.cpp" : "*.py"}, QDir::Files);
    while (it.hasNext()) {
        files << it.next();
    }
    return files;
}

}  // namespace

class TestSnippets : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void searchFindsExactlyTheRunningRobots() {
        const QStringList text{"a {", "    b;", "", "    c;", "}"};
        QVERIFY(standsIn({"b;", "", "c;"}, text));
        QVERIFY(standsIn({"a {", "    b;"}, text));
        QVERIFY(!standsIn({"b;", "c;"}, text));
        QVERIFY(!standsIn({"b;", "", "    c;"}, text));
    }

    void readmeCodeIsContainedInTheExamples_data() {
        QTest::addColumn<QString>("page");
        QTest::addColumn<int>("least");
        QTest::newRow("README.md") << "README.md" << 3;
        QTest::newRow("robot/README.md") << "robot/README.md" << 3;
    }
    void readmeCodeIsContainedInTheExamples() {
        QFETCH(QString, page);
        QFETCH(int, least);
        int code = 0;
        for (const Block& block : blocksOf(page)) {
            if (block.language == "sh" || block.language == "cmake") {
                continue;
            }
            ++code;
            const QStringList sources = sourcesOf(block.language);
            QVERIFY2(!sources.isEmpty(), qPrintable("no examples in " + block.language));
            bool found = false;
            for (const QString& source : sources) {
                found = found || standsIn(block.lines, linesOf(source));
            }
            QVERIFY2(found, qPrintable(page + ": in no example:\n" + block.lines.join('\n')));
        }
        QVERIFY2(code >= least, qPrintable(QString::number(code)));
    }
};

QTEST_GUILESS_MAIN(TestSnippets)
#include "tst_snippets.moc"
