// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first start, with the choices simulator, robot and project, and later starts with remembered robots.

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "app/action_table.h"
#include "app/connect_dialog.h"
#include "app/main_window.h"
#include "app/start_project.h"
#include "resources/resources.h"
#include "robot/simulator/simulator.h"
#include "robot/station/document/project_document.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/project/project_files.h"
#include "widgets/status/preflight_page.h"

using namespace tiller;
using namespace tiller::test;
using app::ConnectDialog;

namespace {

/// Replaces the user's folders by folders inside `folder` for the lifetime of the object.
class Home {
public:
    explicit Home(const QString& folder) {
        for (const auto& [name, place] :
             {std::pair{"HOME", folder}, {"XDG_DATA_HOME", folder + "/data"}, {"XDG_CONFIG_HOME", folder}}) {
            before_.append({name, qgetenv(name)});
            qputenv(name, place.toLocal8Bit());
        }
    }
    ~Home() {
        for (const auto& [name, value] : before_) {
            if (value.isNull()) {
                qunsetenv(name);
            } else {
                qputenv(name, value);
            }
        }
    }
    Home(const Home&) = delete;
    Home& operator=(const Home&) = delete;

private:
    QList<std::pair<const char*, QByteArray>> before_;
};

}  // namespace

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

    void aNewUserIsOfferedThreeOptions() {
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.askForRobot();
        auto* dialog = window.findChild<ConnectDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        for (const char* key : {"startSimulator", "connectRobot", "openProject"}) {
            QVERIFY2(dialog->findChild<QPushButton*>(QLatin1String(key)) != nullptr, key);
        }
        QVERIFY(dialog->findChild<QPushButton*>("startSimulator")->isDefault());
        QVERIFY2(!dialog->findChild<QPushButton*>("connectRobot")->isEnabled(),
                 "the button is enabled without an address");
        const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (!to.isEmpty()) {
            QVERIFY(dialog->grab().save(to + "/first-run.png"));
        }
        dialog->reject();
        QCOMPARE(window.session().state().link, LinkState::Disconnected);
    }

    void returnConnectsToTheSimulator() {
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.askForRobot();
        auto* dialog = window.findChild<ConnectDialog*>();
        QTest::keyClick(dialog, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(window.session().state().link, LinkState::Live, 30'000);
        QVERIFY(window.session().state().simulated);
        QVERIFY2(app::Settings(file()).rememberedRobots().isEmpty(),
                 "the simulator was added to the remembered robots");
    }

    void anInvalidAddressIsReportedBeforeConnecting_data() {
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
    void anInvalidAddressIsReportedBeforeConnecting() {
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

    void returnActsOnTheEnteredFields() {
        ConnectDialog dialog({});
        dialog.show();
        auto* host = dialog.findChild<QLineEdit*>("robotHost");
        auto* name = dialog.findChild<QLineEdit*>("robotName");
        QSignalSpy accepted(&dialog, &QDialog::accepted);
        QCOMPARE(dialog.focusWidget(), host);
        // While a name is entered, the simulator is not the default, and there is no address yet.
        QTest::keyClicks(name, "Left arm");
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(accepted.size(), 0);
        QVERIFY(!dialog.findChild<QPushButton*>("startSimulator")->isDefault());
        QTest::keyClicks(host, "192.168.0.10");
        QVERIFY(dialog.findChild<QPushButton*>("connectRobot")->isDefault());
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(accepted.size(), 1);
        QVERIFY(dialog.choice() == ConnectDialog::Choice::Robot);
        QCOMPARE(dialog.address().name, QStringLiteral("Left arm"));
    }

    void rememberedRobotsAreOfferedFirst() {
        const QVector<RobotAddress> robots = {{"Left arm", "192.168.0.10", 0, false},
                                              {"Right arm", "192.168.0.11", 100, false}};
        ConnectDialog dialog(robots);
        dialog.show();
        QCOMPARE(dialog.focusWidget(), dialog.findChild<QLineEdit*>("robotHost"));
        auto* key = dialog.findChild<QPushButton*>("connectRobot");
        QVERIFY(key->isDefault() && key->property("primary").toBool());
        QVERIFY(dialog.findChild<QListWidget*>("rememberedRobots")->mapTo(&dialog, QPoint()).y() <
                dialog.findChild<QPushButton*>("startSimulator")->mapTo(&dialog, QPoint()).y());
        QTest::keyClick(dialog.focusWidget(), Qt::Key_Return);
        QVERIFY(dialog.choice() == ConnectDialog::Choice::Robot);
        QCOMPARE(dialog.address().host, QStringLiteral("192.168.0.10"));
    }

    void aDifferentAddressIsADifferentRobot() {
        const QVector<RobotAddress> robots = {{"Left arm", "192.168.0.10", 0, false},
                                              {"Right arm", "192.168.0.11", 100, false}};
        ConnectDialog dialog(robots);
        dialog.show();
        auto* host = dialog.findChild<QLineEdit*>("robotHost");
        auto* name = dialog.findChild<QLineEdit*>("robotName");
        const auto enter = [host](const QString& address) {
            host->selectAll();
            QTest::keyClicks(host, address);
        };
        QCOMPARE(name->text(), QStringLiteral("Left arm"));
        enter("192.168.0.77");
        QCOMPARE(dialog.address().name, QStringLiteral("192.168.0.77"));
        QCOMPARE(dialog.address().portOffset, 0);
        // A remembered robot keeps its name and ports.
        enter("192.168.0.11");
        QCOMPARE(dialog.address().name, QStringLiteral("Right arm"));
        QCOMPARE(dialog.address().portOffset, 100);
        // An entered name is kept.
        name->selectAll();
        QTest::keyClicks(name, "Bench");
        enter("192.168.0.78");
        QCOMPARE(dialog.address().name, QStringLiteral("Bench"));
    }

    void aRobotCanBeForgotten() {
        app::Settings settings(file());
        settings.rememberRobot({"Right arm", "192.168.0.11", 0, false});
        settings.rememberRobot({"Wrong arm", "192.168.0.99", 0, false});
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.askForRobot();
        auto* dialog = window.findChild<ConnectDialog*>();
        auto* list = dialog->findChild<QListWidget*>("rememberedRobots");
        QCOMPARE(list->count(), 2);
        QVERIFY(QTest::qWaitForWindowActive(dialog));
        list->setFocus();
        list->setCurrentRow(0);
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(list->count(), 1);
        QCOMPARE(dialog->address().name, QStringLiteral("Right arm"));
        const QVector<RobotAddress> robots = app::Settings(file()).rememberedRobots();
        QCOMPARE(robots.size(), 1);
        QCOMPARE(robots.first().host, QStringLiteral("192.168.0.11"));
        QTest::mouseClick(dialog->findChild<QPushButton*>("forgetRobot"), Qt::LeftButton);
        QVERIFY(app::Settings(file()).rememberedRobots().isEmpty());
        QVERIFY(!list->isVisible());
        dialog->reject();
    }

    void onlyARobotThatAnsweredIsRemembered() {
        simulator::SimulatorOptions options;
        options.anyFreePorts = false;
        options.listenAddress = QStringLiteral("127.0.0.62");
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.connectRobot({"Nobody", "127.0.0.254", 0, false});
        QVERIFY(window.session().state().link != LinkState::Disconnected);
        QVERIFY(app::Settings(file()).rememberedRobots().isEmpty());
        window.connectRobot({"Bench", "127.0.0.62", 0, false});
        QTRY_COMPARE_WITH_TIMEOUT(window.session().state().link, LinkState::Live, 30'000);
        QTRY_COMPARE_WITH_TIMEOUT(app::Settings(file()).rememberedRobots().size(), 1, 60'000);
        QCOMPARE(app::Settings(file()).rememberedRobots().first().name, QStringLiteral("Bench"));
    }

    // Connects as with --robot ADDRESS.
    void aKnownAddressKeepsItsName() {
        simulator::SimulatorOptions options;
        options.anyFreePorts = false;
        options.listenAddress = QStringLiteral("127.0.0.63");
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        app::Settings(file()).rememberRobot({"Left arm", "127.0.0.63", 0, false});
        app::MainWindow window{app::Settings(file())};
        window.show();
        window.connectToHost(QStringLiteral("127.0.0.63"));
        QTRY_COMPARE_WITH_TIMEOUT(window.session().state().link, LinkState::Live, 60'000);
        QCOMPARE(window.session().state().robotName, QStringLiteral("Left arm"));
        QCOMPARE(app::Settings(file()).rememberedRobots().size(), 1);
        QCOMPARE(app::Settings(file()).rememberedRobots().first().name, QStringLiteral("Left arm"));
        QCOMPARE(app::Settings(file()).robotAt(QStringLiteral("127.0.0.64")).name,
                 QStringLiteral("127.0.0.64"));
    }

    void aRobotIsCheckedBeforeConnecting() {
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
        QVERIFY2(app::Settings(file()).rememberedRobots().isEmpty(),
                 "a robot that did not respond was added to the remembered robots");
    }

    void theSelectorListsTheNewestRobotFirst() {
        app::Settings settings(file());
        for (int i = 0; i < 12; ++i) {
            settings.rememberRobot(
                {QStringLiteral("Arm %1").arg(i), QStringLiteral("127.0.1.%1").arg(i), 0, false});
        }
        settings.rememberRobot({"Arm 9", "127.0.1.9", 0, false});
        VirtualClock clock;
        app::MainWindow window(app::Settings(file()), clock);
        window.show();
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

    void theLastProjectIsReopened() {
        const QString folder = folder_.path();
        const Home home(folder);
        const app::Settings settings(file());
        // Without a project, a file in the documents folder is used, where the user can find it.
        const QString first = app::startProject(settings).path;
        QCOMPARE(first, folder + "/Documents/Tiller/cell.tiller");
        QVERIFY(QFileInfo(first).absoluteDir().exists());
        const QString mine = folder_.filePath("mine.tiller");
        {
            VirtualClock clock;
            app::MainWindow window(settings, clock);
            window.openProject(first);
            window.files().saveAs(mine);
        }
        QCOMPARE(app::startProject(settings).path, mine);
        QVERIFY(app::startProject(settings).missing.isEmpty());
        // If the file is missing, the previous file or a new file is used, and the user is informed.
        QVERIFY(QFile::rename(mine, mine + ".away"));
        QCOMPARE(app::startProject(settings).path, first);
        QCOMPARE(app::startProject(settings).missing, mine);
    }

    void aProjectInTheFolderOfEarlierVersionsIsFound() {
        const Home home(folder_.path());
        const QDir data(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
        QVERIFY2(data.path().startsWith(folder_.path()), qPrintable(data.path()));
        QVERIFY(QDir().mkpath(data.path()));
        QFile hidden(data.filePath("cell.tiller"));
        QVERIFY(hidden.open(QIODevice::WriteOnly));
        hidden.close();
        QCOMPARE(app::startProject(app::Settings(file())).path, hidden.fileName());
        QVERIFY(hidden.remove());
    }

    void recentProjectsAreListedInTheProjectMenu() {
        VirtualClock clock;
        app::MainWindow window(app::Settings(file()), clock);
        QStringList paths;
        for (int i = 0; i < 3; ++i) {
            paths << folder_.filePath(QStringLiteral("cell-%1.tiller").arg(i));
            window.files().saveAs(paths.last());
        }
        auto* menu = window.findChild<QMenu*>("menu.project.recent");
        QVERIFY(menu != nullptr && menu->isEnabled());
        QCOMPARE(menu->actions().size(), 2);  // the menu does not offer the open project
        QVERIFY(menu->actions().first()->text().contains("cell-1.tiller"));
        menu->actions().first()->trigger();
        QCOMPARE(window.files().store().path(), paths[1]);
        QVERIFY(menu->actions().first()->text().contains("cell-2.tiller"));
        QCOMPARE(app::Settings(file()).recentProjects().first(), paths[1]);
    }

    void aCustomShortcutForOpenIsKeptAfterItsMove() {
        {
            QSettings settings(file(), QSettings::IniFormat);
            settings.setValue("shortcuts/waypoint.action.open", "Ctrl+Alt+O");
        }
        VirtualClock clock;
        const app::MainWindow window(app::Settings(file()), clock);
        QCOMPARE(window.actions().find("project.open")->shortcut(), QKeySequence("Ctrl+Alt+O"));
    }

    void aDamagedRobotListLosesNoOtherSettings() {
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
