// SPDX-License-Identifier: MIT
// A program file of the teach pendant with every known node, damaged in a thousand ways. Either it is
// converted to URScript that compiles or fails with the position of the error, or it is refused with a
// reason. The converter never crashes or runs endlessly.

#include <QTest>
#include <random>

#include "robot/simulator/pendant/pendant_program.h"
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

QByteArray anInstallation() {
    return "<Installation><IOs><DigitalInputNames value=\", part, , , , , , \"/><ModbusUnits><Unit "
           "ipAddress=\"127.0.0.1\"><ModbusSignal name=\"plc\" type=\"REGISTER_OUTPUT\" slaveAddress=\"1\" "
           "signalAddress=\"2\"/></Unit></ModbusUnits></IOs><TCPSettings "
           "activePose=\"tip\"><availablePoses><tcp "
           "name=\"tip\" offset=\"0,0,0.1,0,0,0\"/></availablePoses></TCPSettings><PayloadSettings><Payload "
           "name=\"box\" mass=\"1\" defaultPayload=\"true\" centerOfGravity=\"0,0,0.1\" "
           "inertiaParameters=\"0,0,0,0,0,0\"/></PayloadSettings><Features><GeomPoseNode><GeomPoseNode "
           "isVariable=\"true\" name=\"Stack\"><toolPosition value=\"0.3,0.2,0.1\"/><toolAxisAngle "
           "value=\"0,0,0\"/></GeomPoseNode></GeomPoseNode></Features><SafeHomeSettings enabled=\"true\" "
           "position=\"0,-1.5,0,-1.5,0,0\"/></Installation>";
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
           "<SafeHome/>\n"
           "<Set type=\"DigitalOutput\"><pin "
           "referencedName=\"digital_out[1]\"/><digitalValue>1</digitalValue></Set>"
           "<Set type=\"NoAction\" payload=\"1\" tcpAsCog=\"true\"><tcp referencedName=\"tip\"/></Set>"
           "<Set type=\"ExpressionOutput\"><pin referencedName=\"plc\"/><expression>" +
           signs("3") +
           "</expression></Set><SetPayload workpieceName=\"box\"/>"
           "<Wait type=\"DigitalInput\"><pin referencedName=\"part\"/><digitalValue>1</digitalValue></Wait>"
           "<Wait type=\"Condition\"><expression>" +
           signs("n<3") + "</expression></Wait>\n<Switch><expression>" + signs("n") +
           "</expression><children><Case caseValue=\"1\"><children>" + line +
           "</children></Case><Default><children>" + line + "</children></Default></children></Switch>" +
           "<If type=\"If\" checkContinuously=\"true\"><expression>" + signs("n<1") +
           "</expression><children>" + line + "</children></If><If type=\"Else\"><children>" + line +
           "</children></If><Loop type=\"While\" checkContinuously=\"true\"><expression>" + signs("n<1") +
           "</expression><children>" + line +
           "</children></Loop>\n<Force type=\"Frame\"><feature referencedName=\"Joint_6_name\"/><selection "
           "value=\"0,0,1,0,0,0\"/><wrench value=\"0,0,-2,0,0,0\"/><limitsForce "
           "value=\"1,1,1,1,1,1\"/><limitsMotion "
           "value=\"1,1,1,1,1,1\"/><children>" +
           line +
           "</children></Force>\n<Move motionType=\"MoveL\" speed=\"1\" acceleration=\"2\" "
           "useActiveTCP=\"false\"><tcp referencedName=\"tip\"/><feature referencedName=\"Stack\"/><children>"
           "<Waypoint type=\"Relative\" name=\"r\"><relativeFromPosition><JointAngles "
           "angles=\"0,-1,1,0,1,0\"/>"
           "</relativeFromPosition>" +
           joints +
           "</Waypoint><CircleMove OrientationMode=\"FIXED\"><children><Waypoint type=\"Fixed\" name=\"a\">" +
           joints + "</Waypoint><Waypoint type=\"Fixed\" name=\"b\">" + joints +
           "</Waypoint></children></CircleMove><gui.program.direction.MoveDirectionNode "
           "selectedDirection=\"ZPlus\"><children><Until "
           "type=\"DISTANCE\"><Distance>0.05</Distance></Until><Until "
           "type=\"TOOL_CONTACT_DETECTION\" allowActions=\"true\" retraction=\"0.01\"><children>" +
           line +
           "</children></Until></children></gui.program.direction.MoveDirectionNode></children></Move>"
           "<Contributed strategyClass=\"com.robotiq.urcap.gripper.GripperNode\"><dataModel><data "
           "key=\"position\" "
           "value=\"50\"/></dataModel></Contributed>\n<CallSubProgram><subprogram "
           "reference=\"../../../../SubProgram\"/></CallSubProgram>"
           "<CallSubProgram><subprogram name=\"other\"><file>other.urp</file></subprogram></CallSubProgram>"
           "<Script type=\"File\"><file>a.script</file></Script><Script type=\"File\"><cachedContents>y = 2\n"
           "</cachedContents></Script><Halt/>\n</children></MainProgram>\n<SubProgram name=\"s\"><children>" +
           line + "</children></SubProgram>\n<Event><expression>" + signs("n<0") + "</expression><children>" +
           line + "</children></Event><Thread name=\"t\" runOnlyOnce=\"true\"><children>" + line +
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

    /// Start and length of one element, e.g. a tag or an attribute value, so that many results are still
    /// valid XML.
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
            case 3: {  // replaces the value with that of another attribute
                const auto [to, length] = piece(content, '"', '"');
                const auto [from, other] = piece(content, '"', '"');
                content.replace(to, length, content.mid(from, other));
                break;
            }
            case 4: {  // repeats a tag at another position
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
    void theUndamagedProgramIsValid() {
        const QByteArray whole = everyNode();
        const auto program = pendant::readUrp(whole, "p", source(whole));
        QVERIFY2(program.ok(), qPrintable(program.error().context));
        QVERIFY(!program->unfinished);
        const urscript::CompileOutcome outcome = urscript::compile(program->script);
        QVERIFY2(bool(outcome), outcome.error.text.c_str());
    }

    void aUrpxProgramWithoutScriptIsRefusedWithItsNodes() {
        const auto bare = pendant::readUrpx(R"json({"program": {"programContent": {"children": [
            {"contributedNode": {"type": "ur-functions"}, "children": [{"contributedNode": {"type": "ur-move-to"}},
             {"contributedNode": {"type": "ur-wait"}}, {"contributedNode": {"type": "ur-move-to"}}]}]}}})json");
        QVERIFY(!bare.ok());
        QVERIFY2(bare.error().context.endsWith("the simulated controller cannot run these nodes of the "
                                               "program: ur-functions, ur-move-to, ur-wait"),
                 qPrintable(bare.error().context));
        const auto whole = pendant::readUrpx(R"json({"application": {"urscript": {"script": "global a = 1"}},
            "program": {"urscript": {"script": "textmsg(a)"}}})json");
        QVERIFY(whole.ok() && urscript::compile(whole->script));
    }

    void aThousandDamagedProgramsAreRefusedOrCompiled() {
        const QByteArray whole = everyNode();
        int reported = 0, refused = 0;
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            const QByteArray content = Mutator(seed).mutated(whole);
            const auto program = pendant::readUrp(content, "p", source(content));
            if (!program) {
                ++refused;
                QVERIFY2(!program.error().context.isEmpty(), qPrintable(QString::number(seed)));
                continue;
            }
            ++reported;
            const urscript::CompileOutcome outcome = urscript::compile(program->script);
            QVERIFY2(outcome || !outcome.error.text.empty(), qPrintable(QString::number(seed)));
        }
        // Both outcomes must occur, or the mutations would test nothing beyond the first line of a program.
        QVERIFY2(reported > 50 && refused > 50,
                 qPrintable(QStringLiteral("%1 %2").arg(reported).arg(refused)));
    }

    void aThousandDamagedArchivesAreRefusedOrRead() {
        // Compressed as on the teach pendant. qCompress() produces the same deflated bytes with a different
        // header, and the checksum at the end detects damage.
        const QByteArray zlib = qCompress(everyNode());
        const QByteArray gzip = QByteArray("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10) +
                                zlib.mid(6, zlib.size() - 10) + QByteArray(8, '\0');
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            const QByteArray content = Mutator(seed).mutated(gzip);
            const auto program = pendant::readUrp(content, "p", source(content));
            QVERIFY(program.ok() || !program.error().context.isEmpty());
        }
    }

private:
    /// Resolves every program reference to the program itself, so that the program may call itself endlessly.
    static pendant::PendantSource source(const QByteArray& content) {
        pendant::PendantSource source;
        source.files = [content](const QString& name) -> std::optional<QByteArray> {
            return name.endsWith(".urp")            ? content
                   : name.endsWith(".installation") ? anInstallation()
                   : name.endsWith(".variables")    ? QByteArray("count=7\n")
                                                    : QByteArray("z = 3\n");
        };
        return source;
    }
};

QTEST_GUILESS_MAIN(TestProgramMutations)
#include "tst_program_mutations.moc"
