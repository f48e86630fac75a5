// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "I/O": every digital input and output of the controller and the tool by number and name. A click
// switches an output; it says "pending" until the robot itself reports the new state.

#include <QMap>
#include <QTimer>
#include <QVector>
#include <QWidget>
#include <functional>

#include "robot/core/clock.h"
#include "widgets/session/robot_session.h"

class QLabel;

namespace tiller {

class IoChannel;

class IoTab : public QWidget {
    Q_OBJECT

public:
    static constexpr int kChannels = 18;  ///< 0-7 standard, 8-15 configurable, 16-17 tool

    explicit IoTab(RobotSession& session, QWidget* parent = nullptr);

    /// For tests: where a click goes, instead of the session, and what time is.
    void setOutputSetter(std::function<void(int output, bool on)> setter) { setOutput_ = std::move(setter); }
    void setClock(const Clock& clock) { clock_ = &clock; }

    IoChannel* input(int channel) const { return inputs_[channel]; }
    IoChannel* output(int channel) const { return outputs_[channel]; }

    /// The operator's own names, by "DI 0", "CI 3", "TO 1" and so on.
    QMap<QString, QString> names() const;
    void setNames(const QMap<QString, QString>& names);
    /// "DI 0": what is printed on the terminal.
    static QString terminal(bool output, int channel);

Q_SIGNALS:
    void namesChanged();

private:
    QWidget* buildColumn(bool output);
    void refresh();
    void toggle(int output);

    RobotSession& session_;
    std::function<void(int, bool)> setOutput_;
    const Clock* clock_ = &SteadyClock::shared();
    SessionState state_;
    QTimer refreshTimer_;
    QVector<IoChannel*> inputs_;
    QVector<IoChannel*> outputs_;
    QLabel* notice_;

    struct Pending {
        bool wanted = false;
        std::int64_t sinceNs = 0;
    };
    QMap<int, Pending> pending_;
};

}  // namespace tiller
