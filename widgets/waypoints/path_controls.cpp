// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/path_controls.h"

#include <QAction>
#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <algorithm>
#include <iterator>
#include <utility>

#include "robot/core/angles.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

constexpr double kTolerances[] = {0.0005, 0.001, 0.002, 0.005, 0.010};  // [m]
constexpr int kUsualTolerance = 2;
constexpr double kJointTolerance = 1;  // [deg]

}  // namespace

PathControls::PathControls(RobotSession& session, ProjectDocument& document, Selection selection,
                           QWidget* parent)
    : QWidget(parent)
    , selection_(std::move(selection))
    , recorder_(session, document)
    , record_(new QPushButton)
    , tolerances_(new QMenu(tr("Path tolerance"), this)) {
    record_->setObjectName(QStringLiteral("waypoint.recordPath"));
    record_->setFocusPolicy(Qt::TabFocus);  // a click does not move the focus away from the list
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 12, 8);
    layout->addWidget(record_);
    addAction(QStringLiteral("waypoint.action.recordPath"), tr("Record path"), [this] { toggle(); });
    addAction(QStringLiteral("waypoint.action.exportPath"), tr("Export path as CSV…"),
              [this] { askForExport(); });
    addAction(QStringLiteral("waypoint.action.importPath"), tr("Import path from CSV…"),
              [this] { askForImport(); });
    auto* group = new QActionGroup(this);
    for (int i = 0; i < static_cast<int>(std::size(kTolerances)); ++i) {
        QAction* action = tolerances_->addAction(format::shortLength(kTolerances[i]));
        action->setObjectName(QStringLiteral("waypoint.tolerance.%1").arg(i));
        action->setCheckable(true);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, i] {
            recorder_.setTolerance({toRadians(kJointTolerance), kTolerances[i]});
        });
        if (i == kUsualTolerance) {
            action->trigger();
        }
    }
    connect(tolerances_, &QMenu::aboutToShow, this, [group] {
        for (int i = 0; i < static_cast<int>(std::size(kTolerances)); ++i) {
            group->actions().at(i)->setText(format::shortLength(kTolerances[i]));
        }
    });
    connect(record_, &QPushButton::clicked, this, &PathControls::toggle);
    connect(&recorder_, &PathRecorder::changed, this, &PathControls::show);
    connect(&recorder_, &PathRecorder::kept, this, &PathControls::kept);
    connect(&recorder_, &PathRecorder::refused, this, &PathControls::refused);
    connect(&recorder_, &PathRecorder::ended, this, [this] {
        const bool isFull = recorder_.seconds() > PathRecorder::kLongest;
        recorder_.stop(selection_.currentRow());
        Q_EMIT refused(isFull ? tr("Path recording stopped because the maximum duration of ten minutes was "
                                   "reached.")
                              : tr("Path recording stopped because the robot stopped sending data or was "
                                   "restarted."),
                       tr("The path recorded so far is kept."));
    });
    show();
}

QAction* PathControls::addAction(const QString& name, const QString& text, const std::function<void()>& run) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setAutoRepeat(false);
    connect(action, &QAction::triggered, this, [run] { run(); });
    actions_.append(action);
    return action;
}

void PathControls::setState(const SessionState& state) {
    if (const bool live = state.link == LinkState::Live; live != live_) {
        live_ = live;
        show();
    }
}

void PathControls::toggle() {
    if (recorder_.isRecording()) {
        recorder_.stop(selection_.currentRow());
    } else {
        recorder_.start();
        if (recorder_.isRecording()) {
            Q_EMIT reported(
                tr("The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop "
                   "recording path” in the menu."));
        }
    }
}

QString PathControls::recordingText() const {
    const int seconds = static_cast<int>(recorder_.seconds());
    return recorder_.isRecording() ? QStringLiteral("● REC %1:%2")
                                         .arg(seconds / 60, 2, 10, QLatin1Char('0'))
                                         .arg(seconds % 60, 2, 10, QLatin1Char('0'))
                                   : QString();
}

void PathControls::show() {
    const bool recording = recorder_.isRecording();
    record_->setText(recording ? recordingText() : tr("○ Path"));
    record_->setAccessibleName(recording ? tr("Stop recording path") : tr("Record path"));
    const QString obstacle = recorder_.isBusy()   ? tr("Simplifying the path…")
                             : live_ || recording ? QString()
                                                  : tr("No path can be recorded because the robot is not "
                                                       "sending data. Wait for data, or connect a robot.");
    record_->setEnabled(obstacle.isEmpty());
    record_->setToolTip(!obstacle.isEmpty() ? obstacle
                        : recording
                            ? tr("Stops recording and stores the path as waypoints")
                            : tr("Records the path of the arm during Freedrive or jogging and stores it as "
                                 "waypoints. Press again to stop. Recording does not move the robot."));
    actions_.first()->setText(recording ? tr("Stop recording path") : tr("Record path"));
    actions_.first()->setEnabled(obstacle.isEmpty());
    // Reserve the width of the longest text, so that adjacent elements do not move.
    const QString now = record_->text();
    int widest = record_->sizeHint().width();
    record_->setText(recording ? tr("○ Path") : QStringLiteral("● REC 00:00"));
    widest = std::max(widest, record_->sizeHint().width());
    record_->setText(now);
    record_->setMinimumWidth(widest);
}

void PathControls::askForExport() {
    if (selection_.rows().size() < 2) {
        Q_EMIT refused(tr("Select at least two waypoints of the path."), {});
        return;
    }
    const QString path = QFileDialog::getSaveFileName(window(), tr("Export path"), QStringLiteral("path.csv"),
                                                      tr("CSV file (*.csv)"));
    if (!path.isEmpty()) {
        exportTo(path);
    }
}

void PathControls::exportTo(const QString& path) {
    const QList<int> rows = selection_.rows();
    if (const Result<void> done = recorder_.exportTo(path, rows); !done) {
        const bool said = done.error().code == ErrorCode::InvalidArgument;
        Q_EMIT refused(said ? done.error().context : tr("The path was not exported."),
                       said ? QString() : texts::errorText(done.error()));
        return;
    }
    Q_EMIT reported(tr("%n waypoints exported as a path to %1", nullptr, static_cast<int>(rows.size()))
                        .arg(QFileInfo(path).fileName()));
}

void PathControls::askForImport() {
    const QString path =
        QFileDialog::getOpenFileName(window(), tr("Import path"), {}, tr("CSV file (*.csv)"));
    if (!path.isEmpty()) {
        importFrom(path);
    }
}

void PathControls::importFrom(const QString& path) {
    recorder_.importFrom(path, selection_.currentRow());
}

}  // namespace tiller

#include "moc_path_controls.cpp"
