// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/desktop/desktop_cell.h"

#include <signal.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTcpSocket>
#include <QTest>
#include <algorithm>

namespace tiller::test {
namespace {

constexpr int kStartMs = 60'000;
constexpr int kAddresses = 40;

QProcessEnvironment environmentWith(const QString& home, const QString& display) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DISPLAY", display);
    environment.insert("HOME", home);
    for (const char* folder : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) {
        const QString path = home + '/' + QString::fromLatin1(folder).toLower();
        QDir().mkpath(path);
        QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        environment.insert(folder, path);
    }
    environment.insert("LC_ALL", "C.UTF-8");
    environment.insert("QT_QPA_PLATFORM", "xcb");
    environment.remove("WAYLAND_DISPLAY");
    // Makes the tests independent of the desktop's theme and of the message bus of the user who runs them.
    environment.insert("QT_QPA_PLATFORMTHEME", "none");
    environment.insert("DBUS_SESSION_BUS_ADDRESS", "disabled:");
    return environment;
}

}  // namespace

// ---- Child

Child::~Child() {
    if (process_.state() == QProcess::NotRunning) {
        return;
    }
    signal(SIGCONT);
    process_.terminate();
    if (!process_.waitForFinished(5000)) {
        process_.kill();
        process_.waitForFinished(5000);
    }
}

bool Child::start(const QString& program, const QStringList& arguments,
                  const QProcessEnvironment& environment) {
    output_.clear();
    process_.setProcessEnvironment(environment);
    process_.setProcessChannelMode(QProcess::MergedChannels);
    process_.start(program, arguments);
    return process_.waitForStarted(kStartMs);
}

QString Child::output() {
    output_ += process_.readAll();
    return QString::fromUtf8(output_);
}

QString Child::waitForLine(const QString& beginning) {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < kStartMs) {
        QStringList lines = output().split('\n');
        lines.removeLast();  // the last line is not complete yet
        for (const QString& line : std::as_const(lines)) {
            if (line.startsWith(beginning)) {
                return line;
            }
        }
        if (!isRunning()) {
            break;
        }
        process_.waitForReadyRead(50);
    }
    return {};
}

void Child::signal(int number) {
    if (process_.processId() > 0) {
        ::kill(pid_t(process_.processId()), number);
    }
}

double Child::withoutProcessor() const {
    QFile file(QStringLiteral("/proc/%1/schedstat").arg(process_.processId()));
    return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(1).toDouble() * 1e-9 : 0;
}

// ---- DesktopCell

namespace {

/// Describes how a window manager is started.
struct WindowManager {
    QString name;
    QStringList arguments;
    bool needsBus = false;  ///< needs a separate message bus
};

WindowManager windowManagerOf(const QString& name) {
    for (const WindowManager& each : {WindowManager{"xfwm4", {"--compositor=off"}, true},
                                      WindowManager{"metacity", {"--no-composite"}}}) {
        if (each.name == name) {
            return each;
        }
    }
    return {DesktopCell::kOpenbox, {"--config-file", TILLER_OPENBOX_CONFIG}};
}

}  // namespace

QString DesktopCell::obstacle(const QString& windowManager) {
    QStringList tools{"Xvfb", "setxkbmap", "xkbcomp", windowManager};
    if (windowManagerOf(windowManager).needsBus) {
        tools << "dbus-run-session";
    }
    for (const QString& tool : tools) {
        if (QStandardPaths::findExecutable(tool).isEmpty()) {
            return QStringLiteral("%1 is not installed; packaging/dependencies lists what the tests need")
                .arg(tool);
        }
    }
    return {};
}

DesktopCell::DesktopCell(QSize screen, const QString& windowManager)
    : screen_(screen), windowManagerName_(windowManager) {}

DesktopCell::~DesktopCell() {
    if (hand_) {
        display_.signal(SIGCONT);
        hand_->letGoOfAll();
    }
    arm_.reset();
    places_.reset();
    // The window must exit before its display. Otherwise, it would report a lost display.
    program_.signal(SIGCONT);
}

QProcessEnvironment DesktopCell::environment() const {
    return environmentWith(folder_.path(), displayName_);
}

bool DesktopCell::fail(const QString& what) {
    what_ = what;
    for (const auto& [name, child] : {std::pair{"display", &display_},
                                      {"window manager", &windowManager_},
                                      {"controller", &controller_},
                                      {"program", &program_}}) {
        if (const QString said = child->output().trimmed(); !said.isEmpty()) {
            what_ += QStringLiteral("\noutput of %1: %2").arg(QLatin1String(name), said.right(2000));
        }
    }
    return false;
}

bool DesktopCell::startDisplay() {
    // Xvfb chooses a free number and prints it.
    const QString size = QStringLiteral("%1x%2x24").arg(screen_.width()).arg(screen_.height());
    if (!display_.start("Xvfb", {"-displayfd", "1", "-screen", "0", size, "-nolisten", "tcp", "-noreset"},
                        QProcessEnvironment::systemEnvironment())) {
        return fail("Xvfb could not be started");
    }
    QString number;
    until(
        [&] {
            static const QRegularExpression digits("(?:^|\n)(\\d+)\n");
            number = digits.match(display_.output()).captured(1);
            return !number.isEmpty() || !display_.isRunning();
        },
        kStartMs);
    if (number.isEmpty()) {
        return fail("Xvfb did not print its display number");
    }
    displayName_ = ':' + number;
    hand_ = std::make_unique<XHand>(displayName_);
    if (!hand_->canDrive()) {
        return fail("the display cannot be driven: XTEST or XKEYBOARD is missing");
    }
    const WindowManager manager = windowManagerOf(windowManagerName_);
    const QStringList bus = manager.needsBus ? QStringList{"dbus-run-session", "--"} : QStringList();
    QStringList command = bus + QStringList{manager.name} + manager.arguments;
    const QString program = command.takeFirst();
    if (!windowManager_.start(program, command, environment())) {
        return fail(program + " could not be started");
    }
    // The window manager is ready when it has announced its desktops. openbox has several desktops.
    const int desktops = windowManagerName_ == kOpenbox ? 2 : 1;
    if (!until([&] { return hand_->desktopCount() >= desktops; })) {
        return fail(windowManagerName_ + " does not manage the display");
    }
    return setLayout("us");
}

bool DesktopCell::startController() {
    for (int last = 1; last <= kAddresses; ++last) {
        host_ = QStringLiteral("127.0.7.%1").arg(last);
        if (!controller_.start(TILLER_CLI, {"simulate", "--headless", "--listen", host_},
                               QProcessEnvironment::systemEnvironment())) {
            return fail("tiller-cli could not be started");
        }
        if (!controller_.waitForLine("ready").isEmpty()) {
            arm_ = std::make_unique<ArmWatch>(host_);
            return arm_->isConnected() || fail("the simulated controller sends nothing");
        }
        controller_.waitForEnd(kStartMs);  // another controller uses this address
    }
    return fail("no simulated controller could be started");
}

bool DesktopCell::startProgram() {
    const QString socket = folder_.filePath("places");
    QProcessEnvironment surroundings = environment();
    surroundings.insert("QT_PLUGIN_PATH", TILLER_TEST_PLUGINS);
    surroundings.insert("QT_QPA_GENERIC_PLUGINS", "window_places:" + socket);
    if (!program_.start(TILLER_PROGRAM, {"--robot", host_, "--project", folder_.filePath("test.tiller")},
                        surroundings)) {
        return fail("tiller could not be started");
    }
    places_ = std::make_unique<QLocalSocket>();
    const bool answers = until([&] {
        if (places_->state() != QLocalSocket::ConnectedState) {
            places_->connectToServer(socket);
            places_->waitForConnected(100);
        }
        return places_->state() == QLocalSocket::ConnectedState || !program_.isRunning();
    });
    if (!answers || !program_.isRunning()) {
        return fail("tiller does not report the position of its window");
    }
    if (!until([&] { return place("mainWindow").active; })) {
        return fail("the window did not become active");
    }
    return takeControl() || fail("the window did not take control");
}

bool DesktopCell::takeControl() {
    // While the window connects, there is no next step. Afterwards it is "Take control".
    return until([&] {
        if (place("jog.X+").enabled) {
            return true;
        }
        const Place step = place("nextStepButton");
        if (step.visible && step.enabled && step.text == "Take control") {
            click("nextStepButton");
        }
        return until([&] { return place("jog.X+").enabled; }, 1000);
    });
}

bool DesktopCell::bringUp() {
    return startDisplay() && startController() && startProgram();
}

bool DesktopCell::setLayout(const QString& layout) {
    QProcess setter;
    setter.start("setxkbmap", {"-display", displayName_, "-rules", "evdev", "-model", "pc105", "-layout",
                               layout, "-option", ""});
    return setter.waitForFinished(kStartMs) && setter.exitCode() == 0;
}

QByteArray DesktopCell::ask(const QString& request) {
    if (!places_ || places_->state() != QLocalSocket::ConnectedState) {
        return {};
    }
    places_->readAll();
    places_->write(request.toUtf8() + '\n');
    while (!places_->canReadLine()) {
        if (!places_->waitForReadyRead(kWaitTimeoutMs)) {
            return {};
        }
    }
    return places_->readLine().trimmed();
}

QString DesktopCell::surroundingsText() {
    const auto widget = [](const QJsonObject& described) {
        return QStringLiteral("%1 '%2'%3")
            .arg(described["type"].toString(), described["name"].toString(),
                 described["active"].toBool() ? " active" : "");
    };
    QStringList windows;
    for (const QJsonValue& window : QJsonDocument::fromJson(ask("windows")).array()) {
        windows.append(widget(window.toObject()));
    }
    return QStringLiteral("windows: %1; focus: %2; reason: %3; selected: %4")
        .arg(windows.join(", "), widget(QJsonDocument::fromJson(ask("focus")).object()),
             place("limiterLine").toolTip, QString::fromUtf8(ask("checked")));
}

Place DesktopCell::place(const QString& name) {
    Place place;
    const QJsonObject reported = QJsonDocument::fromJson(ask("widget " + name)).object();
    place.found = !reported.isEmpty();
    place.visible = reported["visible"].toBool();
    place.enabled = reported["enabled"].toBool();
    place.active = reported["active"].toBool();
    place.shaped = reported["shaped"].toBool();
    place.focus = reported["focus"].toBool();
    place.text = reported["text"].toString();
    place.toolTip = reported["toolTip"].toString();
    place.area = {reported["x"].toInt(), reported["y"].toInt(), reported["width"].toInt(),
                  reported["height"].toInt()};
    place.window = XHand::WindowId(reported["window"].toInteger());
    return place;
}

bool DesktopCell::until(const std::function<bool()>& condition, int ms) {
    QElapsedTimer time;
    time.start();
    while (!condition()) {
        if (time.elapsed() > ms) {
            return false;
        }
        QTest::qWait(5);
    }
    return true;
}

bool DesktopCell::click(const QString& name) {
    const Place there = place(name);
    if (!there.visible) {
        return false;
    }
    hand_->moveTo(there.middle());
    hand_->button(1, true);
    hand_->button(1, false);
    return true;
}

bool DesktopCell::toTheFront() {
    const Place window = place("mainWindow");
    if (window.active) {
        return true;
    }
    hand_->activate(window.window);
    return until([&] { return place("mainWindow").active; });
}

bool DesktopCell::armKeyboard() {
    // The shortcut may be lost while the window manager changes the focus.
    return until([&] {
        if (place("armedFrame").visible) {
            return true;
        }
        if (toTheFront()) {
            hand_->press(kControl);
            hand_->tap(kLetterJ);
            hand_->release(kControl);
        }
        return until([&] { return place("armedFrame").visible; }, 10'000);
    });
}

Standstill DesktopCell::standstill(double contract) {
    const auto waited = [this] { return display_.withoutProcessor() + program_.withoutProcessor(); };
    // Processor time that is missing after the last package with motion has not delayed the stop, so the
    // value is taken at that package. A process that has ended in the meantime has no statistics.
    const double before = waited();
    double most = before;
    Standstill result =
        arm_->standstill(contract, ArmWatch::kQuiet, [&] { most = std::max(most, waited()); });
    result.withoutProcessor = most - before;
    if (result.verdict == Standstill::Verdict::Late && result.seconds - result.withoutProcessor <= contract) {
        result.verdict = Standstill::Verdict::Stood;
    }
    return result;
}

bool DesktopCell::fault(const QString& words) {
    QTcpSocket socket;
    socket.connectToHost(host_, 29990);
    if (!socket.waitForConnected(kStartMs)) {
        return false;
    }
    socket.write(words.toUtf8() + '\n');
    while (!socket.canReadLine() && socket.waitForReadyRead(kStartMs)) {
    }
    return socket.readAll().startsWith("ok");
}

}  // namespace tiller::test
