// SPDX-License-Identifier: GPL-3.0-or-later
//
// The settings file: the format of QSettings, several windows, full disks.

#include <QFile>
#include <QRandomGenerator>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/settings.h"
#include "tests/support/small_disk.h"

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace tiller;
using namespace tiller::app;

namespace {

SettingsMap difficult() {
    QByteArray bytes;
    for (int i = 0; i < 256; ++i) {
        bytes.append(static_cast<char>(i));
    }
    return {{"plain", "word"},
            {"look/theme", "dark"},
            {"General/inside", "1"},
            {"io/DO 0", "gripper, left; \"A\" \\ 'x' = 5 % #"},
            {"io/Größe ∆ 🤖", QString::fromUtf8("Zelle \"vorn\" ∆ \U0001F916")},
            {"a/b/c/d", QString("line 1\nline 2\ttab\r\x01"
                                "1f")},
            {"a/at", "@Invalid() is text"},
            {"a/at2", "@@two"},
            {"a/space", "  spaces  "},
            {"a/empty", ""},
            {"a/bytes", bytes},
            {"a/noBytes", QByteArray("")},
            {"a/list", QStringList{"a", "b, c", "", "@d", " e "}},
            {"a/yes", true},
            {"a/number", 42},
            {"a/real", 0.125}};
}

QStringList texts(const QVariant& value) {
    return value.typeId() == QMetaType::QByteArray
               ? QStringList(QString::fromLatin1(value.toByteArray().toHex()))
           : value.typeId() == QMetaType::QStringList ? value.toStringList()
                                                      : QStringList(value.toString());
}

}  // namespace

class TestSettingsStore : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        directory_ = std::make_unique<QTemporaryDir>();
        file_ = directory_->filePath("settings.ini");
    }

    void writtenValuesAreAlsoReadByQSettings() {
        const SettingsMap values = difficult();
        const SettingsMap read = settingsFromIni(settingsToIni(values));
        QCOMPARE(read.keys(), values.keys());
        for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
            QVERIFY2(texts(read[it.key()]) == texts(*it), qPrintable(it.key()));
        }
        {
            SettingsEdit edit(file_);
            for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
                edit.setValue(it.key(), *it);
            }
            QVERIFY(edit.commit().ok());
        }
        const QSettings qt(file_, QSettings::IniFormat);
        for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
            QVERIFY2(texts(qt.value(it.key())) == texts(*it), qPrintable(it.key()));
        }
    }

    void filesOfEarlierVersionsAreRead() {
        const SettingsMap values = difficult();
        {
            QSettings qt(file_, QSettings::IniFormat);
            for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
                qt.setValue(it.key(), *it);
            }
        }
        const SettingsView view(file_);
        QCOMPARE(view.values().keys(), values.keys());
        for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
            QVERIFY2(texts(view.value(it.key())) == texts(*it), qPrintable(it.key()));
        }
        QVERIFY(view.childKeys("a").contains("list"));
        QVERIFY(!view.childKeys("a").contains("b/c/d"));
    }

    void brokenTextIsSkipped() {
        QRandomGenerator random(7);
        const QByteArray whole = settingsToIni(difficult());
        for (int i = 0; i < 2000; ++i) {
            QByteArray text = whole;
            for (int j = 0; j < 5; ++j) {
                text[random.bounded(static_cast<int>(text.size()))] = static_cast<char>(random.bounded(256));
            }
            (void)settingsFromIni(text.left(random.bounded(static_cast<int>(text.size()))));
        }
        QCOMPARE(settingsFromIni("nonsense\n[x]\n=1\na=2\n[\nb\n").size(), 1);
    }

    void twoWindowsKeepEachOthersEntries() {
        Settings first(file_);
        Settings second(file_);
        Preferences ours = first.preferences();
        Preferences theirs = second.preferences();
        (void)first.ioNames();
        (void)second.ioNames();
        (void)first.perspectives();
        (void)second.perspectives();
        (void)first.learned();
        (void)second.learned();

        first.rememberRobot({"A", "10.0.0.1", 0, false});
        second.rememberRobot({"B", "10.0.0.2", 0, false});
        QCOMPARE(first.rememberedRobots().size(), 2);
        ours.longestHold = 30;
        first.setPreferences(ours);
        theirs.density = Density::Touch;
        theirs.shortcuts["app.help"] = QKeySequence("F2");
        second.setPreferences(theirs);
        QCOMPARE(Settings(file_).preferences().longestHold, 30);
        QVERIFY(Settings(file_).preferences().density == Density::Touch);
        QVERIFY(Settings(file_).preferences().shortcuts.contains("app.help"));
        first.setIoNames({{"DO 0", "gripper"}});
        second.setIoNames({{"DO 1", "lamp"}});
        QCOMPARE(first.ioNames().size(), 2);
        second.setIoNames({});
        QCOMPARE(Settings(file_).ioNames().keys(), QStringList{"DO 0"});
        first.setPerspectives({{1, "Mine", "io", "panels"}});
        const auto both = second.setPerspectives({{1, "Yours", "io", "panels"}});
        QCOMPARE(both.size(), 2);
        QCOMPARE(both[0].name, QString("Mine"));
        QCOMPARE(both[1].name, QString("Yours"));
        QVERIFY(both[0].number != both[1].number);
        QCOMPARE(Settings(file_).perspectives().size(), 2);
        first.setPerspectives({});  // removes only the entry of this window
        QCOMPARE(Settings(file_).perspectives().size(), 1);
        first.setTutorialProgress({false, {"jog"}, {}});
        second.setTutorialProgress({true, {"teach"}, {"pick"}});
        const TutorialProgress learned = Settings(file_).learned();
        QVERIFY(learned.dismissed);
        QCOMPARE(learned.firstSteps, (QStringList{"jog", "teach"}));
        first.rememberProject("/a.tiller");
        second.rememberProject("/b.tiller");
        QCOMPARE(first.recentProjects(), (QStringList{"/b.tiller", "/a.tiller"}));
    }

    void fullDiskKeepsTheSettingsWithAMessage() {
        const SmallDisk disk(SmallDisk::Kind::Tmpfs, 256);
        if (!disk.problem().isEmpty()) {
            QSKIP(qPrintable(disk.problem()));
        }
        const QString file = disk.filePath("settings.ini");
        Settings settings(file);
        settings.setTheme("dark");
        QVERIFY(disk.fill());
        QVector<Error> failures;
        settings.setWriteFailed([&failures](const Error& error) { failures.append(error); });
        settings.setTheme("light");
        settings.rememberRobot({"A", "10.0.0.1", 0, false});
        QCOMPARE(failures.size(), 1);
        QVERIFY(failures[0].code == ErrorCode::DiskFull);
        QCOMPARE(Settings(file).theme(), QString("dark"));
        disk.fitToContents();
        settings.setTheme("light");
        QCOMPARE(Settings(file).theme(), QString("light"));
    }

#ifdef Q_OS_UNIX
    void pipeAsSettingsFileDoesNotBlock() {
        QVERIFY(::mkfifo(file_.toLocal8Bit().constData(), 0600) == 0);
        Settings settings(file_);
        QCOMPARE(settings.theme(), QString());
        int failures = 0;
        settings.setWriteFailed([&failures](const Error&) { ++failures; });
        settings.setTheme("dark");
        QCOMPARE(failures, 1);
        QVERIFY(readSettingsFile(file_).error().code == ErrorCode::FileNotReadable);
    }
#endif

private:
    std::unique_ptr<QTemporaryDir> directory_;
    QString file_;
};

QTEST_MAIN(TestSettingsStore)
#include "tst_settings_store.moc"
