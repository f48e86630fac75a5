// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/io/io_tab.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <cmath>

#include "robot/receive/robot_state.h"
#include "robot/station/text/texts.h"
#include "widgets/common/bottom_overlay.h"
#include "widgets/common/empty_state.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/replay_band.h"
#include "widgets/io/analog_row.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/register_panel.h"

namespace tiller {
namespace {

/// Cause of the notice about an unconfirmed output.
constexpr char kUnconfirmed[] = "output";
/// Timeout for the confirmation by the robot [ns]. Afterwards, the output is no longer shown as pending.
constexpr std::int64_t kConfirmNs = 2 * kNsPerSecond;
constexpr int kRefreshMs = 50;

bool bit(std::uint64_t bits, int channel) {
    return ((bits >> channel) & 1U) != 0;
}

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("role", "caption");
    label->setContentsMargins(0, 10, 0, 4);
    return label;
}

}  // namespace

QString IoTab::terminal(bool output, int channel) {
    return ioTerminal(output, channel);
}

IoTab::IoTab(RobotSession& session, QWidget* parent)
    : QWidget(parent)
    , session_(session)
    , state_(session.state())
    , search_(new QLineEdit)
    , notice_(new NoticeBar) {
    setObjectName(QStringLiteral("io"));
    setAccessibleName(tr("Inputs and outputs"));
    setOutput_ = [this](int output, bool on) { session_.outputs().setDigitalOutput(output, on); };

    auto* page = new QWidget;
    page->setObjectName(QStringLiteral("io.page"));
    auto* lines = new QVBoxLayout(page);
    lines->setContentsMargins(12, 4, 12, 12);
    lines->setSpacing(0);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(16);
    columns->addWidget(buildColumn(false), 1);
    columns->addWidget(buildColumn(true), 1);
    lines->addLayout(columns);
    buildAnalog(lines);
    lines->addStretch();

    auto* scroll = new NoFocusScrollArea;
    scroll->setObjectName(QStringLiteral("io.scroll"));
    scroll->setAccessibleName(tr("Inputs and outputs"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(page);
    // Make the viewport transparent, so that the panel behind it is visible.
    scroll->viewport()->setAutoFillBackground(false);
    page->setAutoFillBackground(false);
    nothing_ = new EmptyState(*scroll);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    search_->setObjectName(QStringLiteral("io.search"));
    search_->setAccessibleName(tr("Search inputs and outputs"));
    search_->setPlaceholderText(tr("Search by terminal or name"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, &IoTab::search);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(12, 10, 12, 2);
    top->addWidget(search_);
    replayBand_ = new ReplayBand(QStringLiteral("io.replay"), scroll);
    connect(replayBand_, &ReplayBand::liveWanted, this, &IoTab::liveWanted);
    layout->addLayout(top);
    layout->addWidget(scroll, 1);
    // Place the band at the bottom, so that hiding it does not move a button under the pointer.
    layout->addWidget(replayBand_);
    notice_->setObjectName(QStringLiteral("io.notice"));
    new BottomOverlay(*notice_, *this, {scroll});

    refreshTimer_.setSingleShot(true);
    refreshTimer_.setInterval(kRefreshMs);
    connect(&refreshTimer_, &QTimer::timeout, this, &IoTab::refresh);
    connect(&session_, &RobotSession::linkBegan, this, [this] { sample_ = {}; });
    connect(&session_, &RobotSession::samplesReceived, this, [this](const SampleBatch& batch) {
        if (!batch.samples.empty()) {
            sample_ = batch.samples.back();
        }
    });
    connect(&session_, &RobotSession::stateChanged, this, [this](const SessionState& state) {
        state_ = state;
        if (!refreshTimer_.isActive()) {
            refreshTimer_.start();
        }
    });
    refresh();
}

QWidget* IoTab::buildColumn(bool output) {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    const QString headings[] = {output ? tr("Digital outputs") : tr("Digital inputs"),
                                output ? tr("Configurable outputs") : tr("Configurable inputs"),
                                output ? tr("Tool outputs") : tr("Tool inputs")};
    for (int channel = 0; channel < kChannels; ++channel) {
        if (channel % 8 == 0) {
            auto* heading = new QLabel(headings[channel / 8]);
            heading->setProperty("role", "caption");
            heading->setContentsMargins(0, 10, 0, 4);
            layout->addWidget(heading);
            headings_.append(heading);
        }
        const QString name = terminal(output, channel);
        auto* row = new IoChannel(name, output);
        row->setObjectName(QStringLiteral("io.") + QString(name).remove(QLatin1Char(' ')));
        layout->addWidget(row);
        (output ? outputs_ : inputs_).append(row);
        connect(row, &IoChannel::nameChanged, this, &IoTab::namesChanged);
        if (output) {
            connect(row, &QAbstractButton::clicked, this, [this, channel] { toggle(channel); });
            connect(row, &IoChannel::pulseRequested, this, [this, channel] { pulse(channel); });
        }
    }
    layout->addStretch();
    return column;
}

void IoTab::setReplay(const Replay& moment) {
    replay_ = moment;
    replayBand_->tell(moment ? moment->words() : QString());
    refresh();
}

void IoTab::toggle(int output) {
    if (state_.link != LinkState::Live || replay_) {
        return;
    }
    // Compare with the requested state, so that a second click reverts the first click.
    const auto asked = pending_.constFind(output);
    const bool now = asked != pending_.constEnd() ? asked->wanted : bit(state_.digitalOutputs, output);
    const QString what = QStringLiteral("%1: %2").arg(terminal(true, output), now ? tr("off") : tr("on"));
    if (!session_.asksBeforeChange(what, [this, output, now] { ask(output, !now); })) {
        ask(output, !now);
    }
}

void IoTab::ask(int output, bool on) {
    pending_[output] = {on, clock_->nowNs()};
    notice_->dismiss();
    setOutput_(output, on);
    refresh();
}

void IoTab::pulse(int output) {
    if (state_.link != LinkState::Live || replay_) {
        return;
    }
    if (const QString obstacle = session_.outputs().pulseObstacle(); !obstacle.isEmpty()) {
        notice_->show(NoticeBar::Kind::Warning, tr("%1 cannot be pulsed now").arg(terminal(true, output)),
                      obstacle);
        return;
    }
    notice_->dismiss();
    constexpr double kMsPerSecond = 1000;
    session_.outputs().pulseDigitalOutput(output, kPulseMs / kMsPerSecond);
}

void IoTab::focusSearch() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

void IoTab::showNoSelection() {
    session_.journal().add(Severity::Info, tr("Press the Tab key to select a row on the I/O tab first."));
}

int IoTab::chosenOutput() {
    if (replay_) {
        session_.journal().add(Severity::Warning, tr("Replay is active. Press “Back to live” first."));
        return -1;
    }
    for (int channel = 0; channel < kChannels; ++channel) {
        const IoChannel* row = outputs_[channel];
        // Use the focus widget of this window. QApplication::focusWidget() may be in the command list, which
        // can still be open.
        if (row != window()->focusWidget()) {
            continue;
        }
        if (!row->obstacle().isEmpty()) {
            session_.journal().add(Severity::Warning, row->obstacle());
            return -1;
        }
        return channel;
    }
    showNoSelection();
    return -1;
}

void IoTab::switchChosen() {
    if (const int output = chosenOutput(); output >= 0) {
        toggle(output);
    }
}

void IoTab::pulseChosen() {
    if (const int output = chosenOutput(); output >= 0) {
        pulse(output);
    }
}

void IoTab::renameChosen() {
    QWidget* focus = window()->focusWidget();
    if (auto* row = qobject_cast<IoChannel*>(focus)) {
        row->rename();
    } else if (auto* analog = qobject_cast<AnalogRow*>(focus)) {
        analog->askForName();
    } else {
        showNoSelection();
    }
}

void IoTab::search(const QString& text) {
    const QString wanted = text.trimmed();
    const auto matches = [&wanted](const QString& terminal, const QString& name) {
        return wanted.isEmpty() || terminal.contains(wanted, Qt::CaseInsensitive) ||
               name.contains(wanted, Qt::CaseInsensitive);
    };
    int heading = 0;
    bool found = false;
    for (const auto* rows : {&inputs_, &outputs_}) {
        for (int group = 0; group < 3; ++group, ++heading) {
            bool any = false;
            for (int channel = 8 * group; channel < std::min(8 * (group + 1), kChannels); ++channel) {
                IoChannel* row = rows->at(channel);
                row->setVisible(matches(row->terminal(), row->name()));
                any = any || matches(row->terminal(), row->name());
            }
            headings_[heading]->setVisible(any);
            found = found || any;
        }
    }
    bool any = false;
    for (const auto* rows : {&analogInputs_, &analogOutputs_}) {
        for (AnalogRow* row : *rows) {
            row->setVisible(matches(row->terminal(), row->name()));
            any = any || matches(row->terminal(), row->name());
        }
    }
    analogHeading_->setVisible(any);
    const bool registers = registers_->filter(wanted);
    registers_->setVisible(registers);
    registerHeading_->setVisible(registers);
    nothing_->tell(!found && !any && !registers, wanted);
}

void IoTab::refresh() {
    using State = IoChannel::State;
    registers_->setLock(state_.monitorOnly ? texts::monitorOnlyObstacle() : QString());
    // Past data are displayed like outdated data.
    const bool stale = state_.link != LinkState::Live || replay_;
    const bool known = replay_ ? !replay_->sample.isEmpty() : state_.hasData();
    const receive::RobotState then(replay_ ? replay_->sample : sample_);
    const std::uint64_t inputs = replay_ && known ? then.digitalInputs().value_or(0) : state_.digitalInputs;
    const std::uint64_t outputs =
        replay_ && known ? then.digitalOutputs().value_or(0) : state_.digitalOutputs;
    for (int channel = 0; channel < kChannels; ++channel) {
        IoChannel* in = inputs_[channel];
        in->setStale(stale);
        in->setState(!known ? State::Unknown : bit(inputs, channel) ? State::On : State::Off);

        IoChannel* out = outputs_[channel];
        const bool on = bit(outputs, channel);
        const auto asked = pending_.find(channel);
        bool pending = asked != pending_.end() && !replay_;
        if (pending && (asked->wanted == on || stale)) {
            pending_.erase(asked);
            pending = false;
        } else if (pending && clock_->nowNs() - asked->sinceNs > kConfirmNs) {
            const bool wanted = asked->wanted;
            pending_.erase(asked);
            pending = false;
            notice_->show(NoticeBar::Kind::Warning,
                          {.title = tr("The robot did not confirm %1").arg(out->accessibleName()),
                           .text = tr("Another program or the installation may control the output. Check "
                                      "both, then switch the output again."),
                           .cause = QLatin1String(kUnconfirmed)});
            unconfirmed_ = {channel, wanted};
        } else if (unconfirmed_.first == channel && (stale || unconfirmed_.second == on)) {
            // The robot has confirmed the output late, or the state of the output is unknown.
            unconfirmed_ = {-1, false};
            notice_->resolve(QLatin1String(kUnconfirmed));
        }
        out->setStale(stale);
        if (state_.monitorOnly) {
            out->setObstacle(texts::monitorOnlyObstacle(), tr("locked"));
        } else {
            out->setObstacle(stale ? QString() : session_.outputs().holders().digital(channel),
                             tr("controlled by another program"));
        }
        out->setState(!known    ? State::Unknown
                      : pending ? (on ? State::PendingOff : State::PendingOn)
                      : on      ? State::On
                                : State::Off);
    }
    refreshAnalog(known, stale);
}

QMap<QString, QString> IoTab::names() const {
    QMap<QString, QString> result;
    for (const auto* rows : {&inputs_, &outputs_}) {
        for (const IoChannel* row : *rows) {
            if (!row->name().isEmpty()) {
                result[row->terminal()] = row->name();
            }
        }
    }
    for (const auto* rows : {&analogInputs_, &analogOutputs_}) {
        for (const AnalogRow* row : *rows) {
            if (!row->name().isEmpty()) {
                result[row->terminal()] = row->name();
            }
            if (row->scale().isSet()) {
                result[row->terminal() + QStringLiteral(" scale")] = row->scale().toText();
            }
        }
    }
    return result;
}

void IoTab::setNames(const QMap<QString, QString>& names) {
    for (const auto* rows : {&inputs_, &outputs_}) {
        for (IoChannel* row : *rows) {
            row->setName(names.value(row->terminal()));
        }
    }
    for (const auto* rows : {&analogInputs_, &analogOutputs_}) {
        for (AnalogRow* row : *rows) {
            row->setName(names.value(row->terminal()));
            row->setScale(AnalogScale::fromText(names.value(row->terminal() + QStringLiteral(" scale"))));
        }
    }
}

void IoTab::buildAnalog(QVBoxLayout* layout) {
    analogHeading_ = heading(tr("Analog"));
    layout->addWidget(analogHeading_);
    const auto add = [this, layout](const QString& terminal, bool output) {
        auto* row = new AnalogRow(terminal, output);
        row->setObjectName(QStringLiteral("io.") + QString(terminal).remove(QLatin1Char(' ')));
        layout->addWidget(row);
        (output ? analogOutputs_ : analogInputs_).append(row);
        connect(row, &AnalogRow::changed, this, &IoTab::namesChanged);
        return row;
    };
    for (const char* terminal : {"AI 0", "AI 1", "TAI 0", "TAI 1"}) {
        add(QLatin1String(terminal), false);
    }
    for (int channel = 0; channel < 2; ++channel) {
        connect(add(QStringLiteral("AO %1").arg(channel), true), &AnalogRow::setRequested, this,
                [this, channel](io::AnalogDomain domain, double level) {
                    const auto set = [this, channel, domain, level] {
                        session_.outputs().setAnalogOutput(channel, domain, level);
                    };
                    if (!session_.asksBeforeChange(QStringLiteral("AO %1").arg(channel), set)) {
                        set();
                    }
                });
    }
    registerHeading_ = heading(tr("General purpose registers"));
    layout->addWidget(registerHeading_);
    registers_ = new RegisterPanel;
    layout->addWidget(registers_);
    connect(registers_, &RegisterPanel::writeRequested, this, [this](const RegisterValue& value) {
        const auto set = [this, value] { session_.outputs().setRegister(value); };
        if (!session_.asksBeforeChange(RobotOutputs::registerName(value), set)) {
            set();
        }
    });
}

void IoTab::refreshAnalog(bool known, bool stale) {
    const receive::Sample& shown = replay_ ? replay_->sample : sample_;
    registers_->setEnabled(!replay_);
    if (!known || shown.isEmpty()) {
        for (const auto* rows : {&analogInputs_, &analogOutputs_}) {
            for (AnalogRow* row : *rows) {
                row->setValue(0, io::AnalogDomain::Current, false, true);
            }
        }
        registers_->showNothing();
        return;
    }
    const receive::RobotState robot(shown);
    const std::uint32_t types = robot.analogIoTypes().value_or(0);
    const auto domain = [types](int bit) {
        return (types >> bit & 1U) != 0 ? io::AnalogDomain::Voltage : io::AnalogDomain::Current;
    };
    for (int channel = 0; channel < 2; ++channel) {
        analogInputs_[channel]->setValue(robot.analogInput(channel), domain(channel),
                                         !std::isnan(robot.analogInput(channel)), stale);
        // Tool inputs are assumed to be voltages, because the robot does not report their configuration.
        const std::string field = "tool_analog_input" + std::to_string(channel);
        analogInputs_[2 + channel]->setValue(robot.number(field), io::AnalogDomain::Voltage, robot.has(field),
                                             stale);
        analogOutputs_[channel]->setValue(robot.analogOutput(channel), domain(2 + channel),
                                          !std::isnan(robot.analogOutput(channel)), stale);
        analogOutputs_[channel]->setObstacle(
            replay_              ? tr("Replay is active. Press “Back to live” first.")
            : state_.monitorOnly ? texts::monitorOnlyObstacle()
            : stale              ? tr("The robot is not sending data. Wait for data, or reconnect.")
                                 : session_.outputs().holders().analog);
    }
    registers_->show(robot, stale);
}

}  // namespace tiller

#include "moc_io_tab.cpp"
