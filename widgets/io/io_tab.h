// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "I/O" shows all digital and analog inputs and outputs of controller and tool by number and name,
// and the general purpose registers. A click switches an output, which shows "pending" until the robot
// reports the new state. Outputs can also be set while a program is running.

#include <QMap>
#include <QTimer>
#include <QVector>
#include <QWidget>
#include <functional>
#include <utility>

#include "robot/core/clock.h"
#include "robot/station/history/replay_moment.h"
#include "robot/station/link/robot_session.h"

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace tiller {

class AnalogRow;
class IoChannel;
class EmptyState;
class NoticeBar;
class RegisterPanel;
class ReplayBand;

class IoTab : public QWidget {
    Q_OBJECT

public:
    static constexpr int kChannels = 18;  ///< 0-7 standard, 8-15 configurable, 16-17 tool

    explicit IoTab(RobotSession& session, QWidget* parent = nullptr);

    /// For tests: replace the receiver of output commands, and the clock.
    void setOutputSetter(std::function<void(int output, bool on)> setter) { setOutput_ = std::move(setter); }
    void setClock(const Clock& clock) { clock_ = &clock; }

    IoChannel* input(int channel) const { return inputs_[channel]; }
    IoChannel* output(int channel) const { return outputs_[channel]; }
    /// channel  0, 1 standard; 2, 3 tool (inputs only)
    AnalogRow* analogInput(int channel) const { return analogInputs_[channel]; }
    AnalogRow* analogOutput(int channel) const { return analogOutputs_[channel]; }
    RegisterPanel* registers() const { return registers_; }
    /// Shows past inputs and outputs with their time, and disables switching outputs. An empty replay shows
    /// live data.
    void setReplay(const Replay& moment);
    /// Shows only rows with this text in the terminal or the name.
    void search(const QString& text);
    void focusSearch();
    static constexpr int kPulseMs = 500;

    /// Commands that rename, switch or pulse the row with the focus. If no row has the focus, they show a
    /// hint.
    void renameChosen();
    void switchChosen();
    void pulseChosen();

    /// The user's names by terminal: "DI 0", "CI 3", "TO 1" and so on.
    QMap<QString, QString> names() const;
    void setNames(const QMap<QString, QString>& names);
    /// The label of the terminal, e.g. "DI 0".
    static QString terminal(bool output, int channel);

Q_SIGNALS:
    void namesChanged();
    /// The user wants to return from past to live data.
    void liveWanted();

private:
    QWidget* buildColumn(bool output);
    void refresh();
    void toggle(int output);
    void pulse(int output);
    void ask(int output, bool on);
    /// Returns the output with the focus if it can be switched. Otherwise, shows a hint and returns -1.
    int chosenOutput();
    void showNoSelection();
    void buildAnalog(QVBoxLayout* layout);
    void refreshAnalog(bool known, bool stale);

    RobotSession& session_;
    std::function<void(int, bool)> setOutput_;
    const Clock* clock_ = &SteadyClock::shared();
    SessionState state_;
    receive::Sample sample_;  ///< sample from which state_ was created
    Replay replay_;
    ReplayBand* replayBand_ = nullptr;
    QTimer refreshTimer_;
    QVector<IoChannel*> inputs_;
    QVector<IoChannel*> outputs_;
    QVector<AnalogRow*> analogInputs_;
    QVector<AnalogRow*> analogOutputs_;
    QLabel* analogHeading_ = nullptr;
    QLabel* registerHeading_ = nullptr;
    RegisterPanel* registers_ = nullptr;
    QVector<QLabel*> headings_;  ///< headings of the digital groups, by column and group
    QLineEdit* search_;
    EmptyState* nothing_ = nullptr;
    NoticeBar* notice_;

    struct Pending {
        bool wanted = false;
        std::int64_t sinceNs = 0;
    };
    QMap<int, Pending> pending_;
    /// Output in the notice, and its requested state.
    std::pair<int, bool> unconfirmed_{-1, false};
};

}  // namespace tiller
