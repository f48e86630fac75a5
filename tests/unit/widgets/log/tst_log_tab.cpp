// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <memory>

#include "robot/core/clock.h"
#include "widgets/common/empty_state.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/log/log_model.h"
#include "widgets/log/log_tab.h"

using namespace tiller;

class TestLogTab : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void init() {
        time_ = QDateTime(QDate(2024, 9, 17), QTime(14, 2, 11));
        journal_ = std::make_unique<Journal>();
        journal_->setWallClock([this] { return time_.toMSecsSinceEpoch() * kNsPerMs; });
        tab_ = std::make_unique<LogTab>(*journal_);
        tab_->resize(560, 400);
        tab_->show();
        QVERIFY(QTest::qWaitForWindowExposed(tab_.get()));
    }
    void cleanup() {
        tab_.reset();
        journal_.reset();
    }

    // The origin has no article, so the same text fits in every language.
    void theOriginIsNamed() {
        journal_->add(Severity::Info, "Speed slider: 50 %", Origin::Operator);
        const QString details = tab_->model().index(0, LogModel::Text).data(Qt::ToolTipRole).toString();
        QVERIFY2(details.contains("· Origin: Operator\n"), qPrintable(details));
    }

    void messagesOfTheSessionArriveInOrder() {
        QAbstractItemModelTester tester(&tab_->model(),
                                        QAbstractItemModelTester::FailureReportingMode::QtTest);
        journal_->add(Severity::Info, "Connected");
        journal_->add(Severity::Error, "Protective stop");
        QCOMPARE(rows(), 2);
        QCOMPARE(cell(0, LogModel::Time), QString("14:02:11"));
        QCOMPARE(cell(0, LogModel::Text), QString("Connected"));
        QVERIFY(cell(1, LogModel::SeverityColumn).contains("Error"));
    }

    void eventsFromBeforeTheTabAreShown() {
        journal_->add(Severity::Warning, "The settings could not be saved.");
        journal_->addStep("Step 1 (Loop)", true);
        journal_->addStep("Step 1 (Loop)", false);
        journal_->addNote("here it slipped", 0);
        time_ = time_.addSecs(60);
        const LogTab later(*journal_);
        QCOMPARE(later.allText(), tab_->allText());
        QCOMPARE(later.allText().count('\n'), 3);
        QVERIFY2(later.allText().contains("14:02:11") && later.allText().contains("Note: here it slipped"),
                 qPrintable(later.allText()));
    }

    void repeatsAreCounted() {
        for (int n = 0; n < 3; ++n) {
            journal_->add(Severity::Warning, "Elbow near its limit");
            time_ = time_.addSecs(1);
        }
        QCOMPARE(rows(), 1);
        QCOMPARE(cell(0, LogModel::Text), QString("(×3, last at 14:02:13) Elbow near its limit"));
        QCOMPARE(cell(0, LogModel::Time), QString("14:02:11"));
        journal_->add(Severity::Error, "Elbow near its limit");
        QCOMPARE(rows(), 2);
    }

    // A later message must not be displayed above an earlier message.
    void onlyConsecutiveRepeatsAreCounted() {
        const auto say = [this](Severity severity, const char* text) {
            journal_->add(severity, text, Origin::Robot);
            time_ = time_.addSecs(1);
        };
        say(Severity::Info, "Safety mode is Normal again");
        say(Severity::Error, "Emergency stop");
        say(Severity::Error, "Emergency stop");
        say(Severity::Info, "Safety mode is Normal again");
        QCOMPARE(rows(), 3);
        QCOMPARE(tab_->shownText(),
                 QString("2024-09-17 14:02:11.000\tInfo\tSafety mode is Normal again\n"
                         "2024-09-17 14:02:12.000\tError\t(×2, last at 14:02:13.000) Emergency stop\n"
                         "2024-09-17 14:02:14.000\tInfo\tSafety mode is Normal again\n"));
        QStringList times;
        for (int row = 0; row < rows(); ++row) {
            times << cell(row, LogModel::Time);
        }
        QVERIFY(std::is_sorted(times.begin(), times.end()));
    }

    void sameTextWithAnotherMeaningIsASeparateLine() {
        journal_->add(Severity::Error, "C157A1", Origin::Robot, "the elbow");
        journal_->add(Severity::Error, "C157A1", Origin::Robot, "the base");
        QCOMPARE(rows(), 2);
    }

    void operatorActionsAreListedEveryTime() {
        journal_->add(Severity::Info, "Output 1 on", Origin::Operator);
        journal_->add(Severity::Info, "Output 1 off", Origin::Operator);
        journal_->add(Severity::Info, "Output 1 on", Origin::Operator);
        QCOMPARE(rows(), 3);
        QTest::keyClicks(tab_->findChild<QLineEdit*>("log.search"), "operator on");
        QCOMPARE(rows(), 2);
    }

    void selectedLineIsShownInFull() {
        auto* details = tab_->findChild<QLabel*>("log.details");
        QVERIFY(!details->isVisible());
        journal_->add(Severity::Error, "C157A1 Collision noticed by a joint", Origin::Robot,
                      "A joint needed more torque. Remove the obstacle.");
        table()->selectRow(0);
        QVERIFY(details->isVisible());
        for (const char* part :
             {"14:02:11", "Origin: Robot", "C157A1", "more torque", "Remove the obstacle"}) {
            QVERIFY2(details->text().contains(QLatin1String(part)), part);
        }
        time_ = time_.addSecs(5);
        journal_->add(Severity::Error, "C157A1 Collision noticed by a joint", Origin::Robot,
                      "A joint needed more torque. Remove the obstacle.");
        QVERIFY2(details->text().contains("2 times"), qPrintable(details->text()));
        QVERIFY(tab_->shownText().contains("Remove the obstacle"));
    }

    void rowsAreFilteredBySeverityAndText() {
        journal_->add(Severity::Info, "Jog stopped: released");
        journal_->add(Severity::Warning, "Late packets");
        journal_->add(Severity::Error, "Link lost: no packets");
        auto* severity = tab_->findChild<SegmentedControl*>("log.severity");
        QTest::mouseClick(severity->segment(1), Qt::LeftButton);
        QCOMPARE(rows(), 2);
        QTest::mouseClick(severity->segment(2), Qt::LeftButton);
        QCOMPARE(rows(), 1);
        QTest::mouseClick(severity->segment(0), Qt::LeftButton);
        QTest::keyClicks(tab_->findChild<QLineEdit*>("log.search"), "PACKETS lost");
        QCOMPARE(rows(), 1);
        QCOMPARE(cell(0, LogModel::Text), QString("Link lost: no packets"));
    }

    void filtersWithoutMatchesAreReported() {
        const auto* nothing = tab_->findChild<EmptyState*>("log.table.nothingFound");
        QVERIFY2(!nothing->isVisible(), "an empty log shows that nothing was found");
        journal_->add(Severity::Info, "Jog stopped: released");
        auto* severity = tab_->findChild<SegmentedControl*>("log.severity");
        QTest::mouseClick(severity->segment(2), Qt::LeftButton);
        QVERIFY(nothing->isVisible());
        journal_->add(Severity::Error, "Link lost");
        QVERIFY(!nothing->isVisible());
    }

    void copyUsesTheSelectionOrAllShownRows() {
        journal_->add(Severity::Info, "one");
        journal_->add(Severity::Warning, "two\nlines");
        QTest::mouseClick(tab_->findChild<QToolButton*>("log.copy"), Qt::LeftButton);
        QCOMPARE(
            QApplication::clipboard()->text(),
            QString("2024-09-17 14:02:11.000\tInfo\tone\n2024-09-17 14:02:11.000\tWarning\ttwo lines\n"));
        table()->selectRow(0);
        table()->setFocus();
        QTest::keyClick(table(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), QString("2024-09-17 14:02:11.000\tInfo\tone\n"));
    }

    void exportWritesTheShownRows() {
        journal_->add(Severity::Info, "one");
        journal_->add(Severity::Error, "zwei Ä");
        tab_->findChild<SegmentedControl*>("log.severity")->setCurrentIndex(2);
        QTemporaryDir directory;
        QVERIFY(tab_->exportTo(directory.filePath("log.txt")).ok());
        QFile file(directory.filePath("log.txt"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(file.readAll()), QString("2024-09-17 14:02:11.000\tError\tzwei Ä\n"));
        QVERIFY(tab_->exportTo(directory.filePath("no/such/log.txt")).error().code ==
                ErrorCode::FileNotWritable);
    }

    void oldestRowsAreDroppedAtTheCapacity() {
        for (int n = 0; n < LogModel::kCapacity + 10; ++n) {
            journal_->add(Severity::Info, QString::number(n));
        }
        QCOMPARE(tab_->model().rowCount(), int(LogModel::kCapacity));
        QCOMPARE(cell(0, LogModel::Text), QString("10"));
    }

    void newestLineIsVisibleUnlessScrolledBack() {
        for (int n = 0; n < 100; ++n) {
            journal_->add(Severity::Info, QString::number(n));
        }
        QVERIFY(table()->visualRect(table()->model()->index(99, 0)).bottom() <=
                table()->viewport()->height());
        table()->scrollToTop();
        journal_->add(Severity::Info, "new");
        QCOMPARE(table()->rowAt(2), 0);
    }

    void anIncidentRowOpensItsRecording() {
        QSignalSpy wanted(tab_.get(), &LogTab::recordingWanted);
        auto* key = tab_->findChild<QToolButton*>("log.openRecording");
        journal_->add(Severity::Error, "Protective stop");
        journal_->addRecording(Severity::Warning, "Incident recorded: protective stop", "It is there.",
                               "/a/b.mcap");
        const auto middleOf = [this](int row) {
            return table()->visualRect(table()->model()->index(row, LogModel::Text)).center();
        };
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, middleOf(0));
        QVERIFY(!key->isVisible());
        QSignalSpy times(tab_.get(), &LogTab::timeWanted);
        QTest::mouseDClick(table()->viewport(), Qt::LeftButton, {}, middleOf(0));
        QCOMPARE(wanted.count(), 0);
        QCOMPARE(times.count(), 1);
        QCOMPARE(times.front()[0].toDateTime(), time_);
        QCOMPARE(times.front()[1].toBool(), false);
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, middleOf(1));
        QVERIFY(key->isVisible());
        QTest::mouseClick(key, Qt::LeftButton);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front()[0].toString(), QString("/a/b.mcap"));
        QTest::mouseDClick(table()->viewport(), Qt::LeftButton, {}, middleOf(1));
        QCOMPARE(wanted.count(), 2);
        QCOMPARE(times.count(), 1);
        // Another file is a separate incident, even if the text is the same.
        journal_->addRecording(Severity::Warning, "Incident recorded: protective stop", "It is there.",
                               "/a/c.mcap");
        QCOMPARE(rows(), 3);
    }

    // The details appear below the table while the button is pressed, and the table becomes smaller.
    void aSingleClickOnOpenOpensTheRecording() {
        QSignalSpy wanted(tab_.get(), &LogTab::recordingWanted);
        tab_->resize(560, 407);
        for (int n = 0; n < 40; ++n) {
            journal_->add(Severity::Info, QString::number(n));
        }
        journal_->addRecording(Severity::Warning, "Incident recorded: protective stop",
                               "Line 1\nLine 2\nLine 3\nLine 4", "/a/b.mcap");
        for (int n = 0; n < 3; ++n) {
            journal_->add(Severity::Info, QStringLiteral("later %1").arg(n));
        }
        QCoreApplication::sendPostedEvents();
        table()->scrollToBottom();
        QWidget* viewport = table()->viewport();
        const QPoint place = table()->visualRect(table()->model()->index(40, LogModel::Open)).center();
        QVERIFY(viewport->rect().contains(place));
        const int height = viewport->height();
        QTest::mousePress(viewport, Qt::LeftButton, {}, place);
        QTRY_VERIFY_WITH_TIMEOUT(viewport->height() < height, 60'000);
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, place);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front()[0].toString(), QString("/a/b.mcap"));
    }

    void backToLiveHidesTheDetailsOfTheReplay() {
        journal_->add(Severity::Info, "Connected");
        ReplayMoment moment;
        moment.source = QStringLiteral("incident.mcap");
        moment.wallTime = time_;
        moment.events = std::make_shared<const std::vector<recording::RecordedEvent>>(
            std::vector<recording::RecordedEvent>{
                {0, 40, QStringLiteral("tiller"), QStringLiteral("incident")}});
        tab_->setReplay(moment);
        auto* details = tab_->findChild<QLabel*>("log.details");
        QVERIFY(details->isVisible());
        tab_->setReplay({});
        QVERIFY2(!details->isVisible(), qPrintable(details->text()));
    }

    void theTextColumnUsesTheRemainingWidth() {
        journal_->add(Severity::Info, "Connected");
        journal_->add(Severity::Warning, "Elbow near its limit");
        journal_->add(Severity::Error, "Protective stop");
        journal_->addRecording(Severity::Warning, "Incident recorded: protective stop", "", "/a/b.mcap");
        for (const int column : {LogModel::Time, LogModel::SeverityColumn, LogModel::Open}) {
            const int wanted = std::max(table()->horizontalHeader()->sectionSizeHint(column), hint(column));
            QVERIFY2(table()->columnWidth(column) >= wanted, qPrintable(QString::number(column)));
            QVERIFY2(table()->columnWidth(column) <= wanted + 2,
                     qPrintable(QStringLiteral("%1: %2 of %3 px")
                                    .arg(column)
                                    .arg(table()->columnWidth(column))
                                    .arg(wanted)));
        }
    }

    // Messages that arrived while another tab was shown are those that the operator needs to see.
    void thePageOpensAtTheNewestLine() {
        const auto newestIsInSight = [&] {
            const QRect last = table()->visualRect(table()->model()->index(rows() - 1, 0));
            return last.isValid() && last.bottom() <= table()->viewport()->height();
        };
        tab_ = std::make_unique<LogTab>(*journal_);  // the tab was never shown
        for (int n = 0; n < 100; ++n) {
            journal_->add(Severity::Info, QString::number(n));
        }
        tab_->resize(560, 400);
        tab_->show();
        QTest::qWait(50);
        QTRY_VERIFY_WITH_TIMEOUT(newestIsInSight(), 60'000);
        table()->scrollToTop();
        tab_->hide();
        journal_->add(Severity::Info, "new");
        tab_->show();
        QTest::qWait(50);
        QCOMPARE(table()->rowAt(2), 0);
    }

private:
    QTableView* table() { return tab_->findChild<QTableView*>("log.table"); }
    /// The widest cell of a column [px].
    int hint(int column) {
        int widest = 0;
        for (int row = 0; row < rows(); ++row) {
            const QModelIndex index = table()->model()->index(row, column);
            widest = std::max(widest, table()->sizeHintForIndex(index).width());
        }
        return widest;
    }
    int rows() { return table()->model()->rowCount(); }
    QString cell(int row, int column) { return table()->model()->index(row, column).data().toString(); }

    QDateTime time_;
    std::unique_ptr<Journal> journal_;
    std::unique_ptr<LogTab> tab_;
};

QTEST_MAIN(TestLogTab)
#include "tst_log_tab.moc"
