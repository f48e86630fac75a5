// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scripted demonstration: the main window, used as a hand would use it (mouse events on the real keys),
// against the simulated robot. It leaves screenshots, a recording and a summary, and says for each step
// whether it happened.

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
    /// folder  where the files go; made if missing
    Demonstration(MainWindow& window, const QString& folder, QObject* parent = nullptr);

    void start();
    bool succeeded() const { return failed_.isEmpty(); }
    /// What happened, line by line, as printed.
    QString summary() const;

Q_SIGNALS:
    void finished(bool succeeded);

private:
    struct Step {
        QString name;
        std::function<void()> begin;
        std::function<bool()> done;
        int timeoutMs = 10'000;
        /// For a step that moves the arm: what a hand does when the arm stands before the step is done. A
        /// busy machine may end a jog (the event loop stalled, data grew old), and a stopped jog needs a new
        /// press.
        std::function<void()> anew = {};
    };

    void addSteps();
    void poll();
    void pressAnewIfStanding(const Step& step);
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
    QElapsedTimer standing_;  ///< since the arm moved last, or a key was pressed
    int pressedAnew_ = 0;
    QStringList done_;
    QString failed_;
    QStringList troubles_;  ///< warnings and errors the operator would have read

    Pose jogStart_;
    std::optional<Pose> jogEnd_;  ///< once it came to rest
    control::StopMeasurement jogStop_;
};

}  // namespace tiller::app
