// SPDX-License-Identifier: MIT
//
// Who may include whom, read off the #include lines of the whole tree. A new room gets a row in the table.

#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>
#include <algorithm>

namespace {

struct Room {
    const char* path;         ///< folder, longest match wins
    QStringList mayInclude;   ///< rooms or single headers besides its own
    QStringList forbiddenQt;  ///< Qt modules by the first letters of their headers
};

const QStringList kGui = {"QWidget",  "QApplication", "QMainWindow", "QPainter", "QtWidgets", "QtGui",
                          "QtCharts", "QChart",       "QColor",      "QIcon",    "QPixmap"};

const QList<Room>& rooms() {
    static const QList<Room> table = {
        {"robot/core", {}, kGui},
        {"robot/realtime", {"robot/core"}, kGui},
        {"robot/rtde", {"robot/core"}, kGui},
        {"robot/receive", {"robot/core", "robot/realtime", "robot/rtde"}, kGui},
        {"robot/control",
         {"robot/core", "robot/realtime", "robot/rtde", "robot/receive", "robot/script", "robot/kinematics",
          "robot/collision"},
         kGui},
        {"robot/io", {"robot/core", "robot/rtde", "robot/receive"}, kGui},
        {"robot/script", {"robot/core"}, kGui},
        {"robot/dashboard", {"robot/core", "robot/script", "robot/receive"}, kGui},
        {"robot/doctor",
         {"robot/core", "robot/realtime", "robot/rtde", "robot/dashboard", "robot/script", "robot/receive"},
         kGui},
        {"robot/kinematics", {"robot/core"}, kGui},
        {"robot/collision", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/project", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/recording", {"robot/core", "robot/realtime", "robot/receive", "robot/rtde/fields.h"}, kGui},
        {"robot/divergence",
         {"robot/core", "robot/kinematics", "robot/recording", "robot/simulator/arm/driven_arm.h",
          "robot/simulator/arm/dynamics.h"},
         kGui},
        {"robot/live",
         {"robot/core", "robot/realtime", "robot/receive", "robot/recording/mcap/robot_state_message.h",
          "robot/recording/mcap/ros_messages.h"},
         kGui},
        {"robot/ur_rtde",
         {"robot/core", "robot/realtime", "robot/rtde", "robot/control", "robot/receive", "robot/recording",
          "robot/script", "robot/dashboard", "robot/io/robotiq_client.h"},
         kGui},
        {"robot/python",
         {"robot/ur_rtde", "robot/ur_rtde/detail/waiting.h", "robot/core", "robot/realtime", "robot/receive",
          "robot/recording", "robot/control", "robot/io", "robot/dashboard", "robot/doctor",
          "robot/kinematics", "robot/simulator/simulator.h", "robot/simulator/box/personality.h"},
         kGui},
        {"robot/examples",
         {"robot/core", "robot/receive", "robot/recording", "robot/control", "robot/io",
          "robot/simulator/simulator.h"},
         kGui},
        {"robot/station/program",
         {"robot/core", "robot/kinematics", "robot/project", "robot/script/supervised_program.h"},
         kGui},
        {"robot/station/program/preview",
         {"robot/core", "robot/kinematics", "robot/project", "robot/collision", "robot/station/program",
          "robot/simulator/script_run.h", "robot/simulator/simulator_options.h"},
         kGui},
        {"robot/simulator/urscript", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/simulator/arm", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/simulator",
         {"robot/core", "robot/realtime", "robot/kinematics", "robot/rtde/protocol.h", "robot/rtde/codec.h",
          "robot/rtde/splitter.h", "robot/rtde/values.h", "robot/rtde/fields.h"},
         kGui},
        {"widgets/common", {"robot/core", "robot/control/motion_types.h"}, {}},
        {"widgets",
         {"robot/core", "robot/realtime", "robot/receive", "robot/control", "robot/io", "robot/script",
          "robot/dashboard", "robot/kinematics", "robot/collision", "robot/project", "robot/recording",
          "robot/divergence", "robot/doctor", "robot/station/program"},
         {}},
        {"app", {"widgets", "robot"}, {}},
    };
    return table;
}

const Room* roomOf(const QString& file) {
    const Room* best = nullptr;
    for (const Room& room : rooms()) {
        const QString path = QString::fromLatin1(room.path);
        if (file.startsWith(path + '/') &&
            (best == nullptr || path.size() > qsizetype(qstrlen(best->path)))) {
            best = &room;
        }
    }
    return best;
}

bool isDetail(const QString& file) {
    return file.contains(QLatin1String("/detail/"));
}

bool isAllowed(const Room& room, const QString& included) {
    // What is in a room's detail/ is for that room alone, and changes without notice; whoever needs a header of it
    // all the same is named with it in the table.
    if (isDetail(included)) {
        return included.startsWith(QString::fromLatin1(room.path) + '/') ||
               room.mayInclude.contains(included);
    }
    if (roomOf(included) == &room) {
        return true;
    }
    // A sub-room belongs to its parent: the simulator may use its own arm and
    // interpreter.
    if (included.startsWith(QString::fromLatin1(room.path) + '/')) {
        return true;
    }
    for (const QString& allowed : room.mayInclude) {
        if (included == allowed || included.startsWith(allowed + '/')) {
            return true;
        }
    }
    return false;
}

QStringList sourceFiles() {
    QStringList files;
    for (const char* top : {"app", "robot", "widgets", "tests"}) {
        QDirIterator it(QStringLiteral(TILLER_SOURCE_DIR "/") + top, {"*.h", "*.cpp"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            files << QDir(TILLER_SOURCE_DIR).relativeFilePath(it.next());
        }
    }
    return files;
}

QByteArray contentsOf(const QString& file) {
    QFile f(QStringLiteral(TILLER_SOURCE_DIR "/") + file);
    return f.open(QIODevice::ReadOnly) ? f.readAll() : QByteArray();
}

/// Those a program of others can include; the classes of the ur_rtde interface are given.
QStringList publicHeaders() {
    static const QRegularExpression kOwn(
        "/(detail|custom|python|examples|ur_rtde)/|simulator/"
        "(?!(assumptions|simulator|simulator_options|arm/arm_state|arm/environment|box/personality)\\.h)");
    QStringList headers;
    for (const QString& file : sourceFiles()) {
        if (file.startsWith("robot/") && file.endsWith(".h") && !kOwn.match(file).hasMatch()) {
            headers << file;
        }
    }
    return headers;
}

/// "12: int f();" for each that can be called by others and has no comment of its own, on its line or above it.
QStringList functionsWithoutComment(const QByteArray& header) {
    static const QRegularExpression kScope("^(namespace|class|struct|template <.*> *(class|struct))\\b");
    static const QRegularExpression kFunction(
        "^(?!return|if|for|while|using|friend|explicit|enum|static_assert|typedef|case|[:,?}])"
        "[\\w:<>,&*\\[\\] ]+[ &*>]\\w+\\(");
    static const QRegularExpression kIterator("\\b(begin|end)\\(|operator|= default|= delete|\\boverride\\b");
    const QStringList lines = QString::fromUtf8(header).split('\n');
    QStringList found;
    struct Scope {
        bool declares;  ///< a namespace or a class: what stands in it can be called
        bool open;      ///< public
    };
    QList<Scope> scopes;
    QString before;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString line = lines[i].trimmed();
        if (line.startsWith("//") || line.startsWith('#')) {
            before = line;
            continue;
        }
        if (!scopes.isEmpty() && (line == "public:" || line == "private:" || line == "protected:")) {
            scopes.last().open = line == "public:";
        }
        const bool callable =
            !scopes.isEmpty() &&
            std::all_of(scopes.begin(), scopes.end(), [](const Scope& s) { return s.declares && s.open; });
        const QString code = line.section("///<", 0, 0);
        if (callable && kFunction.match(code).hasMatch() && !kIterator.match(code).hasMatch() &&
            !kScope.match(code).hasMatch() && !line.contains("///<") && !before.startsWith("//") &&
            !code.section('(', 0, 0).contains('=')) {
            found << QStringLiteral("%1: %2").arg(i + 1).arg(line);
        }
        const bool declares = kScope.match(code).hasMatch();
        for (const QChar c : code) {
            if (c == '{') {
                scopes.append({declares, !code.startsWith("class") && !code.contains("> class")});
            } else if (c == '}' && !scopes.isEmpty()) {
                scopes.removeLast();
            }
        }
        before = line.startsWith("template") ? before : line;
    }
    return found;
}

}  // namespace

class TestLayering : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theTableItselfCatchesAForbiddenInclude() {
        const Room* receive = roomOf("robot/receive/receiver.cpp");
        QVERIFY(receive != nullptr);
        QVERIFY(!isAllowed(*receive, "robot/control/controller.h"));
        QVERIFY(isAllowed(*receive, "robot/rtde/codec.h"));
        QVERIFY(!isAllowed(*roomOf("robot/simulator/simulator.cpp"), "robot/rtde/session.h"));
        QVERIFY(!isAllowed(*roomOf("widgets/jog/jog_column.cpp"), "robot/simulator/simulator.h"));
        for (const char* outside :
             {"widgets/session/robot_session.cpp", "app/main.cpp", "robot/ur_rtde/detail/native_control.cpp",
              "robot/python/native_control.cpp", "robot/io/outputs.cpp"}) {
            QVERIFY2(!isAllowed(*roomOf(outside), "robot/control/detail/mailbox.h"), outside);
        }
        QVERIFY(isAllowed(*roomOf("robot/control/motions.cpp"), "robot/control/detail/mailbox.h"));
    }

    void includesFollowTheArchitecture() {
        static const QRegularExpression include(QStringLiteral("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"),
                                                QRegularExpression::MultilineOption);
        QStringList violations;
        int includes = 0;
        for (const QString& file : sourceFiles()) {
            const Room* room = roomOf(file);
            if (room == nullptr) {
                continue;  // tests may look into every room
            }
            auto it = include.globalMatch(QString::fromUtf8(contentsOf(file)));
            while (it.hasNext()) {
                const QString included = it.next().captured(1);
                ++includes;
                if (roomOf(included) != nullptr && !isAllowed(*room, included)) {
                    violations << file + " includes " + included;
                }
                for (const QString& prefix : room->forbiddenQt) {
                    if (included.startsWith(prefix)) {
                        violations << file + " includes " + included;
                    }
                }
            }
        }
        QVERIFY2(includes > 100, "no include lines found: is TILLER_SOURCE_DIR right?");
        QVERIFY2(violations.isEmpty(), qPrintable(violations.join('\n')));
    }

    // Those are not installed: a header of a user's that includes one would not compile.
    void publicHeadersDoWithoutDetails() {
        QStringList violations;
        int headers = 0;
        for (const QString& file : sourceFiles()) {
            if (!file.startsWith("robot/") || !file.endsWith(".h") || isDetail(file) ||
                file.startsWith("robot/ur_rtde/custom/")) {  // not installed either
                continue;
            }
            ++headers;
            for (const QByteArray& line : contentsOf(file).split('\n')) {
                if (line.startsWith("#include") && isDetail(QString::fromUtf8(line))) {
                    violations << file + ": " + QString::fromUtf8(line);
                }
            }
        }
        QVERIFY(headers > 100);
        QVERIFY2(violations.isEmpty(), qPrintable(violations.join('\n')));
    }

    void theCheckerFindsAFunctionWithoutAComment() {
        const QByteArray header =
            "namespace a {\nclass B {\npublic:\n    int said() const;  ///< [mm]\n    int unsaid() const;\n"
            "private:\n    int hidden();\n};\n/// Said.\nint f();\nint g();\n}\n";
        QCOMPARE(functionsWithoutComment(header), (QStringList{"5: int unsaid() const;", "11: int g();"}));
    }

    void everyPublicFunctionSaysWhatItDoes() {
        QStringList missing;
        for (const QString& file : publicHeaders()) {
            for (const QString& line : functionsWithoutComment(contentsOf(file))) {
                missing << file + ':' + line;
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join('\n')));
    }

    void publicHeadersAreShort() {
        QList<qsizetype> lengths;
        for (const QString& file : publicHeaders()) {
            lengths << contentsOf(file).count('\n');
            QVERIFY2(lengths.last() <= 200, qPrintable(file));
        }
        QVERIFY(lengths.size() > 60);
        std::sort(lengths.begin(), lengths.end());
        QVERIFY2(lengths[lengths.size() / 2] <= 70, qPrintable(QString::number(lengths[lengths.size() / 2])));
    }

    void everyFileIsFormatted() {
        const QString formatter = QStandardPaths::findExecutable("clang-format-14");
        if (formatter.isEmpty()) {
            QSKIP("clang-format-14 is not installed");
        }
        QProcess process;
        process.setWorkingDirectory(TILLER_SOURCE_DIR);
        process.start(formatter, QStringList{"--dry-run", "-Werror"} + sourceFiles());
        QVERIFY(process.waitForFinished(120'000));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError().left(2000).constData());
    }

    void everyFileNamesItsLicence() {
        QStringList missing;
        for (const QString& file : sourceFiles()) {
            const QByteArray head = contentsOf(file).left(200);
            const bool gpl = file.startsWith("app/") || file.startsWith("widgets/");
            if (gpl && !head.contains("SPDX-License-Identifier: GPL-3.0-or-later")) {
                missing << file + ": GPL-3.0-or-later";
            }
            if (file.startsWith("robot/") && !head.contains("SPDX-License-Identifier: MIT")) {
                missing << file + ": MIT";
            }
            if (!head.contains("SPDX-License-Identifier: ")) {
                missing << file + ": any";
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join('\n')));
    }
};

QTEST_GUILESS_MAIN(TestLayering)
#include "tst_layering.moc"
