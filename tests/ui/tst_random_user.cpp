// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ten thousand random user actions on the real window, with a simulated controller and its faults. The checks
// themselves are tested first.
//
// TILLER_STEPS  total number of steps; default 10 000; a row has at most 1000
// TILLER_SEED   seed of the first row; each further row uses the next number
// A failure prints the settings that repeat the row. Robot, sockets and timers run in real time, so the steps
// may still differ because of the timing of the computer.

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QMutex>
#include <QPushButton>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "resources/resources.h"
#include "tests/support/live_state.h"
#include "tests/ui/places_watch.h"
#include "tests/ui/random_user.h"
#include "tests/ui/step_log.h"
#include "tests/ui/truth_check.h"
#include "widgets/common/state_chip.h"
#include "widgets/common/theme.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/status/header_bar.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kSteps = 10'000;
constexpr int kRowSteps = 1000;
constexpr quint32 kSeed = 20261116;

// ---- expected warnings ------------------------------------------------------------------------------------

/// Patterns of the warnings that the platform without a screen causes.
const char* const kExpectedWarnings[] = {
    "^This plugin does not support ",
};
const char* const kExpectedCategories[] = {"tiller.simulator"};

QMutex warningsLock;
QStringList warnings;
QtMessageHandler handlerBefore = nullptr;

bool isExpected(const QMessageLogContext& context, const QString& text) {
    for (const char* category : kExpectedCategories) {
        if (context.category != nullptr && qstrcmp(context.category, category) == 0) {
            return true;
        }
    }
    for (const char* pattern : kExpectedWarnings) {
        if (QRegularExpression(QLatin1String(pattern)).match(text).hasMatch()) {
            return true;
        }
    }
    return false;
}

void collectWarnings(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if ((type == QtWarningMsg || type == QtCriticalMsg) && !isExpected(context, text)) {
        {
            const QMutexLocker lock(&warningsLock);
            warnings << text;
        }
        // The steps at the time of the warning may no longer be in the log at the end.
        if (QThread::currentThread() == QCoreApplication::instance()->thread()) {
            qInfo("unexpected warning \"%s\" after:%s", qPrintable(text),
                  qPrintable(StepLog::text().right(400)));
        }
    }
    if (handlerBefore != nullptr) {
        handlerBefore(type, context, text);
    }
}

QStringList takeWarnings() {
    const QMutexLocker lock(&warningsLock);
    return std::exchange(warnings, {});
}

/// Collects unexpected warnings during its lifetime.
class WarningWatch {
public:
    WarningWatch() {
        takeWarnings();
        handlerBefore = qInstallMessageHandler(collectWarnings);
    }
    ~WarningWatch() { qInstallMessageHandler(handlerBefore); }
    WarningWatch(const WarningWatch&) = delete;
    WarningWatch& operator=(const WarningWatch&) = delete;
};

int numberFrom(const char* variable, int otherwise) {
    bool ok = false;
    const int number = qEnvironmentVariableIntValue(variable, &ok);
    return ok && number > 0 ? number : otherwise;
}

// ---- windows for testing the checks -----------------------------------------------------------------------

/// Two buttons near each other, and a third button that is far away.
struct Keys {
    QWidget window;
    QPushButton* first = new QPushButton(QStringLiteral("first"), &window);
    QPushButton* second = new QPushButton(QStringLiteral("second"), &window);
    QPushButton* far = new QPushButton(QStringLiteral("far"), &window);
    PlacesWatch watch;

    Keys() {
        window.resize(600, 400);
        first->setGeometry(50, 50, 100, 30);
        second->setGeometry(170, 50, 100, 30);
        far->setGeometry(450, 300, 100, 30);
        window.show();
        if (!QTest::qWaitForWindowExposed(&window)) {
            qFatal("the window did not appear");
        }
        watch.begin(window, first->geometry().center());
    }
};

/// The checked displays, without a robot. The test sets the displayed state.
struct Board {
    QWidget window;
    RobotSession session;
    HeaderBar header{HeaderPort{}, &window};
    HoldPolicy policy;
    JointRows joints{policy, &window};
    IoTab io{session, &window};
    SessionState state = liveState();
    simulator::SimulatedState truth;
    TruthCheck check{window};

    Board() {
        session.shutDown();  // other updates must not replace the states set by the test
        truth.robotMode = state.robotMode;
        truth.safetyMode = state.safetyMode;
        truth.q = state.q;
        truth.digitalOutputs = 0b101;
        truth.speedSlider = state.speedFraction;
        show();
        for (int number = 0; number < IoTab::kChannels; ++number) {
            io.output(number)->setStale(false);
            io.output(number)->setState((truth.digitalOutputs >> number & 1U) != 0 ? IoChannel::State::On
                                                                                   : IoChannel::State::Off);
        }
    }
    void show() {
        header.applyState(state);
        joints.setJoints(state.q, false, state.hasData(), false);
    }
    QStringList lies(bool standing = true) {
        QStringList reported;
        for (const Lie& lie : check.lies(truth, standing)) {
            reported << lie.text;
        }
        return reported;
    }
};

}  // namespace

class TestRandomUser : public QObject {
    Q_OBJECT

private:
    int steps_ = 0;
    int stepsInMotion_ = 0;
    int watchedClicks_ = 0;
    int comparedValues_ = 0;

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
        StepLog::printOnCrash();
        QVERIFY2(QDir::homePath() == QDir::currentPath(), "files would be written to the user's home folder");
    }

    // ---- tests of PlacesWatch -----------------------------------------------------------------------------

    void aWidgetMovedUnderThePointerIsDetected() {
        Keys keys;
        QVERIFY(keys.watch.isOn());
        QCOMPARE(keys.watch.controlsAtPointer(), 1);
        QVERIFY(keys.watch.moved().isEmpty());
        keys.first->move(50, 51);
        QVERIFY2(keys.watch.moved().isEmpty(), "a move within the tolerance was reported");
        keys.first->move(50, 63);
        QCOMPARE(keys.watch.moved().size(), 1);
        QVERIFY2(keys.watch.moved().first().contains("first"), qPrintable(keys.watch.moved().first()));
        keys.first->move(50, 50);
        QVERIFY(keys.watch.moved().isEmpty());
        keys.first->resize(113, 30);
        QCOMPARE(keys.watch.moved().size(), 1);
    }

    void neighbourMovedUnderThePointerIsDetected() {
        Keys keys;
        keys.first->hide();
        QVERIFY(keys.watch.moved().isEmpty());
        keys.far->move(60, 55);
        QCOMPARE(keys.watch.moved().size(), 1);
        QVERIFY(keys.watch.moved().first().contains("far"));
    }

    void widgetMovedByALayoutIsDetected() {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* notice = new QLineEdit;
        auto* key = new QPushButton(QStringLiteral("Teach"));
        layout->addWidget(notice);
        layout->addWidget(key);
        layout->addStretch(1);
        notice->hide();
        window.resize(300, 300);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        PlacesWatch watch;
        watch.begin(window, key->geometry().center());
        notice->show();
        layout->activate();
        QCOMPARE(watch.moved().size(), 1);
        QVERIFY(watch.moved().first().contains("Teach"));
    }

    void distantOrDisabledWidgetsDoNotCount() {
        Keys keys;
        keys.far->move(460, 310);
        QVERIFY(keys.watch.moved().isEmpty());
        keys.first->setEnabled(false);
        keys.watch.begin(keys.window, keys.first->geometry().center());
        keys.first->move(70, 70);
        QVERIFY(keys.watch.moved().isEmpty());
    }

    void aNewTabPageIsNotAMovedWidget() {
        QWidget window;
        auto* tabs = new QTabBar;
        tabs->addTab(QStringLiteral("one"));
        tabs->addTab(QStringLiteral("two"));
        auto* pages = new QStackedWidget;
        pages->addWidget(new QPushButton(QStringLiteral("on one")));
        pages->addWidget(new QLineEdit(QStringLiteral("on two")));
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(tabs);
        layout->addWidget(pages);
        connect(tabs, &QTabBar::currentChanged, pages, &QStackedWidget::setCurrentIndex);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        WindowHand hand(window);
        const QPoint second = tabs->mapTo(&window, tabs->tabRect(1).center());
        PlacesWatch watch;
        watch.begin(window, second);
        hand.click(window, second, Qt::LeftButton);
        QCOMPARE(pages->currentIndex(), 1);
        QVERIFY(watch.isOn());
        QVERIFY2(watch.moved().isEmpty(), qPrintable(watch.moved().join("; ")));
    }

    void watchEndsWithTheOpenedOrClosedWindow() {
        {
            Keys keys;
            QDialog dialog(&keys.window);
            dialog.open();
            QVERIFY(!keys.watch.isOn());
        }
        Keys keys;
        keys.window.hide();
        QVERIFY(!keys.watch.isOn());
    }

    void theWatchEndsInTime() {
        Keys keys;
        QTRY_VERIFY_WITH_TIMEOUT(!keys.watch.isOn(), 60'000);
        QVERIFY(keys.watch.moved().isEmpty());
    }

    void onlyIntendedResizesAreIgnored() {
        QWidget window;
        auto* column = new QWidget(&window);
        column->setObjectName(QStringLiteral("jogColumn"));
        column->setGeometry(0, 0, 200, 200);
        auto* fold = new QPushButton(column);
        fold->setObjectName(QStringLiteral("jogDetail"));
        fold->setGeometry(10, 10, 80, 30);
        auto* inside = new QPushButton(QStringLiteral("inside"), column);
        inside->setGeometry(10, 50, 80, 30);
        auto* outside = new QPushButton(QStringLiteral("outside"), &window);
        outside->setGeometry(205, 10, 80, 30);
        window.resize(400, 300);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCOMPARE(PlacesWatch::containerOf(*fold), column);
        QVERIFY(PlacesWatch::containerOf(*outside) == nullptr);
        PlacesWatch watch;
        watch.begin(window, QPoint(85, 25));
        inside->move(10, 90);
        QVERIFY2(watch.moved().isEmpty(), qPrintable(watch.moved().join("; ")));
        outside->move(80, 20);
        QCOMPARE(watch.moved().size(), 1);
    }

    // ---- tests of TruthCheck ------------------------------------------------------------------------------

    void correctWindowPasses() {
        Board board;
        QVERIFY2(board.lies().isEmpty(), qPrintable(board.lies().join("; ")));
        QVERIFY(board.check.compared() >= 3 + 6 + IoTab::kChannels);
    }

    void wrongModeIsDetected() {
        Board board;
        board.truth.robotMode = RobotMode::PowerOff;
        QCOMPARE(board.lies().size(), 1);
        board.truth.robotMode = board.state.robotMode;
        board.truth.safetyMode = SafetyMode::ProtectiveStop;
        QCOMPARE(board.lies().size(), 1);
        board.truth.safetyMode = board.state.safetyMode;
        board.truth.speedSlider = 0.5;
        QCOMPARE(board.lies().size(), 1);
    }

    void motionShownAtStandstillIsDetected() {
        Board board;
        board.state.moving = true;
        board.show();
        QCOMPARE(board.lies(true).size(), 1);
        QVERIFY(board.lies(false).isEmpty());
    }

    void wrongJointValueIsDetected() {
        Board board;
        board.truth.q[4] += 0.002;
        QCOMPARE(board.lies().size(), 1);
        QVERIFY2(board.lies().first().contains("joint 5"), qPrintable(board.lies().first()));
        board.truth.q[4] = -board.state.q[4];
        QCOMPARE(board.lies().size(), 1);
    }

    void wrongOutputIsDetected() {
        Board board;
        board.truth.digitalOutputs = 0b111;
        QCOMPARE(board.lies().size(), 1);
        board.io.output(1)->setState(IoChannel::State::PendingOn);
        QVERIFY2(board.lies().isEmpty(), "a pending output was reported as wrong");
        board.io.output(1)->setState(IoChannel::State::Off);
        board.io.output(1)->setStale(true);
        QVERIFY2(board.lies().isEmpty(), "an output with outdated data was reported as wrong");
    }

    void valuesMarkedAsUnknownPass() {
        Board board;
        board.truth.robotMode = RobotMode::PowerOff;
        board.truth.q[0] += 1;
        QVERIFY(!board.lies().isEmpty());
        board.state.link = LinkState::Lost;
        board.show();
        const int compared = board.check.compared();
        QVERIFY2(board.lies().isEmpty(), qPrintable(board.lies().join("; ")));
        QVERIFY2(board.check.compared() == compared, "values marked as unknown were counted as compared");
    }

    void aWindowWithoutItsWidgetsIsReported() {
        QWidget empty;
        TruthCheck check(empty);
        QVERIFY(check.lies({}, true).size() >= 3);
    }

    void aWarningIsDetected() {
        const WarningWatch watch;
        QTest::ignoreMessage(QtWarningMsg, "This plugin does not support flying");
        qWarning("This plugin does not support flying");
        QVERIFY(takeWarnings().isEmpty());
        QTest::ignoreMessage(QtWarningMsg, "something is wrong");
        qWarning("something is wrong");
        QCOMPARE(takeWarnings(), QStringList("something is wrong"));
    }

    void theLastStepsAreKept() {
        StepLog::begin("the title");
        for (int i = 0; i < 100; ++i) {
            StepLog::add(QStringLiteral("step %1").arg(i));
        }
        const QStringList lines = StepLog::text().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 1 + StepLog::kKept);
        QCOMPARE(lines.first(), QString("the title"));
        QCOMPARE(lines.last(), QString("step 99"));
    }

    // ---- the random user ----------------------------------------------------------------------------------

    void nothingBreaks_data() {
        QTest::addColumn<quint32>("seed");
        QTest::addColumn<int>("steps");
        const quint32 first = static_cast<quint32>(numberFrom("TILLER_SEED", static_cast<int>(kSeed)));
        int left = numberFrom("TILLER_STEPS", kSteps);
        for (quint32 seed = first; left > 0; ++seed) {
            QTest::addRow("seed %u", seed) << seed << std::min(left, kRowSteps);
            left -= kRowSteps;
        }
    }
    void nothingBreaks() {
        QFETCH(quint32, seed);
        QFETCH(int, steps);
        static int place = 0;
        StepLog::begin(QStringLiteral("TILLER_SEED=%1 TILLER_STEPS=%2 tst_random_user nothingBreaks; "
                                      "the last %3 steps:")
                           .arg(seed)
                           .arg(steps)
                           .arg(StepLog::kKept));
        const WarningWatch watch;
        QString failure;
        {
            RandomUser user(seed, place++ % 200);
            if (user.begin()) {
                user.play(steps);
                user.finish();
            }
            failure = user.failure();
            qInfo("%d steps, %d of them with the arm in motion, %d clicks watched, %d values compared",
                  user.steps(), user.stepsInMotion(), user.watchedClicks(), user.comparedValues());
            steps_ += user.steps();
            stepsInMotion_ += user.stepsInMotion();
            watchedClicks_ += user.watchedClicks();
            comparedValues_ += user.comparedValues();
        }
        const QStringList warned = takeWarnings();
        if (!failure.isEmpty() || !warned.isEmpty()) {
            // Print line by line, because Qt Test truncates long messages and the last steps are the most
            // important.
            for (const QString& line : StepLog::text().split(QLatin1Char('\n'))) {
                qInfo("%s", qPrintable(line));
            }
        }
        QVERIFY2(failure.isEmpty(), qPrintable(failure));
        QVERIFY2(warned.isEmpty(),
                 qPrintable(QStringLiteral("unexpected warnings: %1").arg(warned.join("; "))));
    }

    // If its actions have no effect, the random user cannot find any errors.
    void randomActionsWereEffective() {
        if (steps_ < 3 * kRowSteps) {
            QSKIP("too few steps for a meaningful result");
        }
        QVERIFY2(watchedClicks_ > steps_ / 20, "too few clicks were checked");
        QVERIFY2(comparedValues_ > steps_ / 4, "too few displayed values were checked");
        QVERIFY2(stepsInMotion_ > steps_ / 500, "the arm moved in too few steps");
    }
};

int main(int argc, char* argv[]) {
    // All saved, exported and recorded files must be in a temporary folder.
    const QTemporaryDir home;
    if (!home.isValid() || !QDir::setCurrent(home.path())) {
        return 1;
    }
    for (const char* name :
         {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"}) {
        qputenv(name, QDir::currentPath().toLocal8Bit());
    }
    if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) {
        qputenv("QTEST_FUNCTION_TIMEOUT", "1800000");  // [ms]; with memory checkers, a row takes a long time
    }
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    TestRandomUser test;
    QTEST_SET_MAIN_SOURCE_PATH
    return QTest::qExec(&test, argc, argv);
}
#include "tst_random_user.moc"
