// SPDX-License-Identifier: MIT
// Generates the table in robot/ur_rtde/METHODS.md with every method of the interface and the tests that check
// its effect. Run with TILLER_UPDATE_TABLES=1 to write the file.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace {

const QString kSource = QStringLiteral(TILLER_SOURCE_DIR "/");
const char* const kTable = "robot/ur_rtde/METHODS.md";
const char* const kFrom = "robot/ur_rtde/FROM_UR_RTDE.md";

QString contentsOf(const QString& path) {
    QFile file(kSource + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

struct Method {
    QString owner;
    QString name;
};

QList<Method> methodsIn(const QString& path) {
    QList<Method> methods;
    for (const QString& line : contentsOf(path).split('\n')) {
        const QStringList words = line.split(' ');
        if (words.size() == 2 && !line.startsWith('#')) {
            methods << Method{words[0], words[1]};
        }
    }
    return methods;
}

/// The entry for a method on the page "From ur_rtde to Tiller".
struct Counterpart {
    QString difference;
    QString inTiller;
};

/// Entries by "class method". The page has a section per class and a row for one or more methods.
QHash<QString, Counterpart> counterparts() {
    static const QRegularExpression kName(QStringLiteral("`(\\w+)`"));
    QHash<QString, Counterpart> all;
    QStringList owners;
    for (const QString& line : contentsOf(kFrom).split('\n')) {
        if (line.startsWith("## ")) {
            owners = line.mid(3).split(", ");
        }
        const QStringList cells = line.split(" | ");
        if (!line.startsWith("| `") || cells.size() != 3) {
            continue;
        }
        for (auto names = kName.globalMatch(cells[0]); names.hasNext();) {
            const QString name = names.next().captured(1);
            for (const QString& owner : owners) {
                all.insert(owner + ' ' + name, {cells[1].trimmed(), cells[2].chopped(2).trimmed()});
            }
        }
    }
    return all;
}

/// Returns the declarations of a method in its class, each on one line.
QString signaturesOf(const Method& method, const QString& headers) {
    const qsizetype begin =
        headers.indexOf(QRegularExpression("\\b(?:class|struct) (?:\\w+ )?" + method.owner + "\\b[^;]*\\{"));
    const QString body = headers.mid(begin, headers.indexOf("\n};", begin) - begin);
    const QRegularExpression declaration("^    (?:static |virtual |RTDE_EXPORT )*([^\\n/]*\\b" + method.name +
                                             "\\((?:[^()]|\\([^()]*\\))*\\)(?: const)?)",
                                         QRegularExpression::MultilineOption);
    QStringList found;
    for (auto it = declaration.globalMatch(body); it.hasNext();) {
        found << '`' + it.next().captured(1).simplified().replace('|', "\\|") + '`';
    }
    return begin < 0 ? QString() : found.join("<br>");
}

/// A test function and its text.
struct TestFunction {
    QString where;
    QString text;
};

QList<TestFunction> functionsIn(const QString& folder, const QString& pattern,
                                const QRegularExpression& begin) {
    QList<TestFunction> functions;
    QStringList files = QDir(kSource + folder).entryList({pattern}, QDir::Files, QDir::Name);
    for (const QString& file : files) {
        const QString text = contentsOf(folder + '/' + file);
        QList<QPair<QString, qsizetype>> starts;
        auto matches = begin.globalMatch(text);
        while (matches.hasNext()) {
            const auto match = matches.next();
            starts.append({match.captured(1), match.capturedStart()});
        }
        for (qsizetype i = 0; i < starts.size(); ++i) {
            const qsizetype end = i + 1 < starts.size() ? starts[i + 1].second : text.size();
            functions << TestFunction{QFileInfo(file).baseName() + "::" + starts[i].first,
                                      text.mid(starts[i].second, end - starts[i].second)};
        }
    }
    return functions;
}

/// Syntax of the tests in one language.
struct Language {
    QHash<QString, QString> objects;  ///< names of the objects of each class
    QRegularExpression assertion;
    /// Functions that only set up a test or check refused calls. They do not test effects.
    QRegularExpression sideShow;
};

/// Returns the first test that calls the method and checks its effect. An assertion must be on the line of
/// the call, just before it or within kSoon lines after it.
QString exercised(const Method& method, const QList<TestFunction>& functions, const Language& language) {
    constexpr qsizetype kSoon = 8;  // [lines]
    const QRegularExpression call(language.objects.value(method.owner) +
                                  QRegularExpression::escape(method.name) + "\\b(?=\\(|,|\\))");
    for (const TestFunction& function : functions) {
        if (language.sideShow.match(function.where).hasMatch()) {
            continue;
        }
        const QStringList lines = function.text.split('\n');
        for (qsizetype i = 0; i < lines.size(); ++i) {
            if (!call.match(lines[i]).hasMatch()) {
                continue;
            }
            const QString after = lines.mid(std::max<qsizetype>(i - 1, 0), kSoon + 2).join('\n');
            if (language.assertion.match(after).hasMatch()) {
                return function.where;
            }
        }
    }
    return {};
}

}  // namespace

class TestUrRtdeTable : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // All names on the page must exist.
    void thePageListsOnlyExistingMethods() {
        QSet<QString> known;
        for (const Method& method : methodsIn("tests/data/ur_rtde/methods.txt")) {
            known.insert(method.owner + ' ' + method.name);
        }
        const QHash<QString, Counterpart> from = counterparts();
        QVERIFY(from.size() > 200);
        QStringList strangers;
        for (auto it = from.cbegin(); it != from.cend(); ++it) {
            // A section for two classes contains methods that only one of the classes has.
            const bool shared = it.key().startsWith("Path ") || it.key().startsWith("PathEntry ");
            if (!known.contains(it.key()) && !shared) {
                strangers << it.key();
            }
        }
        QVERIFY2(strangers.isEmpty(), qPrintable(strangers.join('\n')));
    }

    void everyMethodIsDeclaredAndExercised() {
        // Names of the objects in the tests of each language.
        static const Language cpp{
            {{"RTDEControlInterface", "(?:control_->|control\\.|second\\.)"},
             {"RTDEReceiveInterface", "(?:receive_->|receive\\.|upper\\.|registers\\.)"},
             {"RTDEIOInterface", "(?:\\bio\\.|upper\\.|lower\\.)"},
             {"DashboardClient", "dashboard\\."},
             {"ScriptClient", "(?:client|old|recent)\\."},
             {"RobotiqGripper", "gripper\\."},
             {"RTDEUtility", "RTDEUtility::"},
             {"Path", "path\\."},
             {"PathEntry", "\\[\\d\\]\\."}},
            QRegularExpression("QVERIFY|QCOMPARE|QTRY_"),
            QRegularExpression("Nobody|wrongArguments|Throw")};
        static const Language python{
            {{"RTDEControlInterface", "(?:control|self\\.control)\\."},
             {"RTDEReceiveInterface", "receive\\."},
             {"RTDEIOInterface", "\\bio\\."},
             {"DashboardClient", "dashboard\\."},
             {"ScriptClient", "client\\."},
             {"RobotiqGripper", "gripper\\."},
             {"Path", "path\\."},
             {"PathEntry", "\\[\\d\\]\\."},
             {"AsyncOperationStatus", "(?:status|AsyncOperationStatus\\(\\w*\\))\\."}},
            QRegularExpression("self\\.assert"),
            QRegularExpression("setUp|tearDown|test_types")};
        const auto cppTests =
            functionsIn("tests/integration/ur_rtde", "tst_ur_rtde_*.cpp",
                        QRegularExpression("^    void (\\w+)\\(\\)", QRegularExpression::MultilineOption));
        const auto pythonTests =
            functionsIn("tests/python", "test_*.py",
                        QRegularExpression("^    def (\\w+)\\(", QRegularExpression::MultilineOption));
        QVERIFY(cppTests.size() > 20);
        QVERIFY(pythonTests.size() > 10);

        QString headers;
        for (const QString& file : QDir(kSource + "robot/ur_rtde").entryList({"*.h"})) {
            headers += contentsOf("robot/ur_rtde/" + file);
        }
        const auto pythonMethods = methodsIn("tests/data/ur_rtde/python.txt");
        QStringList missing;
        QString table =
            "# Methods of the ur_rtde compatibility layer\n\n"
            "Generated by tests/integration/ur_rtde/tst_ur_rtde_table (TILLER_UPDATE_TABLES=1 updates the "
            "file): every method of ur_rtde 1.5.8 as declared in this folder, the difference from ur_rtde (a "
            "dash: none), and the tests that check the method with the simulated controller. For the "
            "corresponding calls of the library, see [From ur_rtde to Tiller](FROM_UR_RTDE.md).\n\n"
            "| class | method | difference | C++ test | Python test |\n|---|---|---|---|---|\n";
        const QHash<QString, Counterpart> from = counterparts();
        const auto methods = methodsIn("tests/data/ur_rtde/methods.txt");
        QVERIFY(methods.size() > 200);
        for (const Method& method : methods) {
            if (!headers.contains(QRegularExpression("[ &*]" + method.name + "\\("))) {
                missing << method.owner + "::" + method.name + " is not declared";
            }
            const QString inCpp = exercised(method, cppTests, cpp);
            if (inCpp.isEmpty()) {
                missing << method.owner + "::" + method.name + " is not looked at in C++";
            }
            const bool exposed =
                method.owner == "RobotiqGripper" ||
                std::any_of(pythonMethods.begin(), pythonMethods.end(), [&](const Method& m) {
                    return m.owner == method.owner && m.name == method.name;
                });
            const QString inPython = exposed ? exercised(method, pythonTests, python) : QString();
            if (exposed && inPython.isEmpty()) {
                missing << method.owner + "." + method.name + " is not looked at in Python";
            }
            const QString signatures = signaturesOf(method, headers);
            if (signatures.isEmpty()) {
                missing << method.owner + "::" + method.name + " has no signature";
            }
            const Counterpart counterpart = from.value(method.owner + ' ' + method.name);
            if (counterpart.difference.isEmpty() || counterpart.inTiller.isEmpty()) {
                missing << method.owner + "::" + method.name + " has no row in " + kFrom;
            }
            table += QStringLiteral("| %1 | %2 | %3 | %4 | %5 |\n")
                         .arg(method.owner, signatures, counterpart.difference, inCpp,
                              exposed ? inPython : QStringLiteral("not exposed"));
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join('\n')));
        if (qEnvironmentVariableIsSet("TILLER_UPDATE_TABLES")) {
            QFile file(kSource + kTable);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(table.toUtf8());
        }
        QVERIFY2(contentsOf(kTable) == table, "the table is not up to date: run with TILLER_UPDATE_TABLES=1");
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeTable)
#include "tst_ur_rtde_table.moc"
