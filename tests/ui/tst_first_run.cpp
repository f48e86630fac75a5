// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first minute: try the simulator, connect a robot, or open a session; and every later start, with the
// robots there were before.

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "app/connect_dialog.h"
#include "app/main_window.h"
#include "resources/resources.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/status/preflight_page.h"

using namespace tiller;
using namespace tiller::test;
using app::ConnectDialog;

class TestFirstRun : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    QString file() const { return folder_.filePath("settings.ini"); }

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }
    void init() { QFile::remove(file()); }

    void aNewcomerIsOfferedThreeWays() {
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.askForRobot();
        auto* dialog = window.findChild<ConnectDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        for (const char* key : {"startSimulator", "connectRobot", "openProject"}) {
            QVERIFY2(dialog->findChild<QPushButton*>(QLatin1String(key)) != nullptr, key);
        }
        QVERIFY(dialog->findChild<QPushButton*>("startSimulator")->isDefault());
        QVERIFY2(!dialog->findChild<QPushButton*>("connectRobot")->isEnabled(), "no address yet");
        const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (!to.isEmpty()) {
            QVERIFY(dialog->grab().save(to + "/first-run.png"));
        }
        dialog->reject();
        QCOMPARE(window.session().state().link, LinkState::Disconnected);
    }

    void returnTriesTheSimulator() {
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.askForRobot();
        auto* dialog = window.findChild<ConnectDialog*>();
        QTest::keyClick(dialog, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(window.session().state().link, LinkState::Live, 30'000);
        QVERIFY(window.session().state().simulated);
        QVERIFY2(app::Settings(file()).rememberedRobots().isEmpty(), "the simulator is no robot of yours");
    }

    void anImpossibleAddressIsNamedBeforeItIsTried_data() {
        QTest::addColumn<QString>("host");
        QTest::addColumn<bool>("possible");
        QTest::newRow("address") << "192.168.0.10" << true;
        QTest::newRow("name") << "ur5e-left.lab" << true;
        QTest::newRow("nothing") << "" << false;
        QTest::newRow("three numbers") << "192.168.0" << false;
        QTest::newRow("too large") << "192.168.0.300" << false;
        QTest::newRow("blank inside") << "my robot" << false;
        QTest::newRow("a page") << "http://192.168.0.10/" << false;
    }
    void anImpossibleAddressIsNamedBeforeItIsTried() {
        QFETCH(QString, host);
        QFETCH(bool, possible);
        ConnectDialog dialog({});
        auto* field = dialog.findChild<QLineEdit*>("robotHost");
        field->setText(QStringLiteral("x"));
        field->clear();
        QTest::keyClicks(field, host);
        QCOMPARE(dialog.findChild<QPushButton*>("connectRobot")->isEnabled(), possible);
        QCOMPARE(dialog.findChild<QLabel*>("connectHint")->text().isEmpty(), possible);
    }

    void aRobotIsLookedAtBeforeItIsConnected() {
        VirtualClock clock;
        app::MainWindow window(app::Settings(file()), clock);
        window.show();
        window.askForRobot();
        auto* dialog = window.findChild<ConnectDialog*>();
        dialog->findChild<QLineEdit*>("robotHost")->setText("127.0.0.253");
        dialog->findChild<QLineEdit*>("robotName")->setText("Left arm");
        QTest::mouseClick(dialog->findChild<QPushButton*>("connectRobot"), Qt::LeftButton);
        auto* page = window.findChild<PreflightPage*>();
        QVERIFY(page != nullptr && page->isVisible());
        QCOMPARE(window.session().state().link, LinkState::Disconnected);
        QTRY_VERIFY_WITH_TIMEOUT(page->isFinished(), 60'000);
        QTest::mouseClick(page->findChild<QPushButton*>("preflightConnect"), Qt::LeftButton);
        QVERIFY(window.session().state().link != LinkState::Disconnected);
        const QVector<RobotAddress> robots = app::Settings(file()).rememberedRobots();
        QCOMPARE(robots.size(), 1);
        QCOMPARE(robots.first().name, QStringLiteral("Left arm"));
    }

    void severalRobotsStandInTheSelectorNewestFirst() {
        VirtualClock clock;
        app::MainWindow window(app::Settings(file()), clock);
        window.show();
        for (int i = 0; i < 12; ++i) {
            window.connectRobot(
                {QStringLiteral("Arm %1").arg(i), QStringLiteral("127.0.1.%1").arg(i), 0, false});
        }
        window.connectRobot({"Arm 9", "127.0.1.9", 0, false});
        const QVector<RobotAddress> robots = app::Settings(file()).rememberedRobots();
        QCOMPARE(robots.size(), 8);
        QCOMPARE(robots[0].name, QStringLiteral("Arm 9"));
        QCOMPARE(robots[1].name, QStringLiteral("Arm 11"));
        auto* menu = window.findChild<QMenu*>("mainMenu");
        QStringList shown;
        for (QAction* action : menu->actions()) {
            if (action->objectName().startsWith("robot.remembered.")) {
                shown << action->text();
            }
        }
        QCOMPARE(shown.size(), 8);
        QVERIFY(shown.first().contains("Arm 9"));
        for (QAction* action : menu->actions()) {
            if (action->objectName() == "robot.remembered.127.0.1.10") {
                action->trigger();
                break;
            }
        }
        QCOMPARE(window.session().state().robotName, QStringLiteral("Arm 10"));
    }

    void aDamagedListOfRobotsLosesNothingElse() {
        {
            QSettings settings(file(), QSettings::IniFormat);
            settings.setValue("robots/size", 1'000'000);
            settings.setValue("robots/1/host", "");
            settings.setValue("robots/2/host", "192.168.0.10");
            settings.setValue("robots/2/portOffset", "many");
            settings.setValue("look/theme", "dark");
        }
        const app::Settings settings(file());
        const QVector<RobotAddress> robots = settings.rememberedRobots();
        QCOMPARE(robots.size(), 1);
        QCOMPARE(robots.first().name, QStringLiteral("192.168.0.10"));
        QCOMPARE(robots.first().portOffset, 0);
        QCOMPARE(settings.theme(), QStringLiteral("dark"));
    }
};

QTEST_MAIN(TestFirstRun)
#include "tst_first_run.moc"
