// SPDX-License-Identifier: GPL-3.0-or-later
//
// The languages of the window. All texts are translated with the same placeholders. Display and input use the
// decimal separator of the language, and files never do. Another language is selected in the settings and
// used when the window is opened again.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMap>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "app/language.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "robot/station/text/format.h"
#include "tests/support/pseudo_translator.h"
#include "tests/support/window_bench.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/theme.h"

using namespace tiller;
using namespace tiller::app;
using namespace tiller::test;

namespace {

const QString kFolder = QStringLiteral(TILLER_SOURCE_DIR "/translations/");

struct Text {
    bool finished = false;
    bool plural = false;
    QStringList translations;  ///< one translation, or one per plural form
};

/// Texts by context and source text.
using Texts = QMap<QString, Text>;

Text readMessage(QXmlStreamReader& xml, QString& source) {
    Text text;
    text.plural = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    QString comment;
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText();
        } else if (xml.name() == QLatin1String("comment")) {
            comment = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            text.finished = xml.attributes().value(QLatin1String("type")).isEmpty();
            if (!text.plural) {
                text.translations << xml.readElementText();
                continue;
            }
            while (xml.readNextStartElement()) {
                text.translations << xml.readElementText();
            }
        } else {
            xml.skipCurrentElement();
        }
    }
    source += comment.isEmpty() ? QString() : QStringLiteral(" // ") + comment;
    return text;
}

Texts readTexts(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        qFatal("cannot read %s", qPrintable(path));
    }
    Texts texts;
    QXmlStreamReader xml(&file);
    xml.readNextStartElement();
    while (xml.readNextStartElement()) {
        QString context;
        while (xml.readNextStartElement()) {
            if (xml.name() == QLatin1String("name")) {
                context = xml.readElementText();
            } else if (xml.name() == QLatin1String("message")) {
                QString source;
                const Text text = readMessage(xml, source);
                texts.insert(context + QStringLiteral(": ") + source, text);
            } else {
                xml.skipCurrentElement();
            }
        }
    }
    if (xml.hasError()) {
        qFatal("%s: %s", qPrintable(path), qPrintable(xml.errorString()));
    }
    return texts;
}

/// The parts that a translation must also contain: placeholders and tags.
QStringList fixedParts(const QString& text) {
    static const QRegularExpression kParts(QStringLiteral("%L?[0-9n]|</?[a-z][^>]*>"));
    QStringList parts;
    for (auto it = kParts.globalMatch(text); it.hasNext();) {
        parts << it.next().captured();
    }
    parts.sort();
    return parts;
}

void allLanguages() {
    QTest::addColumn<QString>("code");
    for (const Language& one : languages()) {
        QTest::newRow(qPrintable(one.code)) << one.code;
    }
}

struct Bench : WindowBench {
    SettingsPage& settings() {
        QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
        auto* page = window.findChild<SettingsPage*>();
        if (page == nullptr) {
            qFatal("the settings page did not open");
        }
        return *page;
    }
};

}  // namespace

class TestSpokenLanguage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        applyTheme(*qApp, Theme::light());
        QLocale::setDefault(QLocale::c());
    }

    void everySourceTextIsInEveryLanguage() {
        // Extract the texts from the sources again, as a translator would.
        QTemporaryDir folder;
        const QString fresh = folder.filePath("fresh_en.ts");
        QProcess reads;
        reads.setWorkingDirectory(QStringLiteral(TILLER_SOURCE_DIR));
        reads.start(QStringLiteral(TILLER_LUPDATE), {"app", "widgets", "robot", "-I", ".", "-no-obsolete",
                                                     "-locations", "none", "-ts", fresh});
        QVERIFY2(reads.waitForFinished(110'000), qPrintable(reads.errorString()));
        QCOMPARE(reads.exitCode(), 0);
        const QStringList wanted = readTexts(fresh).keys();
        QVERIFY(wanted.size() > 1000);
        for (const Language& one : languages()) {
            const QStringList there = readTexts(kFolder + "tiller_" + one.code + ".ts").keys();
            for (const QString& text : wanted) {
                QVERIFY2(there.contains(text),
                         qPrintable(one.code + " lacks \"" + text +
                                    "\": cmake --build build/release --target update_texts"));
            }
            QCOMPARE(there.size(), wanted.size());
        }
    }

    void everyTextIsTranslatedWithItsPlaceholders_data() { allLanguages(); }
    void everyTextIsTranslatedWithItsPlaceholders() {
        QFETCH(QString, code);
        const Texts texts = readTexts(kFolder + "tiller_" + code + ".ts");
        QStringList wrong;
        for (auto it = texts.begin(); it != texts.end(); ++it) {
            const QString source =
                it.key().section(QLatin1String(": "), 1).section(QLatin1String(" // "), 0, 0);
            if (code == QLatin1String("en") && !it->plural) {
                continue;  // the sources contain the English texts
            }
            for (const QString& text : it->translations) {
                if (text.trimmed().isEmpty() || !it->finished) {
                    wrong << it.key() + ": not translated";
                } else if (fixedParts(text) != fixedParts(source) && !it->plural) {
                    wrong << it.key() + ": " + text;
                } else if (source.endsWith(u'…') != text.endsWith(u'…')) {
                    wrong << it.key() + ": " + text;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(),
                 qPrintable(QStringLiteral("%1 of %2:\n").arg(wrong.size()).arg(texts.size()) +
                            wrong.mid(0, 20).join('\n')));
    }

    void windowUsesTheChosenLanguage_data() { allLanguages(); }
    void windowUsesTheChosenLanguage() {
        QFETCH(QString, code);
        const LanguageTexts texts(code);
        QCOMPARE(texts.code(), code);
        QCOMPARE(shownLanguage(), code);
        const QString settings = QCoreApplication::translate("tiller::app::SettingsPage", "Settings");
        QCOMPARE(settings == QLatin1String("Settings"), code == QLatin1String("en"));
    }

    void missingLanguageFallsBackToTheSystemOrEnglish() {
        QVERIFY(!languageFor("xx").isEmpty());
        QCOMPARE(languageFor("xx"), languageFor({}));
        QCOMPARE(languageFor("ja"), QString("ja"));
        QCOMPARE(languageFor("../../etc/passwd"), languageFor({}));
    }

    void numbersHaveTheDecimalSeparatorOfTheLanguage() {
        const LanguageTexts texts(QStringLiteral("de"));
        QCOMPARE(format::number(12.5, 2), QString("12,50"));
        QCOMPARE(format::signedNumber(-0.25, 2), QString(QChar(0x2212)) + "0,25");
        DecimalSpinBox box;
        box.setDecimals(2);
        box.setRange(-10, 10);
        box.setSuffix(" mm");
        box.setValue(1.25);
        QCOMPARE(box.text(), QString("1,25 mm"));
        for (const char* typed : {"3.5", "3,5"}) {
            box.setValue(0);
            box.selectAll();
            QTest::keyClicks(&box, typed);
            QTest::keyClick(&box, Qt::Key_Return);
            QCOMPARE(box.value(), 3.5);
            QCOMPARE(box.text(), QString("3,50 mm"));
        }
        box.selectAll();
        QTest::keyClicks(&box, "-2,75");
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(box.value(), -2.75);
        box.selectAll();
        QTest::keyClicks(&box, "12,5");
        QTest::keyClick(&box, Qt::Key_Return);
        QVERIFY(box.isRefused());
        QCOMPARE(box.value(), -2.75);
    }

    void languageIsChosenInTheSettingsAndAppliesToANewWindow() {
        LanguageTexts texts(QStringLiteral("en"));
        Bench bench;
        bench.show();
        SettingsPage& page = bench.settings();
        auto* language = page.findChild<QComboBox*>("settings.language");
        auto* reopen = page.findChild<QPushButton*>("settings.reopenWindow");
        const auto* note = page.findChild<QLabel*>("settings.languageNote");
        QCOMPARE(language->count(), static_cast<int>(languages().size()) + 1);
        language->setFocus(Qt::TabFocusReason);
        QTest::keyClick(language, Qt::Key_Down);  // English
        QTest::keyClick(language, Qt::Key_Down);  // Deutsch
        QCOMPARE(language->currentText(), QString("Deutsch"));
        QVERIFY2(note->text().contains("restarted"), qPrintable(note->text()));
        QCOMPARE(Settings(bench.file).preferences().language, QString("de"));
        QVERIFY(reopen->isEnabled());

        QSignalSpy closed(&bench.window, &MainWindow::closedForNewWindow);
        QTest::mouseClick(reopen, Qt::LeftButton);
        QCOMPARE(closed.size(), 1);
        QVERIFY(!bench.window.isVisible());

        texts.take(Settings(bench.file).preferences().language);
        Bench again;
        again.show();
        SettingsPage& shown = again.settings();
        QCOMPARE(shown.windowTitle(), QCoreApplication::translate("tiller::app::SettingsPage", "Settings"));
        QVERIFY(shown.windowTitle() != QLatin1String("Settings"));
    }

    void aRunningRecordingPreventsReplacingTheWindow() {
        const LanguageTexts texts(QStringLiteral("en"));
        Bench bench;
        bench.show();
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.session().recording().start(bench.folder.filePath("running.csv"));
        bench.cell.advanceMs(100);
        QVERIFY(bench.window.session().state().recording.active);
        SettingsPage& page = bench.settings();
        auto* language = page.findChild<QComboBox*>("settings.language");
        language->setFocus(Qt::TabFocusReason);
        QTest::keyClick(language, Qt::Key_End);
        QSignalSpy closed(&bench.window, &MainWindow::closedForNewWindow);
        QTest::mouseClick(page.findChild<QPushButton*>("settings.reopenWindow"), Qt::LeftButton);
        QCOMPARE(closed.size(), 0);
        QVERIFY(bench.window.isVisible());
        const QString why = page.findChild<QLabel*>("settings.languageNote")->text();
        QVERIFY2(why.contains("recording"), qPrintable(why));
    }

    void recordingsHaveDecimalPointsInEveryLanguage() {
        const LanguageTexts texts(QStringLiteral("de"));
        Bench bench;
        bench.show();
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const QString path = bench.folder.filePath("german.csv");
        bench.window.session().recording().start(path, {"timestamp", "actual_q"});
        bench.cell.advanceMs(100);
        bench.window.session().recording().stop();
        QTRY_VERIFY_WITH_TIMEOUT(
            !bench.window.session().state().recording.active || (bench.cell.advanceMs(10), false), 60'000);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> rows = file.readAll().split('\n');
        QVERIFY(rows.size() > 2);
        const QList<QByteArray> figures = rows[1].trimmed().split(',');
        QCOMPARE(figures.size(), rows[0].trimmed().split(',').size());
        QVERIFY2(rows[1].contains('.'), rows[1].constData());
        for (const QByteArray& figure : figures) {
            bool isNumber = false;
            figure.toDouble(&isNumber);  // accepts only the decimal point
            QVERIFY2(isNumber, rows[1].constData());
        }
    }

    void untranslatedTextIsDetected() {
        QCOMPARE(pseudoText("Stop %1 of <b>%n</b>"), QString("Štööp %1 ööf <b>%n</b>"));
        const QString longer = pseudoText("Hold to move the arm along the path");
        QVERIFY(longer.size() >= 44);
    }
};

QTEST_MAIN(TestSpokenLanguage)
#include "tst_spoken_language.moc"
