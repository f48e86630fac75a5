// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the settings: the settings file, the settings page and the manual contain every row.

#include <QFile>
#include <QSet>
#include <QTest>
#include <algorithm>

#include "app/preference_table.h"
#include "app/settings_file.h"

using namespace tiller;
using namespace tiller::app;

class TestPreferenceTable : public QObject {
    Q_OBJECT

private:
    void addRows() {
        QTest::addColumn<const PreferenceRow*>("row");
        for (const PreferenceRow& row : preferenceRows()) {
            QTest::newRow(qPrintable(row.key)) << &row;
        }
    }

private Q_SLOTS:
    void keysAreUnique() {
        QSet<QString> keys;
        for (const PreferenceRow& row : preferenceRows()) {
            QVERIFY2(!keys.contains(row.key), qPrintable(row.key));
            keys.insert(row.key);
            QVERIFY2(partOf(row.key) != SettingsPart::Other || row.key.startsWith("recording/"),
                     qPrintable(row.key));
        }
    }

    void defaultsAreSavedAndReadBack_data() { addRows(); }
    void defaultsAreSavedAndReadBack() {
        QFETCH(const PreferenceRow*, row);
        const Preferences defaults;
        Preferences read;
        QCOMPARE(preferenceValues(defaults).value(row->key), row->value(defaults));
        row->setValue(read, row->value(defaults));
        QVERIFY(read == defaults);
        QCOMPARE(travels(row->key), !row->isLocal);
    }

    void invalidValuesBecomeValid_data() { addRows(); }
    void invalidValuesBecomeValid() {
        QFETCH(const PreferenceRow*, row);
        for (const QVariant& wrong : {QVariant(), QVariant("x"), QVariant(-1e9), QVariant(1e9)}) {
            Preferences read;
            row->setValue(read, wrong);
            const QVariant kept = row->value(read);
            if (row->editor == PreferenceRow::Editor::Choice) {
                QVERIFY(std::find(row->words.begin(), row->words.end(), kept.toString()) != row->words.end());
            } else if (row->editor == PreferenceRow::Editor::Number) {
                QVERIFY(kept.toInt() >= row->min && kept.toInt() <= row->max);
            }
        }
    }

    void theManualListsEveryValue_data() { addRows(); }
    void theManualListsEveryValue() {
        QFETCH(const PreferenceRow*, row);
        QFile manual(QStringLiteral(TILLER_SETTINGS_MANUAL));
        QVERIFY(manual.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(manual.readAll()).simplified();
        QVERIFY2(text.contains(QLatin1String(row->manual), Qt::CaseInsensitive), row->manual);
    }

    void choicesHaveATitleForEachWord() {
        for (const PreferenceRow& row : preferenceRows()) {
            QVERIFY2(row.words.size() == row.titles.size(), qPrintable(row.key));
        }
    }
};

QTEST_MAIN(TestPreferenceTable)
#include "tst_preference_table.moc"
