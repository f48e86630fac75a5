// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/demonstration.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTextStream>

#include "app/main_window.h"
#include "robot/core/atomic_file.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/texts.h"

namespace tiller::app {
namespace {

constexpr int kPollMs = 10;
constexpr double kJogMm = 50.0;
constexpr int kStandingMs = 1500;
constexpr int kMaxPressRepeats = 10;
constexpr int kShortJogMs = 300;
constexpr QSize kPictureSize{1920, 1080};

void sendMouse(QWidget& widget, QEvent::Type type) {
    const QPointF centre = QRectF(widget.rect()).center();
    const bool down = type == QEvent::MouseButtonPress;
    QMouseEvent event(type, centre, widget.mapToGlobal(centre), Qt::LeftButton,
                      down ? Qt::MouseButtons(Qt::LeftButton) : Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

double distanceMm(const Pose& a, const Pose& b) {
    return 1000.0 * (a.position - b.position).norm();
}

}  // namespace

Demonstration::Demonstration(MainWindow& window, const QString& folder, QObject* parent)
    : QObject(parent), window_(window), folder_(folder) {
    timer_.setInterval(kPollMs);
    connect(&timer_, &QTimer::timeout, this, &Demonstration::poll);
    connect(&window_.session(), &RobotSession::motionStopped, this,
            [this](const control::StopMeasurement& stop) {
                if (jogStop_.count == 0 && stop.cause == control::StopCause::Released) {
                    jogStop_ = stop;
                }
            });
    connect(&window_.session().journal(), &Journal::added, this, [this](const JournalEvent& event) {
        if (event.isMessage() && event.severity != Severity::Info) {
            troubles_ << event.text;
        }
    });
    addSteps();
}

void Demonstration::start() {
    if (!folder_.mkpath(QStringLiteral("."))) {
        fail(tr("Cannot create the folder %1. Choose a folder that you have permission to write to.")
                 .arg(folder_.path()));
        finish();
        return;
    }
    // A key-state check would fail, because the demonstration generates mouse events without pressing a
    // physical button.
    window_.setKeyStateProbe(KeyStateProbe::none());
    timer_.start();
}

void Demonstration::addSteps() {
    const auto state = [this]() -> const SessionState& { return window_.session().state(); };

    steps_.push_back({tr("connect"), [this] { window_.connectSimulator(); },
                      [=] { return state().link == LinkState::Live; }});
    steps_.push_back(
        {tr("power on"), [this] { window_.session().services().perform(RobotCommand::PowerOn); },
         [=] { return state().robotMode == RobotMode::Idle || state().robotMode == RobotMode::Running; },
         30'000});
    steps_.push_back({tr("release the brakes"),
                      [this] { window_.session().services().perform(RobotCommand::ReleaseBrakes); },
                      [=] { return state().robotMode == RobotMode::Running; }, 30'000});
    steps_.push_back(
        {tr("take control"), [this] { window_.session().takeControl(); }, [=] { return state().canMove(); }});
    steps_.push_back(
        {tr("start recording"),
         [this] { window_.session().recording().start(folder_.filePath(QStringLiteral("recording.csv"))); },
         [=] { return state().recording.active && state().recording.rows > 0; }});
    steps_.push_back({tr("teach the first waypoint"), [this] { click(QStringLiteral("waypoint.teach")); },
                      [this] { return window_.waypointCount() == 1; }});
    const auto pressAgain = [this](const QString& key) {
        return [this, key] {
            release(key);
            press(key);
        };
    };
    const QString jogKey = QStringLiteral("jog.X+");
    steps_.push_back({tr("jog X+ in Base for 50 mm"),
                      [this, state, jogKey] {
                          jogStart_ = state().tcpPose;
                          press(jogKey);
                      },
                      [this, state] { return distanceMm(state().tcpPose, jogStart_) >= kJogMm; }, 10'000,
                      pressAgain(jogKey)});
    steps_.push_back({tr("release the jog button"), [this, jogKey] { release(jogKey); },
                      [this, state] {
                          if (jogStop_.count == 0 || state().moving) {
                              return false;
                          }
                          jogEnd_ = state().tcpPose;
                          return true;
                      },
                      10'000, [this, jogKey] {  // repeated press after an unexpected stop
                          press(jogKey);
                          QTimer::singleShot(kShortJogMs, this, [this, jogKey] { release(jogKey); });
                      }});
    steps_.push_back({tr("teach the second waypoint"), [this] { click(QStringLiteral("waypoint.teach")); },
                      [this] { return window_.waypointCount() == 2; }});
    const QString goKey = QStringLiteral("waypoint.goTo");
    steps_.push_back(
        {tr("move to the first waypoint (button held)"),
         [this, goKey] {
             window_.selectWaypoint(0);
             press(goKey);
         },
         [this, state] { return distanceMm(state().tcpPose, jogStart_) < 0.5 && !state().moving; }, 20'000,
         pressAgain(goKey)});
    steps_.push_back({tr("release the “Go to” button"), [this, goKey] { release(goKey); },
                      [=] { return !state().moving; }});
    steps_.push_back({tr("digital output 0 on"),
                      [this] {
                          window_.showTab(QStringLiteral("io"));
                          click(QStringLiteral("io.DO0"));
                      },
                      [=] { return (state().digitalOutputs & 1U) != 0; }});
    steps_.push_back({tr("digital output 0 off"), [this] { click(QStringLiteral("io.DO0")); },
                      [=] { return (state().digitalOutputs & 1U) == 0; }});
    steps_.push_back({tr("take the screenshots"),
                      [this] {
                          window_.showTab(QStringLiteral("waypoints"));
                          window_.selectWaypoint(1);
                          if (!saveScreenshots()) {
                              fail(tr("Cannot write the screenshots to %1. Check the permissions of the "
                                      "folder and the free disk space.")
                                       .arg(folder_.path()));
                          }
                      },
                      [] { return true; }});
    steps_.push_back({tr("stop recording"), [this] { window_.session().recording().stop(); },
                      [=] { return !state().recording.active && state().recording.error.isEmpty(); }});
}

void Demonstration::poll() {
    if (!failed_.isEmpty() || current_ >= steps_.size()) {
        finish();
        return;
    }
    const Step& step = steps_[current_];
    if (!begun_) {
        begun_ = true;
        elapsed_.start();
        standing_.start();
        step.begin();
        return;
    }
    if (step.done()) {
        done_ << step.name;
        ++current_;
        begun_ = false;
        return;
    }
    pressAgainIfStopped(step);
    if (elapsed_.elapsed() > step.timeoutMs) {
        const SessionState& state = window_.session().state();
        fail(tr("%1: not completed within %2 s (%3)")
                 .arg(step.name)
                 .arg(step.timeoutMs / 1000)
                 .arg(state.controlReason.isEmpty() ? tr("the robot reported no reason")
                                                    : state.controlReason));
    }
}

void Demonstration::pressAgainIfStopped(const Step& step) {
    if (!step.restart || window_.session().state().moving) {
        standing_.start();
        return;
    }
    if (standing_.elapsed() > kStandingMs && repeatedPresses_ < kMaxPressRepeats) {
        ++repeatedPresses_;
        step.restart();
        standing_.start();
        elapsed_.start();
    }
}

void Demonstration::finish() {
    timer_.stop();
    if (!failed_.isEmpty()) {
        window_.session().stop(control::StopCause::ApiCall);
        window_.session().recording().stop();
    }
    (void)writeFileAtomically(folder_.filePath(QStringLiteral("summary.txt")), summary().toUtf8());
    Q_EMIT finished(succeeded());
}

QString Demonstration::summary() const {
    const SessionState& state = window_.session().state();
    QString text;
    QTextStream out(&text);
    for (const QString& name : done_) {
        out << "done    " << name << '\n';
    }
    if (!failed_.isEmpty()) {
        out << "FAILED  " << failed_ << '\n';
    }
    for (const QString& trouble : troubles_) {
        out << "log     " << trouble << '\n';
    }
    if (repeatedPresses_ > 0) {
        out << tr("pressed again        %1 times: the motion had stopped before the button was released")
                   .arg(repeatedPresses_)
            << '\n';
    }
    out.setRealNumberNotation(QTextStream::FixedNotation);
    out.setRealNumberPrecision(1);
    if (jogEnd_) {
        out << tr("jogged               ") << distanceMm(jogStart_, *jogEnd_) << " mm\n"
            << tr("release to standstill ") << jogStop_.durationMs << " ms, " << jogStop_.distanceMm
            << " mm\n";
    }
    out << tr("packets              ") << state.quality.all.packets << tr(" received, ")
        << state.quality.all.late << tr(" late, ") << state.quality.all.lost << tr(" lost\n")
        << tr("recorded             ") << state.recording.rows << tr(" rows, ") << state.recording.seconds
        << " s\n"
        << tr("files                ") << folder_.absolutePath() << '\n';
    return text;
}

QWidget* Demonstration::find(const QString& key) {
    auto* widget = window_.findChild<QWidget*>(key);
    if (widget == nullptr) {
        fail(tr("the window has no button “%1”").arg(key));
    }
    return widget;
}

void Demonstration::press(const QString& key) {
    if (QWidget* widget = find(key)) {
        sendMouse(*widget, QEvent::MouseButtonPress);
    }
}

void Demonstration::release(const QString& key) {
    if (QWidget* widget = find(key)) {
        sendMouse(*widget, QEvent::MouseButtonRelease);
    }
}

void Demonstration::click(const QString& key) {
    press(key);
    release(key);
}

void Demonstration::fail(const QString& what) {
    if (failed_.isEmpty()) {
        failed_ = what;
    }
}

bool Demonstration::saveScreenshots() {
    window_.resize(kPictureSize);
    bool saved = true;
    for (const auto& [theme, file] :
         {std::pair{"light", "screenshot-light.png"}, std::pair{"dark", "screenshot-dark.png"}}) {
        window_.setTheme(QString::fromLatin1(theme));
        QApplication::processEvents();
        saved = window_.grab().save(folder_.filePath(QString::fromLatin1(file))) && saved;
    }
    return saved;
}

}  // namespace tiller::app

#include "moc_demonstration.cpp"
