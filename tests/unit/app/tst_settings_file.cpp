// SPDX-License-Identifier: GPL-3.0-or-later
//
// The settings file. Its content is restored unchanged; a damaged file is refused with an error message and
// changes nothing.

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "app/settings.h"

using namespace tiller;
using namespace tiller::app;

namespace {

SettingsBundle example() {
    SettingsBundle bundle;
    bundle.writtenBy = "1.2";
    bundle.values = {{"look/theme", "dark"},
                     {"motion/longestHold", 30},
                     {"motion/speedCap", 0.125},
                     {"devices/gamepad/dominantAxis", true},
                     {"shortcuts/app.help", ""},
                     {"robots/size", 1},
                     {"robots/1/host", "192.168.0.10"},
                     {"robots/1/name", QString::fromUtf8("Zelle \"vorn\" \U0001F916")},
                     {"robots/1/portOffset", 0},
                     {"io/DO 0", "gripper, left"},
                     {"io/AI 0 scale", "0|10|bar"},
                     {"window/state", QByteArray("\x00\xff\x80 state", 9)},
                     {"window/version", 1},
                     {"other/list", QStringList{"a", "b, c"}}};
    return bundle;
}

QByteArray withValues(const QByteArray& values) {
    return R"({"format": "tiller-settings", "version": 1, "values": )" + values + "}";
}

QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Conditions that hold for all accepted bundles.
void checkAccepted(const SettingsBundle& bundle) {
    for (auto it = bundle.values.constBegin(); it != bundle.values.constEnd(); ++it) {
        QVERIFY2(!it.key().isEmpty() && it.key().size() <= 200, qPrintable(it.key()));
        QVERIFY2(travels(it.key()), qPrintable(it.key()));
        const int type = it.value().typeId();
        QVERIFY2(type == QMetaType::Bool || type == QMetaType::Int || type == QMetaType::Double ||
                     type == QMetaType::QString || type == QMetaType::QStringList ||
                     type == QMetaType::QByteArray,
                 it.value().typeName());
    }
}

}  // namespace

class TestSettingsFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void roundTripPreservesAllSettings() {
        const SettingsBundle bundle = example();
        const Result<SettingsBundle> read = settingsFromJson(settingsToJson(bundle));
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QCOMPARE(read->writtenBy, bundle.writtenBy);
        QCOMPARE(read->values.keys(), bundle.values.keys());
        for (auto it = bundle.values.constBegin(); it != bundle.values.constEnd(); ++it) {
            QVERIFY2(read->values.value(it.key()) == it.value(), qPrintable(it.key()));
        }
        for (const SettingsPart part : kSettingsParts) {
            QVERIFY(read->hasSameValues(bundle, part));
        }
    }

    void settingsFileRoundTrip() {
        QTemporaryDir folder;
        const QString path = folder.filePath("cell.json");
        QVERIFY(writeSettingsFile(path, example()).ok());
        const Result<SettingsBundle> read = readSettingsFile(path);
        QVERIFY(read.ok());
        QCOMPARE(read->values.size(), example().values.size());
        QCOMPARE(readSettingsFile(folder.filePath("none.json")).error().code, ErrorCode::FileNotReadable);
        QCOMPARE(writeSettingsFile(folder.filePath("no/folder.json"), example()).error().code,
                 ErrorCode::FileNotWritable);
    }

    void machineSpecificSettingsAreNotExported() {
        SettingsBundle bundle = example();
        bundle.values["projects/recent"] = QStringList{"/home/somebody/cell.tiller"};
        bundle.values["window/geometry"] = QByteArray("geometry");
        const Result<SettingsBundle> read = settingsFromJson(settingsToJson(bundle));
        QVERIFY(read.ok());
        QCOMPARE(read->values.size(), example().values.size());
    }

    void fileOfANewerVersionIsRefusedWithASolution() {
        QByteArray bytes = settingsToJson(example());
        bytes.replace("\"version\": 1", "\"version\": 2");
        const Result<SettingsBundle> read = settingsFromJson(bytes);
        QCOMPARE(read.error().code, ErrorCode::VersionUnsupported);
        QVERIFY2(read.error().context.contains("Update Tiller"), qPrintable(read.error().context));
    }

    void brokenFilesAreRefusedWithAReason_data() {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* name, const QByteArray& bytes) { QTest::newRow(name) << bytes; };
        row("empty", {});
        row("no JSON", "look/theme=dark");
        row("zeros", QByteArray(100, '\0'));
        row("a list", "[]");
        row("a project", R"({"format": "tiller-project", "version": 1})");
        row("no version", R"({"format": "tiller-settings", "values": {}})");
        row("version zero", R"({"format": "tiller-settings", "version": 0, "values": {}})");
        row("version as text", R"({"format": "tiller-settings", "version": "1", "values": {}})");
        row("no values", R"({"format": "tiller-settings", "version": 1})");
        row("values are a list", withValues("[]"));
        row("no key", withValues(R"({"": 1})"));
        row("a key of groups only",
            withValues("{\"a//b\": 1}"));  // not a raw string, because moc would detect a comment in it
        row("a key that begins with a group", withValues(R"({"/a": 1})"));
        row("a key that ends with a group", withValues(R"({"a/": 1})"));
        row("a key with a line break", withValues(R"({"a\nb": 1})"));
        row("a long key", withValues("{\"" + QByteArray(300, 'a') + "\": 1}"));
        row("null", withValues(R"({"look/theme": null})"));
        row("an object", withValues(R"({"look/theme": {"a": 1}})"));
        row("bytes and more", withValues(R"({"window/state": {"base64": "AAAA", "a": 1}})"));
        row("bytes that are none", withValues(R"({"window/state": {"base64": "*"}})"));
        row("bytes as a number", withValues(R"({"window/state": {"base64": 1}})"));
        row("a list of numbers", withValues(R"({"a": [1, 2]})"));
        row("a list of lists", withValues(R"({"a": [["b"]]})"));
        row("a number beyond all", withValues(R"({"a": 1e999})"));
        row("a long text", withValues("{\"a\": \"" + QByteArray(70'000, 'a') + "\"}"));
        row("a long list", withValues("{\"a\": [\"" + QByteArray(40'000, 'a') + "\", \"" +
                                      QByteArray(40'000, 'b') + "\"]}"));
        row("deep", QByteArray(5000, '[') + QByteArray(5000, ']'));
        row("large", QByteArray(5 * 1024 * 1024, ' '));
        QByteArray many = "{";
        for (int i = 0; i < 6000; ++i) {
            many += (i == 0 ? "\"k" : ", \"k") + QByteArray::number(i) + "\": 1";
        }
        row("many", withValues(many + "}"));
    }
    void brokenFilesAreRefusedWithAReason() {
        QFETCH(QByteArray, bytes);
        const Result<SettingsBundle> read = settingsFromJson(bytes);
        QCOMPARE(read.error().code, ErrorCode::FileCorrupt);
        QVERIFY2(read.error().context.size() > 10, "the error does not describe the problem");
    }

    void everyTruncatedFileIsRefused() {
        const QByteArray whole = settingsToJson(example()).trimmed();
        for (qsizetype length = 0; length < whole.size(); ++length) {
            const Result<SettingsBundle> read = settingsFromJson(whole.left(length));
            QVERIFY2(!read.ok(), qPrintable(QString::number(length)));
        }
    }

    void arbitraryBytesAreRefusedOrValid() {
        const QByteArray whole = settingsToJson(example());
        const QByteArrayList words = {"\"",   "{",    "}",     "[",          "]",       ":",
                                      ",",    "null", "1e308", "-1",         "\\u0000", "\\ud800",
                                      "true", "//",   "0.5",   "\"base64\"", "\xff",    "version"};
        QRandomGenerator random(20261123);
        int accepted = 0;
        for (int round = 0; round < 5000; ++round) {
            QByteArray bytes = whole;
            const int changes = 1 + static_cast<int>(random.bounded(4));
            for (int i = 0; i < changes; ++i) {
                const qsizetype at = random.bounded(static_cast<int>(bytes.size()));
                switch (random.bounded(4)) {
                    case 0:
                        bytes[at] = static_cast<char>(random.bounded(256));
                        break;
                    case 1:
                        bytes.remove(at, random.bounded(20));
                        break;
                    case 2:
                        bytes.insert(at, words.at(random.bounded(static_cast<int>(words.size()))));
                        break;
                    default:
                        bytes.insert(at, bytes.mid(random.bounded(static_cast<int>(bytes.size())),
                                                   random.bounded(60)));
                        break;
                }
            }
            const Result<SettingsBundle> read = settingsFromJson(bytes);
            if (read.ok()) {
                ++accepted;
                checkAccepted(*read);
                // Accepted content can be written and read again.
                QVERIFY(settingsFromJson(settingsToJson(*read)).ok());
            } else {
                QVERIFY(!read.error().context.isEmpty());
            }
            if (QTest::currentTestFailed()) {
                qDebug().noquote() << "round" << round << bytes;
                return;
            }
        }
        QVERIFY2(accepted > 0 && accepted < 5000, "the changes were all accepted or all refused");
    }

    void importReplacesWholeSectionsAndKeepsACopy() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        Settings settings(file);
        settings.setTheme("light");
        settings.rememberRobot({"old", "10.0.0.1", 0, false});
        settings.rememberRobot({"older", "10.0.0.2", 0, false});
        settings.setIoNames({{"DI 7", "door"}});
        settings.rememberProject(folder.filePath("cell.tiller"));

        const Result<QString> backup =
            settings.replace(example(), {SettingsPart::Look, SettingsPart::Robots, SettingsPart::Other});
        QVERIFY2(backup.ok(), qPrintable(backup.error().toString()));
        const Settings again(file);
        QCOMPARE(again.theme(), QString("dark"));
        QCOMPARE(again.rememberedRobots().size(), 1);
        QCOMPARE(again.rememberedRobots().first().host, QString("192.168.0.10"));
        QCOMPARE(again.ioNames(), (QMap<QString, QString>{{"DI 7", "door"}}));  // not selected
        QCOMPARE(again.recentProjects(), QStringList{folder.filePath("cell.tiller")});

        const Result<SettingsBundle> before = readSettingsFile(*backup);
        QVERIFY(before.ok());
        QCOMPARE(before->values.value("look/theme").toString(), QString("light"));
        QCOMPARE(before->values.value("robots/size").toInt(), 2);
        // The backup restores the previous settings.
        QVERIFY(settings.replace(*before, {SettingsPart::Look, SettingsPart::Robots}).ok());
        QCOMPARE(Settings(file).rememberedRobots().size(), 2);
        QCOMPARE(Settings(file).theme(), QString("light"));
    }

    void withoutACopyNothingIsReplaced() {
        QTemporaryDir folder;
        // There is a file instead of the folder, so neither the backup nor the settings can be written.
        QFile obstacle(folder.filePath("place"));
        QVERIFY(obstacle.open(QIODevice::WriteOnly));
        obstacle.close();
        Settings settings(folder.filePath("place/settings.ini"));
        const Result<QString> backup = settings.replace(example(), {SettingsPart::Look});
        QCOMPARE(backup.error().code, ErrorCode::FileNotWritable);
        QVERIFY(settings.theme().isEmpty());
    }

    void invalidPortsAndEndlessNamesAreRefused() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        Settings settings(file);
        SettingsBundle hostile = example();
        hostile.values["robots/1/portOffset"] = 1'000'000;
        hostile.values["io/DO 0"] = QString(60'000, u'x');
        hostile.values["motion/speedCap"] = 5;
        hostile.values["shortcuts/app.help"] = "Space";
        QVERIFY(settings
                    .replace(hostile, {SettingsPart::Robots, SettingsPart::IoNames, SettingsPart::Motion,
                                       SettingsPart::Keys})
                    .ok());
        QVERIFY(settings.rememberedRobots().isEmpty());
        QVERIFY(settings.ioNames().value("DO 0").size() <= 100);
        QVERIFY(settings.preferences().speedCap <= Preferences::kOrdinaryCap);
        QVERIFY(settings.preferences().shortcuts.isEmpty());
    }

    void exportedSettingsWorkOnAnotherComputer() {
        QTemporaryDir folder;
        Settings here(folder.filePath("here.ini"));
        here.setTheme("dark");
        here.rememberRobot({"Lab UR5e", "10.0.0.7", 0, false});
        here.setIoNames({{"DO 0", "gripper, left"}, {"AI 0 scale", "0|10|bar"}});
        here.setWindowGeometry("geometry");
        here.setPerspectives({{1, "Night", "log", QByteArray("\x00state", 6)}});
        here.setGripper("10.0.0.7", "hand-e");
        Preferences chosen;
        chosen.density = Density::Touch;
        chosen.longestHold = 40;
        chosen.shortcuts["app.help"] = QKeySequence(Qt::CTRL | Qt::Key_H);
        chosen.devices[kGamepadKind] = DeviceTuning{0.2, 2.0, true};
        here.setPreferences(chosen);
        const QString path = folder.filePath("cell.json");
        QVERIFY(writeSettingsFile(path, here.bundle()).ok());

        Settings there(folder.filePath("there.ini"));
        const Result<SettingsBundle> read = readSettingsFile(path);
        QVERIFY(read.ok());
        QVERIFY(there.replace(*read, QSet<SettingsPart>(std::begin(kSettingsParts), std::end(kSettingsParts)))
                    .ok());
        const Settings next(folder.filePath("there.ini"));
        QCOMPARE(next.theme(), QString("dark"));
        QCOMPARE(next.rememberedRobots().first().name, QString("Lab UR5e"));
        QCOMPARE(next.ioNames(), here.ioNames());
        QCOMPARE(next.perspectives(), here.perspectives());
        QCOMPARE(next.gripper("10.0.0.7"), QString("hand-e"));
        QVERIFY(next.windowGeometry().isEmpty());
        QVERIFY(next.preferences() == chosen);
    }

    void brokenFilesDoNotChangeTheSettings() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        {
            Settings settings(file);
            settings.setTheme("dark");
        }
        const QByteArray before = content(file);
        QVERIFY(!before.isEmpty());
        const QString path = folder.filePath("broken.json");
        QFile broken(path);
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write(settingsToJson(example()).left(200));
        broken.close();
        QVERIFY(!readSettingsFile(path).ok());
        QCOMPARE(content(file), before);
        QCOMPARE(QDir(folder.path()).entryList({"settings-before*"}).size(), 0);
    }
};

QTEST_MAIN(TestSettingsFile)
#include "tst_settings_file.moc"
