// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scripted demonstration operates the main window with the simulated robot by sending mouse events to its
// widgets. It writes screenshots, a recording, and a summary with the result of each step.

#include <QDir>
#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "robot/core/spatial.h"
#include "robot/station/link/session_state.h"

class QWidget;

namespace tiller::app {

class MainWindow;

class Demonstration : public QObject {
    Q_OBJECT

public:
    /// folder  folder for the files; created if missing
    Demonstration(MainWindow& window, const QString& folder, QObject* parent = nullptr);

    void start();
    bool succeeded() const { return failed_.isEmpty(); }
    /// The printed results of the steps, one per line.
    QString summary() const;

Q_SIGNALS:
    void finished(bool succeeded);

private:
    struct Step {
        QString name;
        std::function<void()> begin;
        std::function<bool()> done;
        int timeoutMs = 10'000;
        /// Repeats the motion if the arm stops before the step is complete. Used only for steps that move the
        /// arm: on a busy computer, a blocked event loop or outdated data may end a jog early.
        std::function<void()> restart = {};
    };

    void addSteps();
    void poll();
    void pressAgainIfStopped(const Step& step);
    void finish();
    void press(const QString& key);
    void release(const QString& key);
    void click(const QString& key);
    QWidget* find(const QString& key);
    void fail(const QString& what);
    bool saveScreenshots();

    MainWindow& window_;
    QDir folder_;
    std::vector<Step> steps_;
    std::size_t current_ = 0;
    bool begun_ = false;
    QTimer timer_;
    QElapsedTimer elapsed_;
    QElapsedTimer standing_;  ///< time since the last motion or key press
    int repeatedPresses_ = 0;
    QStringList done_;
    QString failed_;
    QStringList troubles_;  ///< warnings and errors reported by the session

    Pose jogStart_;
    std::optional<Pose> jogEnd_;  ///< pose at standstill after the jog
    control::StopMeasurement jogStop_;
};

}  // namespace tiller::app
