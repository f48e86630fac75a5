// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests all search fields with typed text: their results, and the message if there is no result.

#include <QAction>
#include <QLineEdit>
#include <QTest>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "resources/resources.h"
#include "tests/support/window_bench.h"
#include "widgets/common/empty_state.h"

using namespace tiller;
using namespace tiller::test;

class TestSearchFields : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void everySearchFieldReportsEmptyResults_data() {
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<QByteArray>("list");
        QTest::addColumn<QString>("known");
        QTest::newRow("log") << QByteArray("view.log") << QByteArray("log.search") << QByteArray("log.table")
                             << QStringLiteral("Known line");
        QTest::newRow("I/O") << QByteArray("view.io") << QByteArray("io.search") << QByteArray("io.scroll")
                             << QStringLiteral("TO 1");
        QTest::newRow("commands") << QByteArray("app.palette") << QByteArray("paletteWords")
                                  << QByteArray("paletteList") << QStringLiteral("show log");
    }
    void everySearchFieldReportsEmptyResults() {
        QFETCH(QByteArray, command);
        QFETCH(QByteArray, field);
        QFETCH(QByteArray, list);
        QFETCH(QString, known);
        WindowBench bench;
        bench.show();
        bench.window.session().journal().add(Severity::Info, QStringLiteral("Known line"));
        bench.window.actions().find(QLatin1String(command))->trigger();
        auto& search = bench.find<QLineEdit>(field);
        auto& nothing = bench.find<EmptyState>(list + ".nothingFound");
        QTRY_VERIFY_WITH_TIMEOUT(search.isVisible(), 60'000);
        QVERIFY(!nothing.isVisible());
        QTest::keyClicks(&search, known);
        QVERIFY(!nothing.isVisible());
        search.clear();
        QTest::keyClicks(&search, QStringLiteral("qqxyz"));
        QVERIFY(nothing.isVisible());
        QVERIFY2(nothing.text().contains(QStringLiteral("qqxyz")), qPrintable(nothing.text()));
        QVERIFY(nothing.height() >= nothing.heightForWidth(nothing.width()));
        // An accidental Return must not run anything.
        QTest::keyClick(&search, Qt::Key_Down);
        QTest::keyClick(&search, Qt::Key_Return);
        QVERIFY(search.isVisible() && nothing.isVisible());
        search.clear();
        QVERIFY(!nothing.isVisible());
    }
};

QTEST_MAIN(TestSearchFields)
#include "tst_search_fields.moc"
