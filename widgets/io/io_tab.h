// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "I/O": every digital and analog input and output of the controller and the tool by number and name,
// and the general purpose registers. A click switches an output; it says "pending" until the robot itself
// reports the new state. Setting an output goes past the programs on the robot: none of them stops for it.

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
class NothingFound;
class NoticeBar;
class RegisterPanel;
class ReplayBand;

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
    /// 0, 1 standard, 2, 3 tool
    AnalogRow* analogInput(int channel) const { return analogInputs_[channel]; }
    AnalogRow* analogOutput(int channel) const { return analogOutputs_[channel]; }
    RegisterPanel* registers() const { return registers_; }
    /// Shows what inputs and outputs were in a moment, and says so; nothing can be switched then. Nothing: live.
    void setReplay(const Replay& moment);
    /// Shows only what has this in its terminal or name.
    void search(const QString& text);
    void focusSearch();
    static constexpr int kPulseMs = 500;

    /// What the row that has the focus does with its own keys; says what to do where there is none.
    void renameChosen();
    void switchChosen();
    void pulseChosen();

    /// The operator's own names, by "DI 0", "CI 3", "TO 1" and so on.
    QMap<QString, QString> names() const;
    void setNames(const QMap<QString, QString>& names);
    /// "DI 0": what is printed on the terminal.
    static QString terminal(bool output, int channel);

Q_SIGNALS:
    void namesChanged();
    /// From a replay back to what is live.
    void liveWanted();

private:
    QWidget* buildColumn(bool output);
    void refresh();
    void toggle(int output);
    void pulse(int output);
    void ask(int output, bool on);
    /// The output that has the focus and can be switched; -1: none, which is said.
    int chosenOutput();
    void sayNothingChosen();
    void buildAnalog(QVBoxLayout* layout);
    void refreshAnalog(bool known, bool stale);

    RobotSession& session_;
    std::function<void(int, bool)> setOutput_;
    const Clock* clock_ = &SteadyClock::shared();
    SessionState state_;
    receive::Sample sample_;  ///< the one state_ was made from
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
    QVector<QLabel*> headings_;  ///< of the digital groups, by column and group
    QLineEdit* search_;
    NothingFound* nothing_ = nullptr;
    NoticeBar* notice_;

    struct Pending {
        bool wanted = false;
        std::int64_t sinceNs = 0;
    };
    QMap<int, Pending> pending_;
    std::pair<int, bool> unconfirmed_{-1, false};  ///< output of the notice, and the state that was asked for
};

}  // namespace tiller
