// SPDX-License-Identifier: MIT
//
// Permitted includes between the folders, checked in the whole source tree. A folder that is added needs a
// row in the table.

#include <QDirIterator>
#include <QFile>
#include <QHash>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>
#include <algorithm>

namespace {

struct Folder {
    const char* path;         ///< folder; the longest match applies
    QStringList mayInclude;   ///< permitted folders or headers in addition to the folder itself
    QStringList forbiddenQt;  ///< forbidden Qt modules, given by the first letters of their headers
};

const QStringList kGui = {"QWidget",  "QApplication", "QMainWindow", "QPainter", "QtWidgets", "QtGui",
                          "QtCharts", "QChart",       "QColor",      "QIcon",    "QPixmap"};

/// A folder may include its own headers and those in `mayInclude`, which must be in rows above it.
const QList<Folder>& folders() {
    static const QList<Folder> table = {
        {"robot/platform", {}, kGui},
        {"robot/core", {"robot/platform"}, kGui},
        {"robot/realtime", {"robot/platform", "robot/core"}, kGui},
        {"robot/rtde", {"robot/platform", "robot/core"}, kGui},
        {"robot/receive", {"robot/platform", "robot/core", "robot/realtime", "robot/rtde"}, kGui},
        {"robot/kinematics", {"robot/core"}, kGui},
        {"robot/collision", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/script", {"robot/platform", "robot/core"}, kGui},
        {"robot/control",
         {"robot/platform", "robot/core", "robot/realtime", "robot/rtde", "robot/receive", "robot/script",
          "robot/kinematics", "robot/collision"},
         kGui},
        {"robot/io", {"robot/platform", "robot/core", "robot/rtde", "robot/receive"}, kGui},
        {"robot/dashboard", {"robot/platform", "robot/core", "robot/script", "robot/receive"}, kGui},
        {"robot/doctor",
         {"robot/core", "robot/realtime", "robot/rtde", "robot/dashboard", "robot/script", "robot/receive"},
         kGui},
        {"robot/project", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/publish", {"robot/platform", "robot/core", "robot/realtime", "robot/receive"}, kGui},
        {"robot/recording",
         {"robot/platform", "robot/core", "robot/realtime", "robot/receive", "robot/publish",
          "robot/rtde/fields.h"},
         kGui},
        {"robot/recording/mcap",
         {"robot/platform", "robot/core", "robot/realtime", "robot/receive", "robot/publish",
          "robot/recording", "robot/rtde/fields.h", "robot/recording/detail/column_knowledge.h",
          "robot/recording/detail/exported_events.h", "robot/recording/detail/packet_clock.h",
          "robot/recording/detail/ranges.h", "robot/recording/detail/recording_file.h",
          "robot/recording/detail/summarize.h"},
         kGui},
        {"robot/recording/hdf5",
         {"robot/core", "robot/recording", "robot/rtde/fields.h", "robot/recording/detail/column_knowledge.h",
          "robot/recording/detail/csv_notes.h", "robot/recording/detail/exported_events.h",
          "robot/recording/detail/ranges.h", "robot/recording/detail/time_axis.h"},
         kGui},
        {"robot/recording/formats",
         {"robot/core", "robot/recording", "robot/recording/mcap", "robot/recording/hdf5"},
         kGui},
        {"robot/simulator/options", {"robot/core"}, kGui},
        {"robot/simulator/urscript", {"robot/core"}, kGui},
        {"robot/simulator/arm", {"robot/core", "robot/kinematics"}, kGui},
        {"robot/simulator/pendant", {"robot/core"}, kGui},
        {"robot/simulator/net", {"robot/platform", "robot/core"}, kGui},
        {"robot/simulator/plant",
         {"robot/core", "robot/kinematics", "robot/rtde/codec.h", "robot/rtde/fields.h",
          "robot/rtde/values.h", "robot/simulator/options", "robot/simulator/urscript", "robot/simulator/arm",
          "robot/simulator/net"},
         kGui},
        {"robot/simulator/equipment",
         {"robot/core", "robot/simulator/urscript", "robot/simulator/net", "robot/simulator/plant"},
         kGui},
        {"robot/simulator/host",
         {"robot/core", "robot/kinematics", "robot/rtde/fields.h", "robot/simulator/urscript",
          "robot/simulator/arm", "robot/simulator/plant", "robot/simulator/equipment"},
         kGui},
        {"robot/simulator/programs",
         {"robot/core", "robot/simulator/urscript", "robot/simulator/pendant", "robot/simulator/plant"},
         kGui},
        {"robot/simulator/controller",
         {"robot/simulator/plant", "robot/simulator/host", "robot/simulator/programs"},
         kGui},
        {"robot/simulator/servers/service",
         {"robot/platform", "robot/core", "robot/simulator/options", "robot/simulator/urscript",
          "robot/simulator/net", "robot/simulator/plant", "robot/simulator/programs",
          "robot/simulator/controller"},
         kGui},
        {"robot/simulator/servers/primary",
         {"robot/core", "robot/simulator/options", "robot/simulator/urscript", "robot/simulator/net",
          "robot/simulator/plant", "robot/simulator/programs", "robot/simulator/controller",
          "robot/simulator/servers/service"},
         kGui},
        {"robot/simulator/servers/rtde",
         {"robot/core", "robot/rtde/protocol.h", "robot/rtde/codec.h", "robot/rtde/splitter.h",
          "robot/rtde/values.h", "robot/rtde/fields.h", "robot/simulator/options", "robot/simulator/net",
          "robot/simulator/plant", "robot/simulator/controller"},
         kGui},
        {"robot/simulator/servers",
         {"robot/platform", "robot/core", "robot/simulator/options", "robot/simulator/urscript",
          "robot/simulator/net", "robot/simulator/equipment", "robot/simulator/programs",
          "robot/simulator/host", "robot/simulator/controller"},
         kGui},
        {"robot/simulator", {"robot/platform", "robot/core", "robot/realtime", "robot/rtde/fields.h"}, kGui},
        {"robot/divergence",
         {"robot/core", "robot/kinematics", "robot/recording", "robot/simulator/arm/driven_arm.h",
          "robot/simulator/arm/dynamics.h"},
         kGui},
        {"robot/api",
         {"robot/platform", "robot/core", "robot/realtime", "robot/receive", "robot/control", "robot/io",
          "robot/dashboard", "robot/recording"},
         kGui},
        {"robot/c", {"robot/core", "robot/receive", "robot/control", "robot/io", "robot/api"}, kGui},
        {"robot/live",
         {"robot/platform", "robot/core", "robot/realtime", "robot/receive", "robot/publish",
          "robot/recording/mcap/robot_state_message.h", "robot/recording/mcap/ros_messages.h"},
         kGui},
        {"robot/ur_rtde",
         {"robot/platform", "robot/core", "robot/realtime", "robot/rtde", "robot/control", "robot/receive",
          "robot/recording", "robot/script", "robot/dashboard", "robot/io/robotiq_client.h"},
         kGui},
        {"robot/testing",
         {"robot/core", "robot/receive", "robot/control", "robot/simulator/simulator.h"},
         kGui},
        {"robot/examples",
         {"robot/core", "robot/receive", "robot/recording", "robot/control", "robot/io", "robot/api",
          "robot/simulator/simulator.h", "robot/testing"},
         kGui},
        {"robot/station/text", {"robot/core", "robot/control", "robot/collision", "robot/project"}, kGui},
        {"robot/station/executor", {"robot/core"}, kGui},
        {"robot/station/journal", {}, kGui},
        {"robot/station/link",
         {"robot/core", "robot/realtime", "robot/rtde/fields.h", "robot/receive", "robot/publish",
          "robot/control", "robot/io", "robot/script", "robot/dashboard", "robot/kinematics",
          "robot/collision", "robot/recording", "robot/station/text", "robot/station/executor",
          "robot/station/journal"},
         kGui},
        {"robot/station/capture",
         {"robot/core", "robot/receive", "robot/script", "robot/dashboard", "robot/recording",
          "robot/station/text", "robot/station/executor", "robot/station/journal", "robot/station/link"},
         kGui},
        {"robot/station/history",
         {"robot/core", "robot/receive", "robot/recording", "robot/divergence", "robot/station/text",
          "robot/station/executor", "robot/station/journal", "robot/station/link"},
         kGui},
        {"robot/station/jog",
         {"robot/core", "robot/control", "robot/kinematics", "robot/collision", "robot/station/text",
          "robot/station/link"},
         kGui},
        {"robot/station/document",
         {"robot/core", "robot/kinematics", "robot/collision", "robot/project", "robot/station/executor"},
         kGui},
        {"robot/station/program",
         {"robot/core", "robot/kinematics", "robot/project", "robot/script/step_gate.h",
          "robot/script/supervised_program.h"},
         kGui},
        {"robot/station/program/import",
         {"robot/core", "robot/kinematics", "robot/project", "robot/station/program",
          "robot/simulator/pendant/pendant_program.h", "robot/simulator/pendant/script_text.h",
          "robot/simulator/script_run.h"},
         kGui},
        {"robot/station/program/preview",
         {"robot/core", "robot/kinematics", "robot/project", "robot/collision",
          "robot/control/motion_types.h", "robot/script/supervised_program.h", "robot/station/text",
          "robot/station/program", "robot/station/document", "robot/simulator/script_run.h",
          "robot/simulator/options/simulator_options.h"},
         kGui},
        {"robot/station/program/test",
         {"robot/core", "robot/collision", "robot/project", "robot/station/program",
          "robot/station/program/preview"},
         kGui},
        {"robot/station/program/recover",
         {"robot/core", "robot/project", "robot/station/program", "robot/station/program/preview",
          "robot/simulator/script_run.h"},
         kGui},
        {"robot/station/program/execution",
         {"robot/core", "robot/kinematics", "robot/receive", "robot/control", "robot/project",
          "robot/rtde/fields.h", "robot/script/primary_client.h", "robot/script/program_variables.h",
          "robot/script/script_client.h", "robot/script/step_gate.h", "robot/station/program",
          "robot/station/program/preview"},
         kGui},
        {"robot/python",
         {"robot/platform",
          "robot/ur_rtde",
          "robot/ur_rtde/detail/waiting.h",
          "robot/core",
          "robot/realtime",
          "robot/receive",
          "robot/recording",
          "robot/control",
          "robot/io",
          "robot/dashboard",
          "robot/doctor",
          "robot/kinematics",
          "robot/collision",
          "robot/simulator/simulator.h",
          "robot/simulator/plant/personality.h",
          "robot/testing",
          "robot/project",
          "robot/station/program",
          "robot/station/program/preview",
          "robot/station/program/recover",
          "robot/station/program/execution"},
         kGui},
        {"robot/station/program/run",
         {"robot/core", "robot/kinematics", "robot/receive", "robot/control", "robot/project",
          "robot/script/program_variables.h", "robot/script/step_gate.h", "robot/station/text",
          "robot/station/link", "robot/station/program", "robot/station/program/preview",
          "robot/station/program/recover", "robot/station/program/execution"},
         kGui},
        {"robot/station/route",
         {"robot/core", "robot/receive", "robot/control", "robot/kinematics", "robot/project",
          "robot/recording", "robot/station/text", "robot/station/executor", "robot/station/link",
          "robot/station/document"},
         kGui},
        {"robot/station/practice",
         {"robot/core", "robot/kinematics", "robot/project", "robot/station/text", "robot/station/link",
          "robot/station/document"},
         kGui},
        {"robot/station", {"robot/core", "robot/project/project_file.h"}, kGui},
        {"widgets/common", {"robot/core", "robot/station/text"}, {}},
        {"widgets/hold",
         {"robot/core", "robot/control/motion_types.h", "robot/station/link/hold_motion.h", "widgets/common"},
         {}},
        {"widgets/signals", {"robot/station", "widgets/common"}, {}},
        {"widgets/plots",
         {"robot/core", "robot/divergence", "robot/recording", "robot/station", "widgets/common",
          "widgets/signals"},
         {}},
        {"widgets/jog",
         {"robot/core", "robot/control", "robot/io", "robot/kinematics", "robot/station", "widgets/common",
          "widgets/hold"},
         {}},
        {"widgets/io", {"robot/core", "robot/io", "robot/receive", "robot/station", "widgets/common"}, {}},
        {"widgets/log", {"robot/core", "robot/station", "widgets/common"}, {}},
        {"widgets/scene",
         {"robot/core", "robot/receive", "robot/kinematics", "robot/collision", "robot/station",
          "widgets/common"},
         {}},
        {"widgets/status",
         {"robot/core", "robot/script", "robot/dashboard", "robot/doctor", "robot/station", "widgets/common"},
         {}},
        {"widgets/project", {"robot/core", "robot/project", "robot/station", "widgets/common"}, {}},
        {"widgets/program",
         {"robot/core", "robot/project", "robot/script/program_variables.h", "robot/station",
          "widgets/common", "widgets/hold"},
         {}},
        {"widgets/waypoints",
         {"robot/core", "robot/receive", "robot/kinematics", "robot/project", "robot/recording",
          "robot/station", "widgets/common", "widgets/hold", "widgets/project"},
         {}},
        {"widgets/frames", {"robot/project", "robot/station", "widgets/common", "widgets/project"}, {}},
        {"widgets/tools",
         {"robot/core", "robot/kinematics", "robot/project", "robot/station", "widgets/common",
          "widgets/hold", "widgets/project"},
         {}},
        {"widgets/practice", {"robot/station", "widgets/common"}, {}},
        {"app", {"widgets", "robot"}, {}},
    };
    return table;
}

/// Folders without a separate row in the table. They and the folder whose row applies to them may include
/// each other.
const QStringList kParts = {
    "robot/station/program/steps",
    "robot/ur_rtde/custom",
    "robot/examples/cpp",
    "robot/examples/cpp/testing",
};

/// A folder whose row does not apply to its subfolders, because each of them needs a separate row.
const QString kFolderOfRows = QStringLiteral("robot/station");

const Folder* folderOf(const QString& file) {
    const Folder* best = nullptr;
    for (const Folder& folder : folders()) {
        const QString path = QString::fromLatin1(folder.path);
        if (path == kFolderOfRows && file.section('/', 0, -2) != path) {
            continue;
        }
        if (file.startsWith(path + '/') &&
            (best == nullptr || path.size() > qsizetype(qstrlen(best->path)))) {
            best = &folder;
        }
    }
    return best;
}

bool isDetail(const QString& file) {
    return file.contains(QLatin1String("/detail/"));
}

bool isAllowed(const Folder& folder, const QString& included) {
    // Headers in detail/ may be used only in their own folder and may change without notice. The table lists
    // exceptions.
    if (isDetail(included)) {
        return included.startsWith(QString::fromLatin1(folder.path) + '/') ||
               folder.mayInclude.contains(included);
    }
    const Folder* row = folderOf(included);
    if (row == &folder) {
        return true;
    }
    // The rows are in the order of their layers: includes only refer to rows above, so there are no cycles.
    if (row > &folder) {
        return false;
    }
    // A folder may include its subfolders, e.g. the simulator may use its arm and interpreter.
    if (included.startsWith(QString::fromLatin1(folder.path) + '/')) {
        return true;
    }
    for (const QString& allowed : folder.mayInclude) {
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

/// Returns the unit of a file, i.e. of a header and its source, e.g. "widgets/jog/jog_pad".
QString unitOf(const QString& file) {
    return file.section('.', 0, 0);
}

QStringList includesOf(const QString& unit) {
    static const QRegularExpression kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]",
                                             QRegularExpression::MultilineOption);
    QStringList included;
    for (const char* suffix : {".h", ".cpp"}) {
        auto it = kInclude.globalMatch(QString::fromUtf8(contentsOf(unit + suffix)));
        while (it.hasNext()) {
            included << it.next().captured(1);
        }
    }
    return included;
}

/// True for headers of Qt modules other than Core and Network, and of display and device libraries.
bool isOfDisplay(const QString& header) {
    static const QDir kHeaders(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    static const QRegularExpression kOthers("^(xcb/|SDL|spnav|X11/)");
    return kOthers.match(header).hasMatch() ||
           (header.startsWith('Q') && !kHeaders.exists("QtCore/" + header) &&
            !kHeaders.exists("QtNetwork/" + header));
}

/// Returns true if a unit of widgets/ displays something or uses a unit that does.
bool needsDisplay(const QString& unit, QSet<QString>& seen) {
    if (seen.contains(unit)) {
        return false;
    }
    seen.insert(unit);
    const QStringList included = includesOf(unit);
    return std::any_of(included.begin(), included.end(), [&](const QString& header) {
        return isOfDisplay(header) || (header.startsWith("widgets/") && needsDisplay(unitOf(header), seen));
    });
}

/// Units of widgets/ that need no display, with the reasons why they are in widgets/.
const QHash<QString, QString>& withoutDisplay() {
    static const QString kView = "values of the 3D view";
    static const QString kPlots = "layout of plots on the screen";
    static const QHash<QString, QString> table = {
        {"widgets/common/scene_marks", kView},
        {"widgets/common/stop_mark", "a property of the STOP button"},
        {"widgets/jog/input_device", "what devices in widgets/ implement"},
        {"widgets/plots/axis_range", kPlots},
        {"widgets/plots/time_window", kPlots},
        {"widgets/scene/arm_mesh", kView},
        {"widgets/scene/camera", kView},
        {"widgets/scene/label_placer", kView},
        {"widgets/scene/simd", kView},
        {"widgets/scene/mesh", kView},
        {"widgets/scene/scene_trace", kView},
    };
    return table;
}

/// Headers that other programs may include, except those of the ur_rtde interface.
QStringList publicHeaders() {
    static const QRegularExpression kOwn(
        "/(detail|custom|python|examples|ur_rtde|station)/|simulator/"
        "(?!(simulator|options/assumptions|options/simulator_options|arm/arm_state|arm/environment|"
        "plant/personality)\\.h)");
    QStringList headers;
    for (const QString& file : sourceFiles()) {
        if (file.startsWith("robot/") && file.endsWith(".h") && !kOwn.match(file).hasMatch()) {
            headers << file;
        }
    }
    return headers;
}

/// Returns the public functions of a header that can fail and have no comment, as "12: Result<int> f();".
QStringList functionsWithoutComment(const QByteArray& header) {
    static const QRegularExpression kScope("^(namespace|class|struct|template <.*> *(class|struct))\\b");
    static const QRegularExpression kFunction(
        "^(\\[\\[nodiscard\\]\\] |static |virtual |inline )*Result<.*> \\w+\\(");
    static const QRegularExpression kIterator("\\b(begin|end)\\(|operator|= default|= delete|\\boverride\\b");
    const QStringList lines = QString::fromUtf8(header).split('\n');
    QStringList found;
    struct Scope {
        bool declares;  ///< a namespace or class whose functions can be called
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
    void tableDetectsAForbiddenInclude() {
        const Folder* receive = folderOf("robot/receive/receiver.cpp");
        QVERIFY(receive != nullptr);
        QVERIFY(!isAllowed(*receive, "robot/control/controller.h"));
        QVERIFY(isAllowed(*receive, "robot/rtde/codec.h"));
        QVERIFY(!isAllowed(*folderOf("robot/simulator/simulator.cpp"), "robot/rtde/session.h"));
        QVERIFY(!isAllowed(*folderOf("widgets/jog/jog_column.cpp"), "robot/simulator/simulator.h"));
        for (const char* outside : {"robot/station/link/robot_session.cpp", "app/main.cpp",
                                    "robot/ur_rtde/detail/native_control.cpp",
                                    "robot/python/native_control.cpp", "robot/io/outputs.cpp"}) {
            QVERIFY2(!isAllowed(*folderOf(outside), "robot/control/detail/mailbox.h"), outside);
        }
        QVERIFY(isAllowed(*folderOf("robot/control/motions.cpp"), "robot/control/detail/mailbox.h"));
        QVERIFY(!isAllowed(*folderOf("robot/station/link/robot_session.cpp"),
                           "robot/station/history/signal_store.h"));
        QVERIFY(
            !isAllowed(*folderOf("widgets/io/io_tab.cpp"), "robot/station/link/detail/session_backend.h"));
        QVERIFY(isAllowed(*folderOf("robot/simulator/simulator.cpp"), "robot/simulator/arm/arm_state.h"));
        for (const char* upper :
             {"host/script_host.h", "programs/program_runner.h", "controller/controller_model.h",
              "servers/services.h", "servers/rtde/rtde_server.h", "simulator.h"}) {
            const QString header = QStringLiteral("robot/simulator/") + upper;
            QVERIFY2(!isAllowed(*folderOf("robot/simulator/plant/plant.cpp"), header), upper);
        }
        QVERIFY(!isAllowed(*folderOf("robot/simulator/programs/program_runner.cpp"),
                           "robot/simulator/host/script_host.h"));
        QVERIFY(!isAllowed(*folderOf("robot/simulator/servers/services.cpp"), "robot/simulator/faults.h"));
        QVERIFY(!isAllowed(*folderOf("robot/recording/recorder.cpp"), "robot/recording/mcap/reader.h"));
        QVERIFY(!isAllowed(*folderOf("robot/recording/mcap/reader.cpp"), "robot/recording/hdf5/episodes.h"));
        const Folder* station = folderOf("robot/station/station.cpp");
        QVERIFY(station != nullptr && isAllowed(*station, "robot/station/link/robot_session.h"));
        QVERIFY(!isAllowed(*station, "robot/control/controller.h"));
        QVERIFY(!isAllowed(*folderOf("robot/station/route/route_runner.cpp"), "robot/station/station.h"));
        QVERIFY(folderOf("robot/station/new_folder/x.h") == nullptr);
        QVERIFY(folderOf("widgets/new_folder/x.h") == nullptr);
    }

    void everyFolderHasARow() {
        QSet<QString> without;
        for (const QString& file : sourceFiles()) {
            const QString folder = file.section('/', 0, -2).section("/detail", 0, 0);
            const Folder* row = folderOf(file);
            if (!file.startsWith("tests/") && (row == nullptr || folder != QLatin1String(row->path))) {
                without.insert(folder);
            }
        }
        const QSet<QString> parts(kParts.begin(), kParts.end());
        QVERIFY2(
            without == parts,
            qPrintable("without a row: " + QStringList((without - parts).values()).join(' ') +
                       "; with a row, or removed: " + QStringList((parts - without).values()).join(' ')));
    }

    void rowsPermitOnlyRowsAbove() {
        for (const Folder& folder : folders()) {
            for (const QString& allowed : folder.mayInclude) {
                const Folder* row = folderOf(allowed + '/');
                QVERIFY2(row == nullptr || row <= &folder,
                         qPrintable(folder.path + (" includes " + allowed)));
            }
        }
    }

    void includesFollowTheArchitecture() {
        static const QRegularExpression include(QStringLiteral("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"),
                                                QRegularExpression::MultilineOption);
        QStringList violations;
        int includes = 0;
        for (const QString& file : sourceFiles()) {
            const Folder* folder = folderOf(file);
            if (folder == nullptr) {
                continue;  // tests may include all headers
            }
            auto it = include.globalMatch(QString::fromUtf8(contentsOf(file)));
            while (it.hasNext()) {
                const QString included = it.next().captured(1);
                ++includes;
                if (folderOf(included) != nullptr && !isAllowed(*folder, included)) {
                    violations << file + " includes " + included;
                }
                for (const QString& prefix : folder->forbiddenQt) {
                    if (included.startsWith(prefix)) {
                        violations << file + " includes " + included;
                    }
                }
            }
        }
        QVERIFY2(includes > 100, "no include lines found: check TILLER_SOURCE_DIR");
        QVERIFY2(violations.isEmpty(), qPrintable(violations.join('\n')));
    }

    // Logic without a display belongs in robot/station, where tiller-cli and tests in virtual time can use
    // it.
    void widgetsNeedADisplay() {
        QVERIFY(isOfDisplay("QWidget") && isOfDisplay("QUndoStack"));
        QVERIFY(!isOfDisplay("QObject") && !isOfDisplay("QTcpSocket"));
        QSet<QString> found;
        int units = 0;
        for (const QString& file : sourceFiles()) {
            if (file.startsWith("widgets/")) {
                ++units;
                QSet<QString> seen;
                if (!needsDisplay(unitOf(file), seen)) {
                    found.insert(unitOf(file));
                }
            }
        }
        QVERIFY(units > 100);
        const QStringList table = withoutDisplay().keys();
        const QSet<QString> expected(table.begin(), table.end());
        QVERIFY2(
            found == expected,
            qPrintable("not in the table: " + QStringList((found - expected).values()).join(' ') +
                       "; unnecessary in the table: " + QStringList((expected - found).values()).join(' ')));
    }

    // Headers in detail/ are not installed, so a public header that includes one would not compile for a
    // user.
    void publicHeadersDoNotIncludeDetails() {
        QStringList violations;
        int headers = 0;
        for (const QString& file : sourceFiles()) {
            if (!file.startsWith("robot/") || !file.endsWith(".h") || isDetail(file) ||
                file.startsWith("robot/ur_rtde/custom/")) {  // these are not installed either
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

    void checkerReportsUndocumentedFunctions() {
        const QByteArray header =
            "namespace a {\nclass B {\npublic:\n    Result<int> f() const;  ///< [mm]\n"
            "    Result<int> g() const;\n    int value() const;\nprivate:\n    Result<int> h();\n};\n"
            "/// Documented.\nResult<int> i();\nResult<int> j();\n}\n";
        QCOMPARE(functionsWithoutComment(header),
                 (QStringList{"5: Result<int> g() const;", "12: Result<int> j();"}));
    }

    void publicFunctionsThatCanFailAreDocumented() {
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

    // The default of Qt Test, five seconds, is too short for a busy machine.
    void waitingTestsSpecifyTheirTimeout() {
        static const QRegularExpression withoutTimeout(QStringLiteral("\\bQTRY_(VERIFY|VERIFY2|COMPARE)\\("));
        QStringList found;
        for (const QString& file : sourceFiles()) {
            if (file.startsWith("tests/") && withoutTimeout.match(contentsOf(file)).hasMatch()) {
                found << file;
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
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
