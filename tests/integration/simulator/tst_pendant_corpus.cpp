// SPDX-License-Identifier: MIT
// Programs as saved by the teach pendant (tests/data/pendant). Each program is loaded and played in virtual
// time, and the events visible to clients are compared with the program's trace. For some programs there is
// also a script exported by the teach pendant (exports/), which must have the same effect.
//
// To update the traces, run:  TILLER_UPDATE=1 tst_pendant_corpus
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "robot/station/program/import/program_import.h"
#include "robot/station/program/program_script.h"
#include "tests/support/primary_listener.h"

using namespace tiller;
using namespace tiller::test;

namespace {

const QString kFolder = qEnvironmentVariable("TILLER_TEST_DATA") + "/pendant";

enum { kLabel = 1, kRequestedValue = 9 };

QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Loads and plays a program, answers its popups and questions, and records the events visible to a client.
class Player {
public:
    explicit Player(const QString& folder)
        : robot_([&folder] {
            auto options = VirtualRobot::options();
            options.programsFolder = folder;
            return options;
        }())
        , dashboard_(robot_.dashboard())
        , primary_(robot_.primary()) {}

    QStringList play(const QString& name) {
        robot_.controller.drainSockets();
        robot_.controller.step();
        primary_.takeAll();
        const bool loaded = dashboard_.ask("load " + name.toUtf8()).startsWith("Loading program");
        trace_ << (loaded ? "loaded" : "not loaded");
        if (loaded) {
            trace_ << (dashboard_.ask("play") == "Starting program\n" ? "playing" : "not playing");
        }
        constexpr int kPeriods = 5, kMaxSteps = 3000;
        bool began = false;
        for (int i = 0; i < kMaxSteps; ++i) {
            robot_.controller.step(kPeriods);
            note();
            const bool stopped = robot_.programState() == RuntimeState::Stopped;
            began = began || !stopped;
            if (stopped && (began || i > 2)) {
                break;
            }
        }
        const auto& truth = robot_.controller.truth();
        QStringList joints;
        for (int i = 0; i < 6; ++i) {
            joints << QString::number(truth.q[i] + 0.0, 'f', 2);
        }
        trace_ << (robot_.programState() == RuntimeState::Stopped ? "stopped at " : "still running at ") +
                      joints.join(' ').replace("-0.00", "0.00");
        return trace_;
    }

private:
    void note() {
        for (const QByteArray& package : primary_.packages()) {
            if (package[4] != 20) {
                continue;
            }
            const QByteArray body = package.mid(15);
            switch (package[14]) {
                case kLabel:
                    trace_ << QStringLiteral("label %1 %2")
                                  .arg(intAt(body, 0))
                                  .arg(QString::fromUtf8(body.mid(4)));
                    break;
                case kText:
                    trace_ << "text " + QString::fromUtf8(body);
                    break;
                case kException:
                    trace_ << "exception " + QString::fromUtf8(body.mid(8));
                    break;
                case kErrorCode:
                    trace_ << "error";
                    break;
                case kPopup: {
                    const int title = static_cast<unsigned char>(body[11]);
                    trace_ << QStringLiteral("popup %1%2%3 '%4' %5")
                                  .arg(int(body[8]))
                                  .arg(int(body[9]))
                                  .arg(int(body[10]))
                                  .arg(QString::fromUtf8(body.mid(12, title)),
                                       QString::fromUtf8(body.mid(12 + title)));
                    if (body[10] != 0) {
                        dashboard_.ask("close popup");
                    }
                    break;
                }
                case kRequestedValue:
                    trace_ << "question " + QString::fromUtf8(body.mid(8));
                    robot_.controller.answerRequest(true);
                    break;
                default:
                    break;
            }
        }
        const auto outputs = robot_.controller.truth().digitalOutputs;
        if (outputs != outputs_) {
            outputs_ = outputs;
            trace_ << QStringLiteral("outputs %1").arg(outputs, 0, 2);
        }
    }

    VirtualRobot robot_;
    RawDashboard dashboard_;
    RawPrimary primary_;
    QStringList trace_;
    quint64 outputs_ = 0;
};

void addPrograms(const QString& folder, const QString& ending) {
    QTest::addColumn<QString>("name");
    for (const QString& file : QDir(folder).entryList({"*" + ending}, QDir::Files, QDir::Name)) {
        const QString name = file.chopped(ending.size());
        QTest::newRow(qPrintable(name)) << name;
    }
}

/// The trace without labels, because the order of two threads within a period is not relevant.
QStringList effects(QStringList trace) {
    trace.removeIf([](const QString& line) { return line.startsWith("label "); });
    return trace;
}

/// The trace without the titles of popups, because the steps of imported programs have no titles.
QStringList withoutTitles(QStringList trace) {
    static const QRegularExpression title("^(popup \\d+) '[^']*'");
    return trace.replaceInStrings(title, "\\1");
}

}  // namespace

class TestPendantCorpus : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyProgramHasItsTrace_data() { addPrograms(kFolder, ".urp"); }
    void everyProgramHasItsTrace() {
        QFETCH(QString, name);
        if (name.startsWith("refused") || name.startsWith("unfinished")) {
            QTest::ignoreMessage(QtWarningMsg, QRegularExpression("^Error while loading program: "));
        }
        const QStringList trace = Player(kFolder).play(name + ".urp");
        const QString path = kFolder + '/' + name + ".trace";
        if (qEnvironmentVariableIsSet("TILLER_UPDATE")) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(trace.join('\n').toUtf8() + '\n');
            return;
        }
        QCOMPARE(trace, contentOf(path).split('\n', Qt::SkipEmptyParts));
    }

    // The corpus must contain every kind of node.
    void theCorpusHasEveryNode() {
        QString all;
        for (const QString& file : QDir(kFolder).entryList({"*.urp"}, QDir::Files)) {
            all += contentOf(kFolder + '/' + file);
        }
        for (const char* const element : {"<Script type=\"Line\"",
                                          "<Script type=\"File\"",
                                          "<Assignment valueSource=\"Expression\"",
                                          "<Assignment valueSource=\"Operator\"",
                                          "<If type=\"If\"",
                                          "<If type=\"ElseIf\"",
                                          "<If type=\"Else\"",
                                          "checkContinuously=\"true\"",
                                          "<Loop type=\"Counting\"",
                                          "<Loop type=\"While\"",
                                          "<Loop type=\"Forever\"",
                                          "<Switch>",
                                          "<Case ",
                                          "<Default>",
                                          "<Case caseValue=\"2147483647\"",
                                          "<Wait type=\"Sleep\"",
                                          "<Wait type=\"DigitalInput\"",
                                          "<Wait type=\"AnalogInput\"",
                                          "<Wait type=\"Condition\"",
                                          "<Wait type=\"NoWait\"",
                                          "<Set type=\"DigitalOutput\"",
                                          "<Set type=\"AnalogOutput\"",
                                          "<Set type=\"ExpressionOutput\"",
                                          "<Set type=\"NoAction\"",
                                          "<SetPayload ",
                                          "<Popup type=\"Message\"",
                                          "<Popup type=\"Warning\"",
                                          "<Popup type=\"Error\"",
                                          "inputType=\"Variable\"",
                                          "<Halt/>",
                                          "<Comment ",
                                          "<Folder ",
                                          "<Timer action=\"Start\"",
                                          "<Timer action=\"Stop\"",
                                          "<Timer action=\"Reset\"",
                                          "<Thread ",
                                          "<Event>",
                                          "<SpecialSequence ",
                                          "<InitVariablesNode>",
                                          "<CallSubProgram>",
                                          "<SubProgram ",
                                          "<Move motionType=\"MoveJ\"",
                                          "<Move motionType=\"MoveL\"",
                                          "<Move motionType=\"MoveP\"",
                                          "<Waypoint type=\"Fixed\"",
                                          "<Waypoint type=\"Relative\"",
                                          "<Waypoint type=\"Variable\"",
                                          "<CircleMove OrientationMode=\"FIXED\"",
                                          "<CircleMove OrientationMode=\"UNCONSTRAINED\"",
                                          "MoveDirectionNode selectedDirection",
                                          "<Until type=\"DISTANCE\"",
                                          "<Until type=\"EXPRESSION\"",
                                          "<Until type=\"REACHED_WAYPOINT\"",
                                          "<Force type=\"Simple\"",
                                          "<Force type=\"Frame\"",
                                          "<Force type=\"Point\"",
                                          "<Force type=\"Motion\"",
                                          "<SafeHome",
                                          "<SuppressedNode>",
                                          "<Placeholder/>",
                                          "<position joints=",
                                          "<Waypoint reference=",
                                          "<If reference=",
                                          "<feature class=\"GeomFeatureVariable\"",
                                          "<ExpressionWaypoint>",
                                          "<GeomFeatureVariable ",
                                          "<InstallationVariable ",
                                          "<Contributed "}) {
            QVERIFY2(all.contains(QLatin1String(element)), element);
        }
    }

    void theImportedProgramHasTheSameEffects_data() {
        QTest::addColumn<QString>("file");
        for (const char* const ending : {"*.urp", "exports/*.script"}) {
            const QDir folder(kFolder + '/' + QFileInfo(ending).path());
            for (const QString& file :
                 folder.entryList({QFileInfo(ending).fileName()}, QDir::Files, QDir::Name)) {
                if (!file.startsWith("refused") && !file.startsWith("unfinished")) {
                    QTest::newRow(qPrintable(file)) << folder.filePath(file);
                }
            }
        }
    }
    void theImportedProgramHasTheSameEffects() {
        QFETCH(QString, file);
        program::ImportSource source;
        source.file = QFileInfo(file).fileName();
        source.content = contentOf(file).toUtf8();
        source.files = [](const QString& name) -> std::optional<QByteArray> {
            QFile other(kFolder + '/' + QFileInfo(name).fileName());
            return other.open(QIODevice::ReadOnly) ? std::optional(other.readAll()) : std::nullopt;
        };
        const auto imported = program::importProgram({}, source);
        QVERIFY2(imported.ok(), qPrintable(imported.error().toString()));
        const auto script = program::writeScript(imported->project, imported->program);
        QVERIFY2(script.ok(), qPrintable(script.problems.empty() ? QString() : script.problems[0].text));
        if (qEnvironmentVariableIsSet("TILLER_SHOW")) {
            qInfo().noquote() << script.text;
            for (const auto& row : imported->rows) {
                qInfo().noquote() << row.line << row.name << int(row.result) << row.kind << row.reason;
            }
        }
        const QTemporaryDir folder;
        QFile exported(folder.filePath("imported.script"));
        QVERIFY(exported.open(QIODevice::WriteOnly));
        exported.write(script.text.toUtf8());
        exported.close();
        QCOMPARE(withoutTitles(effects(Player(folder.path()).play("imported.script"))),
                 withoutTitles(effects(Player(kFolder).play(QDir(kFolder).relativeFilePath(file)))));
    }

    void theExportedScriptHasTheSameEffects_data() { addPrograms(kFolder + "/exports", ".script"); }
    void theExportedScriptHasTheSameEffects() {
        QFETCH(QString, name);
        const QStringList program = effects(Player(kFolder).play(name + ".urp"));
        const QStringList script = effects(Player(kFolder).play("exports/" + name + ".script"));
        QCOMPARE(program, script);
    }
};

QTEST_GUILESS_MAIN(TestPendantCorpus)
#include "tst_pendant_corpus.moc"
