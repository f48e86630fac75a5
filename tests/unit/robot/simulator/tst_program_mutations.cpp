// SPDX-License-Identifier: MIT
// A program file of the pendant with every known node, damaged in a thousand ways: it is converted to URScript that
// compiles or gives an error with its position, or it is refused with a reason. It never crashes or runs forever.

#include <QTest>
#include <random>

#include "robot/simulator/programs/urp_file.h"
#include "robot/simulator/urscript/program.h"

using namespace tiller;
using namespace tiller::simulator;

namespace {

QByteArray signs(const char* text) {
    QByteArray xml;
    for (; *text != '\0'; ++text) {
        xml += "<ExpressionChar character=\"" + QString(QChar(*text)).toHtmlEscaped().toUtf8() + "\"/>";
    }
    return xml;
}

QByteArray everyNode() {
    const QByteArray line = "<Script type=\"Line\"><expression>" + signs("x = 1") + "</expression></Script>";
    const QByteArray joints =
        "<position><JointAngles angles=\"-1.5, -1.7, -2.2, -0.8, 1.6, 0\"/><TCPOffset pose=\"0,0,0,0,0,0\"/>"
        "</position>";
    return "<?xml version=\"1.0\"?>\n<URProgram name=\"p\" installation=\"default\">\n<children>\n"
           "<InitVariablesNode/>\n<SpecialSequence type=\"BeforeStart\"><children>\n"
           "<Assignment><variable name=\"n\"><initializeExpression>" +
           signs("0") + "</initializeExpression></variable><expression>" + signs("n+1") +
           "</expression></Assignment>\n</children></SpecialSequence>\n"
           "<MainProgram runOnlyOnce=\"false\"><children>\n" +
           line + "<SuppressedNode>" + line +
           "</SuppressedNode>\n<If type=\"If\"><expression><ExpressionToken token=\" not "
           "\"/><ExpressionIO><pin "
           "referencedName=\"digital_in[3]\"/></ExpressionIO></expression><children>" +
           line + "</children></If>\n<If type=\"ElseIf\"><expression><ExpressionVariable><ProgramVariable " +
           "reference=\"../../../../../../SpecialSequence/children/Assignment/variable\"/></"
           "ExpressionVariable>" +
           signs("<2") + "</expression><children>" + line + "</children></If><If type=\"Else\"><children>" +
           line + "</children></If>\n<Loop type=\"Counting\" count=\"3\"><children>" + line +
           "</children></Loop><Loop type=\"While\"><expression>" + signs("False") +
           "</expression></Loop>\n<Popup message=\"m\" haltProgram=\"false\"/><Comment comment=\"c\"/>"
           "<Folder name=\"f\"><children>" +
           line +
           "</children></Folder><Wait type=\"Sleep\"><waitTime>0.1</waitTime></Wait><Timer action=\"Start\">"
           "<variable name=\"t\"/></Timer>\n<Move motionType=\"MoveJ\" speed=\"1\" "
           "acceleration=\"2\"><children>"
           "<Waypoint type=\"Fixed\"><motionParameters jointSpeed=\"1\" blendRadius=\"0.01\"/>" +
           joints +
           "</Waypoint><Waypoint type=\"Variable\"><variable name=\"n\"/></Waypoint></children></Move>"
           "<SafeHome/>\n<CallSubProgram><subprogram reference=\"../../../../SubProgram\"/></CallSubProgram>"
           "<CallSubProgram><subprogram name=\"other\"><file>other.urp</file></subprogram></CallSubProgram>"
           "<Script type=\"File\"><file>a.script</file></Script><Script type=\"File\"><cachedContents>y = 2\n"
           "</cachedContents></Script><Halt/>\n</children></MainProgram>\n<SubProgram name=\"s\"><children>" +
           line + "</children></SubProgram>\n<Thread name=\"t\" runOnlyOnce=\"true\"><children>" + line +
           "</children></Thread>\n</children></URProgram>\n";
}

class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    QByteArray mutated(QByteArray content) {
        for (int changes = 1 + below(4); changes > 0 && !content.isEmpty(); --changes) {
            change(content);
        }
        return content;
    }

private:
    int below(qsizetype end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

    /// Start and length of one element, such as a tag or an attribute value, so that many results are still XML.
    std::pair<int, int> piece(const QByteArray& content, char open, char close) {
        const qsizetype begin = content.indexOf(open, below(content.size()));
        const qsizetype end = begin < 0 ? -1 : content.indexOf(close, begin + 1);
        return end < 0 ? std::pair(0, 0)
                       : std::pair(static_cast<int>(begin), static_cast<int>(end - begin + 1));
    }

    void change(QByteArray& content) {
        switch (below(8)) {
            case 0:
                content[below(content.size())] = static_cast<char>(random_());
                break;
            case 1:
                content.remove(below(content.size()), 1 + below(40));
                break;
            case 2:
                content.truncate(below(content.size()));
                break;
            case 3: {  // replaces the value by that of another attribute
                const auto [to, length] = piece(content, '"', '"');
                const auto [from, other] = piece(content, '"', '"');
                content.replace(to, length, content.mid(from, other));
                break;
            }
            case 4: {  // repeats a tag elsewhere
                const auto [from, length] = piece(content, '<', '>');
                content.insert(below(content.size()), content.mid(from, length));
                break;
            }
            case 5: {  // removes a tag
                const auto [from, length] = piece(content, '<', '>');
                content.remove(from, length);
                break;
            }
            case 6: {  // changes a path
                static const char* const kPaths[] = {"\"..\"",
                                                     "\"../..\"",
                                                     "\"../../..\"",
                                                     "\"/\"",
                                                     "\"../../children\"",
                                                     "\"MainProgram[99999999999]\"",
                                                     "\"[\"",
                                                     "\"nan\"",
                                                     "\"-1\"",
                                                     "\"1e999\""};
                const auto [to, length] = piece(content, '"', '"');
                content.replace(to, length, kPaths[below(std::size(kPaths))]);
                break;
            }
            default: {  // repeats a section
                const QByteArray stretch = content.mid(below(content.size()), 1 + below(300));
                content.insert(below(content.size()), stretch);
                break;
            }
        }
    }

    std::mt19937 random_;
};

}  // namespace

class TestProgramMutations : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theProgramIsGoodBeforeItIsDamaged() {
        const QByteArray whole = everyNode();
        const auto script = scriptOfUrp(whole, "p", reader(whole));
        QVERIFY2(script.ok(), qPrintable(script.error().context));
        const urscript::CompileOutcome outcome = urscript::compile(*script);
        QVERIFY2(bool(outcome), outcome.error.text.c_str());
    }

    void aThousandDamagedProgramsAreRefusedOrCompiled() {
        const QByteArray whole = everyNode();
        int told = 0, refused = 0;
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            const QByteArray content = Mutator(seed).mutated(whole);
            const auto script = scriptOfUrp(content, "p", reader(content));
            if (!script) {
                ++refused;
                QVERIFY2(!script.error().context.isEmpty(), qPrintable(QString::number(seed)));
                continue;
            }
            ++told;
            const urscript::CompileOutcome outcome = urscript::compile(*script);
            QVERIFY2(outcome || !outcome.error.text.empty(), qPrintable(QString::number(seed)));
        }
        // Otherwise all of them would have ended at the first line.
        QVERIFY2(told > 50 && refused > 50, qPrintable(QStringLiteral("%1 %2").arg(told).arg(refused)));
    }

    void aThousandDamagedArchivesAreRefusedOrRead() {
        // Compressed as on the pendant: qCompress() gives the same deflated bytes with a different header, and
        // damage is detected by the checksum at the end.
        const QByteArray zlib = qCompress(everyNode());
        const QByteArray gzip = QByteArray("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10) +
                                zlib.mid(6, zlib.size() - 10) + QByteArray(8, '\0');
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            const QByteArray content = Mutator(seed).mutated(gzip);
            const auto script = scriptOfUrp(content, "p", reader(content));
            QVERIFY(script.ok() || !script.error().context.isEmpty());
        }
    }

private:
    /// Every file that the program refers to is the program itself, so that it can call itself endlessly.
    static FileReader reader(const QByteArray& content) {
        return [content](const QString& name) {
            return name.endsWith(".urp") ? std::optional(content) : std::optional(QByteArray("z = 3\n"));
        };
    }
};

QTEST_GUILESS_MAIN(TestProgramMutations)
#include "tst_program_mutations.moc"
